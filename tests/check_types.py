#!/usr/bin/env python3
"""The Python of this repository bears its types: mypy finds nothing, and every function says what it takes and gives. Of the tests, their
helpers and checks are held, not the test functions."""
import ast
import os
import pathlib
import subprocess
import sys
import tempfile
from collections.abc import Iterator

from pinned_tools import pinned_tool

PACKAGES = ("report",)
#: Scripts import one another by their bare names, so no two of them have the same.
SCRIPTS = ("docs/generate/*.py", "examples/*/*.py", "tests/check_*.py", "tests/pinned_tools.py", "tests/tidy_*.py", "tests/skipped.py",
           "tests/package/debian_root.py", "tests/app/checkpoints.py", "tests/app/command.py", "tests/app/exported.py",
           "tests/app/stand_in_fe.py", "tests/benchmarks/runs.py", "tests/docs/code_of.py", "tests/docs/run_pages.py", "tests/hard_cases/solid/checks.py",
           "tests/report/s*.py", "tests/verification/kept_run.py")
LEAST = 140  #: files; fewer means that they were not found


def bare(file: pathlib.Path) -> Iterator[str]:
    """Functions whose result or an argument has no type."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            given = [a for a in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg) if a is not None]
            if node.returns is None or any(a.annotation is None and a.arg not in ("self", "cls") for a in given):
                yield f"{file}:{node.lineno}: {node.name} has no types"


def judged(root: pathlib.Path, mypy: str, cache: str, words: list[str], folders: set[pathlib.Path]) -> str:
    """What mypy says, the modules of the folders being imported by their bare names."""
    path = os.pathsep.join(map(str, [*sorted(folders), root]))
    said = subprocess.run([mypy, "--cache-dir", cache, *words], cwd=root, capture_output=True, text=True, env={**os.environ, "MYPYPATH": path})
    return "" if said.returncode == 0 else said.stdout + said.stderr


def main(folder: str) -> int:
    root = pathlib.Path(folder).resolve()
    found = {pattern: sorted(root.glob(pattern)) for pattern in SCRIPTS}
    scripts = [file for some in found.values() for file in some]
    files = [file for package in PACKAGES for file in sorted((root / package).rglob("*.py"))] + scripts
    faults = [fault for file in files for fault in bare(file)] + [f"{pattern}: no such files" for pattern, some in found.items() if not some]
    if faults or len(files) < LEAST:
        print("\n".join(faults) or f"only {len(files)} files found")
        return 1
    mypy = pinned_tool(root, "mypy")
    with tempfile.TemporaryDirectory() as cache:
        said = judged(root, mypy, cache, [word for package in PACKAGES for word in ("--package", package)], set())
        said += judged(root, mypy, cache, [str(file.relative_to(root)) for file in scripts], {file.parent for file in scripts})
    print(said or f"mypy finds nothing in {len(files)} files")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
