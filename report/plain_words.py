"""Sentences of the program as a client's page has them: three figures, no codes, and those of one kind as one line."""
import re
from collections.abc import Sequence

from .numbers import sig

CODES = re.compile(r"\s*\((?=[^()]*\b[0-9a-f]{16}\b)[^()]*\)|(?<=\brim) [0-9a-f]{16}\b")
DECIMAL = re.compile(r"(?<![^\s(=<>~±+−-])(?<!\w[-−+])\d+\.\d+(?![\w.]\w|\w)")
NAME = re.compile(r"(^|\s)[A-Za-z]\S*\d\S*")
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def for_page(sentence: str) -> str:
    """Numbers with a point and more than three figures are rounded; the codes that tell rims apart are left out."""
    return DECIMAL.sub(_rounded, CODES.sub("", sentence))


def _rounded(found: re.Match[str]) -> str:
    text = found[0]
    return text if len(text.replace(".", "").lstrip("0")) <= 3 else sig(float(text), 3)


def _without_name(sentence: str) -> str:
    """Without the run's name in front: one word and a colon."""
    name, colon, rest = sentence.partition(": ")
    return rest if colon and " " not in name else sentence


def kind_of(sentence: str) -> str:
    """What sentences have in common that differ in a run's name and in numbers alone; as calibration/answer/said_once.cc has it."""
    return NUMBER.sub("#", NAME.sub(r"\1NAME", _without_name(sentence)))


def worst_of(sentences: Sequence[str]) -> int:
    """Place of the one whose first differing number is largest in size."""
    sizes = [[abs(float(n.replace("−", "-"))) for n in NUMBER.findall(NAME.sub(r"\1NAME", _without_name(s)))] for s in sentences]
    return max(range(len(sentences)), key=lambda place: (sizes[place], -place))
