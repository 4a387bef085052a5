#!/usr/bin/env python3
"""Checks that no source and no page has a word that CONTRIBUTING.md's second table of words bans, alone or as part of a name."""
import pathlib
import re
import sys

ROOMS = ("app", "buildings", "calibration", "fe_contact", "io", "laws", "meshes", "python", "reduced_models", "report", "responses", "scene", "studies", "tests",
         "docs", "examples", "README.md")
LEAST = 12  #: words; fewer means that the table was not found


def banned(page: str) -> list[str]:
    rows = re.findall(r"^\| (`[^|]+) \|", page.split("| not | but |")[1], re.MULTILINE)
    return [word for row in rows for word in re.findall(r"`(\w+)`", row)]


def main(root: pathlib.Path) -> int:
    words = banned((root / "CONTRIBUTING.md").read_text(encoding="utf-8"))
    if len(words) < LEAST:
        print(f"only {len(words)} banned words found")
        return 1
    parts = re.compile(r"(?<![A-Za-z])(?:" + "|".join(words) + r")(?![A-Za-z])", re.IGNORECASE)
    if not parts.search("what_is_Dearer(x)") or parts.search("endear"):
        print("the check does not see a word that it is shown")
        return 1
    faults, n = [], 0
    for room in ROOMS:
        for file in [root / room, *sorted((root / room).rglob("*"))]:
            if file.suffix not in (".h", ".cc", ".py", ".md") or not file.is_file() or file == pathlib.Path(__file__).resolve():
                continue
            n += 1
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                faults += [f"{file.relative_to(root)}:{number}: {word.group(0)}" for word in parts.finditer(line)]
    print("\n".join(faults) if faults else f"none of {n} files has one of {len(words)} banned words")
    return 1 if faults or n < 500 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
