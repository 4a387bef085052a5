#!/usr/bin/env python3
"""The pinned ruff finds nothing in the Python of this repository, by the rules that pyproject.toml chooses."""
import pathlib
import subprocess
import sys

from pinned_tools import pinned_tool

LEAST = 200  #: files; fewer means that they were not found


def main(folder: str) -> int:
    root = pathlib.Path(folder).resolve()
    ruff = pinned_tool(root, "ruff")
    words = ["--config", "pyproject.toml", "."]  # its patterns are of paths from where ruff is started
    files = subprocess.run([ruff, "check", "--show-files", *words], capture_output=True, text=True, check=True, cwd=root).stdout.splitlines()
    said = subprocess.run([ruff, "check", "--no-cache", "--output-format", "concise", *words], capture_output=True, text=True, cwd=root)
    print(said.stdout + said.stderr + f"{len(files)} files were judged")
    return 1 if said.returncode or len(files) < LEAST else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
