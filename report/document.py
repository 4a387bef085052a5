"""Whose report it is: title, client, project, author; from the command line, a TOML file, or main.json, in this order."""
import datetime
import difflib
import tomllib
from dataclasses import dataclass
from typing import Any

from .errors import InputError

KEYS = ("title", "client", "project", "author")


@dataclass
class Document:
    title: str = ""
    client: str = ""
    project: str = ""
    author: str = ""

    def or_else(self, other: "Document") -> "Document":
        return Document(*(getattr(self, key) or getattr(other, key) for key in KEYS))


def of(table: dict[str, Any]) -> Document:
    return Document(*(table.get(key) or "" for key in KEYS))


def read(path: str) -> Document:
    """Throws InputError: the file is the user's own."""
    try:
        with open(path, "rb") as file:
            table = tomllib.load(file)
    except OSError as error:
        raise InputError(f"cannot read {path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"{path} is not readable TOML ({error})") from None
    for key, value in table.items():
        if key not in KEYS:
            near = difflib.get_close_matches(key, KEYS, 1)
            raise InputError(f"{path}: unknown key \"{key}\"; " + (f"did you mean \"{near[0]}\"?" if near else f"known: {', '.join(KEYS)}"))
        if not isinstance(value, str):
            raise InputError(f"{path}: {key} must be a text, got {value!r}")
    return of(table)


def today_as_number() -> str:
    """Read alike in every language: 2026-11-28."""
    return datetime.date.today().isoformat()


def today() -> str:
    return datetime.date.today().strftime("%-d %B %Y")
