#!/usr/bin/env python3
"""Every C++ file is as the pinned clang-format and the repository's .clang-format would have it; other versions format otherwise."""
import concurrent.futures
import functools
import pathlib
import subprocess
import sys

from pinned_tools import pinned_tool

LEAST = 900  #: files; fewer means that they were not found


def differs(formatter: str, files: list[pathlib.Path]) -> list[str]:
    """Those of the files that the formatter would change."""
    said = subprocess.run([formatter, "--dry-run", *map(str, files)], capture_output=True, text=True)
    wrong = sorted({line.split(":")[0] for line in said.stderr.splitlines() if "clang-format-violations" in line})
    if said.returncode and not wrong:
        raise SystemExit(f"{formatter} failed: {said.stderr}")
    return wrong


def main(folder: str) -> int:
    root = pathlib.Path(folder).resolve()
    formatter = pinned_tool(root, "clang-format")
    files = [f for f in sorted(root.rglob("*")) if f.suffix in (".cc", ".h") and f.relative_to(root).parts[0] not in ("build", "results")]
    groups = [files[k : k + 40] for k in range(0, len(files), 40)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        wrong = [name for group in pool.map(functools.partial(differs, formatter), groups) for name in group]
    for name in wrong:
        print(f"{pathlib.Path(name).relative_to(root)} is not formatted: {formatter} -i {name}")
    print(f"{len(files) - len(wrong)} of {len(files)} files are formatted")
    return 1 if wrong or len(files) < LEAST else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
