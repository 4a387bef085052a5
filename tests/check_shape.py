#!/usr/bin/env python3
"""Counts what makes a source hard to find one's way in, and fails where a count has grown: sources without a header of
their own, functions over 40 lines. Prints them, with the lines of fe_contact, which have no limit. Programs (*main*.cc),
the values that a catalogue names (CATALOGUED) and a header's forms for the two programs (_fe, _light) have their header.

    check_shape.py ROOT [--list]   --list: each of them"""
import pathlib
import re
import sys
from collections.abc import Iterator

LONG = 40  #: lines of a function
MOST = {"sources without a header of their own": 8, "functions over 40 lines": 16}  #: today's counts: lower them with the counts
CATALOGUED = ("app/verbs/verb_*.cc", "io/records/record_*.cc")  #: declared by app/verbs/catalogue.h, io/records/record.h
NO_FUNCTION = re.compile(r"^(?:namespace|struct|class|enum|union|extern|template <|using|#|//|/\*|\}|constexpr \w+ \w+\[|const \w+ \w+\[|static const)")


def sources(root: pathlib.Path) -> list[pathlib.Path]:
    rooms = [folder for folder in root.iterdir() if folder.is_dir() and folder.name not in ("build", "results", "tests", "examples", "data")]
    return sorted(file for room in rooms for file in room.rglob("*.cc"))


def functions(text: str) -> Iterator[tuple[str, int]]:
    """Definitions at the margin, as clang-format leaves them: first line and number of lines."""
    lines = text.splitlines()
    start = None
    for number, line in enumerate(lines):
        if start is None and line.endswith("{") and not line.startswith(" ") and not NO_FUNCTION.match(line):
            start = number
        elif start is not None and line.startswith("}"):
            yield lines[start], number - start + 1
            start = None


def has_header(file: pathlib.Path, root: pathlib.Path) -> bool:
    name = re.sub(r"_(?:fe|light)$", "", file.stem)
    return (file.with_name(f"{name}.h").exists() or "main" in file.stem.split("_")
            or any(file.relative_to(root).match(pattern) for pattern in CATALOGUED))


def main(root: pathlib.Path, listed: bool) -> int:
    found: dict[str, list[str]] = {what: [] for what in MOST}
    headerless, long = found.values()
    for file in sources(root):
        name = str(file.relative_to(root))
        if not has_header(file, root):
            headerless.append(name)
        long += [f"{name}: {lines} lines: {head}" for head, lines in functions(file.read_text(encoding="utf-8")) if lines > LONG]
    code = 0
    for what, names in found.items():
        print(f"{len(names)} {what}, at most {MOST[what]}")
        if listed or len(names) > MOST[what]:
            print("\n".join(f"  {name}" for name in names))
        code |= len(names) > MOST[what]
    lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for end in ("*.h", "*.cc") for file in (root / "fe_contact").rglob(end)
                if "planning" not in file.parts)
    print(f"{lines} lines in fe_contact without its planning")
    return code


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), "--list" in sys.argv))
