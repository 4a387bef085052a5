"""Sentences of the program as a client's page has them: three figures, no codes, and those of one kind as one line."""
import json
import pathlib
import re
from collections.abc import Sequence

from .numbers import sig

ALIKE = json.loads((pathlib.Path(__file__).resolve().parents[1] / "data" / "words" / "alike.json").read_text(encoding="utf-8"))

CODES = re.compile(r"\s*\((?=[^()]*\b[0-9a-f]{16}\b)[^()]*\)|(?<=\brim) [0-9a-f]{16}\b")
DECIMAL = re.compile(r"(?<![^\s(=<>~±+−-])(?<!\w[-−+])\d+\.\d+(?![\w.]\w|\w)")
FRONT, NAMED, NUMBER = (re.compile(ALIKE[key]) for key in ("name_in_front", "named", "number"))


def for_page(sentence: str) -> str:
    """Numbers with a point and more than three figures are rounded; the codes that tell rims apart are left out."""
    return DECIMAL.sub(_rounded, CODES.sub("", sentence))


def _rounded(found: re.Match[str]) -> str:
    text = found[0]
    return text if len(text.replace(".", "").lstrip("0")) <= 3 else sig(float(text), 3)


def _apart(sentence: str) -> str:
    """Without the run's name in front and the names within."""
    return NAMED.sub(r"\1NAME", FRONT.sub("", sentence.replace("−", "-")))


def kind_of(sentence: str) -> str:
    """What sentences have in common that differ in a run's name and in numbers alone (data/words/alike.json)."""
    return NUMBER.sub("#", _apart(sentence))


def worst_of(sentences: Sequence[str]) -> int:
    """Place of the one whose first differing number is largest in size."""
    sizes = [[abs(float(found[0])) for found in NUMBER.finditer(_apart(s))] for s in sentences]
    return max(range(len(sentences)), key=lambda place: (sizes[place], -place))
