#!/usr/bin/env python3
"""Choices are values, not strings. A word of a table (io/files/choice.h), or the name of an impact law, is compared with a literal at an edge
alone: where a file, a table or the command line is read. Everywhere else the enumeration is compared."""
import pathlib
import re
import sys
from collections.abc import Iterator

TABLE = re.compile(r"choices_of<\w+>\(\s*\{(.*?)\}\s*\)\s*;", re.DOTALL)
LINE = re.compile(r'\{\s*[\w:]+\s*,\s*"([^"]*)"')
LAW = re.compile(r'(?:\.name = |pair_law\()"([a-z-]+)"')
COMPARED = re.compile(r'[!=]=\s*"([^"]*)"|"([^"]*)"\s*[!=]=|\bcompare\("([^"]*)"\)')
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|(R"(\w*)\(.*?\)\2")|("(?:\\.|[^"\\\n])*")', re.DOTALL)
NO_SOURCES = ("tests", "build", "results")
LEAST_FILES, LEAST_TABLES, LEAST_WORDS, LEAST_LAWS = 300, 25, 70, 6  #: fewer means that they were not found

#: Where a word is read, or is a key's or a column's name: file and word.
EDGES = {
    ("app/verbs/calibrate_options.cc", "none"),  # the command line: --laws all | none
    ("studies/fleets/sweep.cc", "record"),  # a column
}


def without_comments(text: str) -> str:
    """The text with its comments blanked, line by line; strings stay."""
    return COMMENT.sub(lambda found: found.group(0) if found.group(1) or found.group(3) else re.sub(r"[^\n]", " ", found.group(0)), text)


def words_of(text: str) -> set[str]:
    return {word for table in TABLE.findall(text) for word in LINE.findall("{" + table + "}")}


def comparisons(text: str, words: set[str]) -> Iterator[tuple[int, str]]:
    """Line and word of every comparison with one of the words."""
    text = without_comments(text)
    for found in COMPARED.finditer(text):
        word = next(group for group in found.groups() if group is not None)
        if word in words:
            yield text.count("\n", 0, found.start()) + 1, word


def can_fail() -> bool:
    """The check sees what it is for, and nothing in a comment or in a sentence."""
    table = 'return choices_of<Rung>(\n    {{rim, "rim"}, {Rung::full, "full", "all of it"}});'
    words = words_of(table)
    seen = list(comparisons('// rung == "rim"\nif (rung == "full" || "rim" != rung || rung == "other")\n  say("rung == rim");', words))
    return words == {"rim", "full"} and seen == [(2, "full"), (2, "rim")]


def main(root: str) -> int:
    if not can_fail():
        print("the check does not see a comparison that it is shown")
        return 1
    top = pathlib.Path(root)
    sources = {str(file.relative_to(top)): file.read_text(encoding="utf-8") for file in sorted(top.rglob("*"))
               if file.suffix in (".cc", ".h") and file.relative_to(top).parts[0] not in NO_SOURCES}
    tables = sum(len(TABLE.findall(text)) for text in sources.values())
    words = {word for text in sources.values() for word in words_of(text)}
    laws = {law for name, text in sources.items() if name.startswith("laws/impact/") for law in LAW.findall(text)}
    if len(sources) < LEAST_FILES or tables < LEAST_TABLES or len(words) < LEAST_WORDS or len(laws) < LEAST_LAWS:
        print(f"only {len(sources)} sources, {tables} tables, {len(words)} words and {len(laws)} laws found")
        return 1
    faults, used = [], set[tuple[str, str]]()
    for name, text in sources.items():
        for line, word in comparisons(text, words | laws):
            if (name, word) in EDGES:
                used.add((name, word))
            else:
                faults.append(f'{name}:{line}: compares with "{word}"; compare the enumeration, and parse where the word is read')
    faults += [f"{left}: compares so no more; strike it from the list" for left in sorted(map(str, EDGES - used))]
    print("\n".join(faults) if faults else f"{len(sources)} sources compare none of {len(words)} words of {tables} tables with a literal")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
