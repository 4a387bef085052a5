#!/usr/bin/env python3
"""The Python of the reports bears its types: mypy finds nothing, and every function says what it takes and gives."""
import ast
import pathlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator

SKIPPED = 77
PACKAGES = ("report",)
LEAST = 100  #: files; fewer means that they were not found


def bare(file: pathlib.Path) -> Iterator[str]:
    """Functions whose result or an argument has no type."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            given = [a for a in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg) if a is not None]
            if node.returns is None or any(a.annotation is None and a.arg not in ("self", "cls") for a in given):
                yield f"{file}:{node.lineno}: {node.name} has no types"


def main(root: str) -> int:
    files = [file for package in PACKAGES for file in sorted((pathlib.Path(root) / package).rglob("*.py"))]
    faults = [fault for file in files for fault in bare(file)]
    if faults or len(files) < LEAST:
        print("\n".join(faults) or f"only {len(files)} files found")
        return 1
    if not shutil.which("mypy"):
        print(f"{len(files)} files say their types; mypy is not here to judge them")
        return SKIPPED
    with tempfile.TemporaryDirectory() as cache:
        words = [word for package in PACKAGES for word in ("--package", package)]
        said = subprocess.run(["mypy", "--cache-dir", cache, *words], cwd=root, capture_output=True, text=True)
    print(said.stdout + said.stderr)
    return 1 if said.returncode else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
