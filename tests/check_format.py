#!/usr/bin/env python3
"""Every C++ file is as clang-format 14 and the repository's .clang-format would have it. Other versions format otherwise: then
the check is skipped, with a word."""
import concurrent.futures
import functools
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
VERSION = 14


def program() -> str | None:
    for name in (f"clang-format-{VERSION}", "clang-format"):
        path = shutil.which(name)
        if path:
            said = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout
            found = re.search(r"version (\d+)", said)
            if found and int(found.group(1)) == VERSION:
                return path
    return None


def differs(formatter: str, files: list[pathlib.Path]) -> list[str]:
    """Those of the files that the formatter would change."""
    said = subprocess.run([formatter, "--dry-run", *map(str, files)], capture_output=True, text=True)
    return sorted({line.split(":")[0] for line in said.stderr.splitlines() if "clang-format-violations" in line})


def main(folder: str) -> int:
    formatter = program()
    if not formatter:
        print(f"skipped: clang-format {VERSION} is not here")
        return SKIPPED
    root = pathlib.Path(folder)
    files = [f for f in sorted(root.rglob("*")) if f.suffix in (".cc", ".h") and f.relative_to(root).parts[0] not in ("build", "results")]
    groups = [files[k : k + 40] for k in range(0, len(files), 40)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        wrong = [name for group in pool.map(functools.partial(differs, formatter), groups) for name in group]
    for name in wrong:
        print(f"{pathlib.Path(name).relative_to(root)} is not formatted: clang-format -i {name}")
    print(f"{len(files) - len(wrong)} of {len(files)} files are formatted")
    return 1 if wrong or len(files) < 300 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
