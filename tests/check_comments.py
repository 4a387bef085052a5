#!/usr/bin/env python3
"""Checks that no sentence of a comment is longer than 30 words. Formulas, tables and what is indented behind the slashes are none."""
import pathlib
import re
import sys
from collections.abc import Iterator

MOST = 30
FORMULA = re.compile(r"[=|{}<>]|\d\)")
ENDS = re.compile(r"(?<=[.!?])\s+|(?<=[;:])\s+")
WORD = re.compile(r"[A-Za-z][\w'/-]*")
LINE = re.compile(r"\s*//+<? ?(.*)$")
BEHIND = re.compile(r"\s//+<? (.*)$")
STRING = re.compile(r'"(\\.|[^"\\])*"')
NO_SOURCES = ("build", "results")
LEAST = 5000  #: sentences; fewer means that they were not found


def paragraphs(text: str) -> Iterator[tuple[int, str]]:
    """Line and text of what stands together in comments."""
    start, lines, inside, was_behind = 0, list[str](), False, False
    for number, line in enumerate([*text.split("\n"), ""], 1):
        whole, behind = LINE.match(line), BEHIND.search(STRING.sub('""', line))
        words = whole.group(1) if whole else behind.group(1) if behind else ""
        of_the_next = bool(whole) and was_behind and re.match(r"\s*/// ", line)  # documents what it stands above
        goes_on = whole and inside and not of_the_next and words.strip() and not words.startswith("  ") and "   " not in words
        if not goes_on and lines:
            yield start, " ".join(lines)
            lines = []
        if words.strip() and not words.startswith("  ") and "   " not in words:
            start = start if lines else number
            lines.append(words.strip())
        inside, was_behind = bool(whole or behind), bool(behind and not whole)
    if lines:
        yield start, " ".join(lines)


def sentences(text: str) -> Iterator[tuple[int, str]]:
    for line, paragraph in paragraphs(text):
        for sentence in ENDS.split(paragraph):
            if not FORMULA.search(sentence):
                yield line, sentence


def can_fail() -> bool:
    words = " ".join(["word"] * (MOST + 1))
    seen = [len(WORD.findall(sentence)) for _, sentence in sentences(f"int x; /// {words}. Short.\n/// y = {words}\n")]
    return seen == [MOST + 1, 1]


def main(root: str) -> int:
    if not can_fail():
        print("the check does not see a sentence that it is shown")
        return 1
    faults, total = [], 0
    for file in sorted(pathlib.Path(root).rglob("*")):
        if file.suffix not in (".h", ".cc") or file.relative_to(root).parts[0] in NO_SOURCES:
            continue
        for line, sentence in sentences(file.read_text(encoding="utf-8")):
            total += 1
            if len(WORD.findall(sentence)) > MOST:
                faults.append(f"{file.relative_to(root)}:{line}: more than {MOST} words: {sentence[:80]} ...")
    if total < LEAST:
        faults.append(f"only {total} sentences found")
    print("\n".join(faults) if faults else f"none of {total} sentences is longer than {MOST} words")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
