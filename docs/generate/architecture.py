#!/usr/bin/env python3
"""Draws docs/pictures/architecture.svg from the tables of tests/check_includes.py; --check compares."""
import pathlib
import sys

from figures import Drawing
from write_or_compare import write_or_compare

ROOT = pathlib.Path(__file__).resolve().parents[2]
Graph = dict[str, set[str]]
Places = dict[str, tuple[float, float]]


def folders() -> Graph:
    """{folder: folders it may include}, rooms of calibration and fe_contact taken as one."""
    sys.path.insert(0, str(ROOT / "tests"))
    from check_includes import MAY_INCLUDE
    result: Graph = {}
    for name, others in MAY_INCLUDE.items():
        top = name.split("/")[0]
        result.setdefault(top, set()).update(other.split("/")[0] for other in others)
        result[top].discard(top)
    return result


def reduced(graph: Graph) -> Graph:
    """The same order with fewest arrows: what is reached through another folder is left out."""
    def reach(name: str) -> set[str]:
        seen, todo = set[str](), list(graph.get(name, ()))
        while todo:
            each = todo.pop()
            if each not in seen:
                seen.add(each)
                todo += graph.get(each, ())
        return seen
    return {name: {other for other in others if not any(other in reach(third) for third in others - {other})}
            for name, others in graph.items()}


def rows_of(graph: Graph) -> list[list[str]]:
    """Folders by how many arrows lie below them."""
    depth: dict[str, int] = {}

    def depth_of(name: str) -> int:
        if name not in depth:
            depth[name] = 1 + max((depth_of(other) for other in graph[name]), default=-1)
        return depth[name]
    return [[name for name in graph if depth_of(name) == level] for level in range(1 + max(map(depth_of, graph)))]


def faults(graph: Graph, at: Places) -> float:
    """Arrows through other folders' boxes, which count most, and the arrows' lengths."""
    total = 0.0
    for name, others in graph.items():
        for other in others:
            (x1, y1), (x2, y2) = at[name], at[other]
            total += abs(x1 - x2)
            total += sum(1e4 for box, (x, y) in at.items() if y2 < y < y1 and abs(x1 + (x2 - x1) * (y - y1) / (y2 - y1) - x) < 24 + 4.1 * len(box))
    return total


def places(graph: Graph, rows: list[list[str]], width: int, step: int) -> Places:
    """{folder: (x, y)}: rows apart by `step`; along them folders are moved and changed about for as long as that makes fewer faults."""
    at: Places = {name: (width * (i + 1) / (len(row) + 1), step * level) for level, row in enumerate(rows) for i, name in enumerate(row)}
    better = True
    while better:
        better = False
        for row in rows:
            for name in row:
                for x in range(70, width - 60, 20):
                    trial: Places = {**at, name: (x, at[name][1])}
                    near = [other for other in row if other != name and abs(at[other][0] - x) < 120]
                    if len(near) == 1:
                        trial[near[0]] = at[name]
                    if all(abs(trial[a][0] - trial[b][0]) >= 120 for a in row for b in row if a < b) and faults(graph, trial) < faults(graph, at) - 1e-6:
                        at, better = trial, True
    return at


def picture() -> str:
    graph = reduced(folders())
    rows = rows_of(graph)
    step, width = 62, 720
    drawing = Drawing(width, step * len(rows), 1.0, (0, step * len(rows) - 34))
    at = places(graph, rows, width, step)
    for name, others in graph.items():
        for other in sorted(others):
            drawing.arrow((at[name][0], at[name][1] - 14), (at[other][0], at[other][1] + 15), "#777", 1.1)
    for name, (x, y) in at.items():
        half = 8 + 4.1 * len(name)
        drawing.path([(x - half, y - 14), (x + half, y - 14), (x + half, y + 14), (x - half, y + 14)], "#eef3f7", closed=True)
        drawing.text(x, y, name, shift=(0, 5))
    return drawing.svg("Folders and what each may include")


def main(*options: str) -> int:
    made = {ROOT / "docs/pictures/architecture.svg": picture()}
    return write_or_compare(made, options, "tests/check_includes.py says; run docs/generate/architecture.py")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
