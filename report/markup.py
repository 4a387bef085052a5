"""Sentences of the program as HTML: subscripts, code in backticks, plus-minus, exponents. Everything is escaped first."""
import re

from markupsafe import Markup, escape

RULES = (
    (re.compile(r"\+/?-"), "±"),
    (re.compile(r"(?<![\w.&])([A-Za-zΔμ])_([a-z]{1,3})(?![\w])"), r"<i>\1</i><sub>\2</sub>"),
    (re.compile(r"\^([−-]?\d+(?:\.\d+)?)"), r"<sup>\1</sup>"),
)


def sentence(value: str) -> Markup:
    """What stands between backticks is code and keeps its signs."""
    if isinstance(value, Markup):
        return value
    parts = str(escape(value)).split("`")
    if len(parts) % 2 == 0:  # a backtick without its pair is only a sign
        parts[-2:] = ["`".join(parts[-2:])]
    return Markup("".join(f"<code>{part}</code>" if i % 2 else _running(part) for i, part in enumerate(parts)))


def _running(part: str) -> str:
    for pattern, replacement in RULES:
        part = pattern.sub(replacement, part)
    return part
