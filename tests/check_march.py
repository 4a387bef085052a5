#!/usr/bin/env python3
"""Checks that `march` is the only loop of fe_contact that makes steps and may cut and retry them: no other loop there calls a
step, and none but it calls an attempt."""
import pathlib
import re
import sys

from check_values import without_comments

LOOP = re.compile(r"\b(?:for|while|do)\b\s*[({]")
STEP = re.compile(r"\b(?:time_step|static_step|motion_step|move_to|attempt)\s*\(")
RETRIES = "fe_contact/solver/march.cc"


def closing(text: str, start: int) -> int:
    """Behind the bracket that closes the one at `start`."""
    depth = 0
    for k in range(start, len(text)):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(text[k], 0)
        if depth == 0:
            return k + 1
    return len(text)


def loop_at(text: str, found: re.Match) -> str:
    """A loop's head and body."""
    end = closing(text, found.end() - 1)
    rest = text[end:].lstrip()
    if rest.startswith("{"):
        return text[found.start():closing(text, text.index("{", end))]
    return text[found.start():text.find(";", end) + 1]


def main(root: str) -> int:
    faults, seen = [], set()
    for file in sorted(pathlib.Path(root, "fe_contact").rglob("*.cc")):
        name, text = str(file.relative_to(root)), without_comments(file.read_text(encoding="utf-8"))
        for found in LOOP.finditer(text):
            if not STEP.search(loop_at(text, found)):
                continue
            seen.add(name)
            if name != RETRIES:
                line = text.count("\n", 0, found.start()) + 1
                faults.append(f"{name}:{line}: a loop makes steps here; march cuts and retries them, and nothing else does")
    faults += [f"{RETRIES}: makes no steps in a loop any more"] if RETRIES not in seen else []
    print("\n".join(faults) if faults else "march alone makes steps in a loop")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
