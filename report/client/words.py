"""The words of the client's pages: words.csv, a row a word, a column a language."""
import csv
import functools
import os
import re

from ..errors import InputError
from ..numbers import NARROW

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "words.csv")
LANGUAGES = ("en", "es", "it", "ja", "tr")
COMMA = ("es", "it", "tr")  #: decimals follow a comma there
BETWEEN_DIGITS = re.compile(r"(?<=\d)\.(?=\d)")


@functools.cache
def table() -> dict[str, dict[str, str]]:
    """By key, then by language."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {row["key"]: row for row in csv.DictReader(file)}


class Words:
    """One language's words and way of writing numbers."""

    def __init__(self, language: str) -> None:
        if language not in LANGUAGES:
            raise InputError(f'language "{language}" is not known; known are {", ".join(LANGUAGES)}')
        self.language = language

    def __call__(self, key: str) -> str:
        return table()[key][self.language]

    def has(self, key: str) -> bool:
        return key in table()

    def number(self, text: str) -> str:
        """A number, or several, as the language writes decimals; everything else stays."""
        return BETWEEN_DIGITS.sub(",", text) if self.language in COMMA else text


def figures_of(text: str) -> list[str]:
    """Every number of a text, however its language writes it: for tests that hold pages against each other."""
    plain = text.replace(NARROW, "").replace("\u00a0", " ")
    return [found.replace(",", ".") for found in re.findall(r"\d+(?:[.,]\d+)?", plain)]
