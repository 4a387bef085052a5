#!/usr/bin/env python3
"""Writes the figure of docs/architecture.md from the tables of tests/check_includes.py, between its two marks; --check compares."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BEGIN, END = "<!-- figure: made by docs/generate/architecture.py -->\n", "<!-- end of figure -->"


def folders():
    """{folder: folders it may include}, rooms of calibration and fe_contact taken as one."""
    sys.path.insert(0, str(ROOT / "tests"))
    from check_includes import MAY_INCLUDE
    result = {}
    for name, others in MAY_INCLUDE.items():
        top = name.split("/")[0]
        result.setdefault(top, set()).update(other.split("/")[0] for other in others)
        result[top].discard(top)
    return result


def reduced(graph):
    """The same order with fewest arrows: what is reached through another folder is left out."""
    def reach(name):
        seen, todo = set(), list(graph.get(name, ()))
        while todo:
            each = todo.pop()
            if each not in seen:
                seen.add(each)
                todo += graph.get(each, ())
        return seen
    return {name: {other for other in others if not any(other in reach(third) for third in others - {other})}
            for name, others in graph.items()}


def figure():
    lines = ["```mermaid", "flowchart BT"]
    for name, others in reduced(folders()).items():
        lines += [f"  {name}[{name}/]"] + [f"  {name} --> {other}" for other in sorted(others)]
    return BEGIN + "\n".join(lines) + "\n```\n"


def main(*options):
    page = ROOT / "docs" / "architecture.md"
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    made = before + figure() + END + rest.split(END)[1]
    if "--check" in options:
        if made != text:
            print("the figure of docs/architecture.md is not that of tests/check_includes.py; run docs/generate/architecture.py")
        return 0 if made == text else 1
    page.write_text(made, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
