#!/usr/bin/env python3
"""The README's and the tutorial's commands, and `cmake --install`, in the state that ./run leaves: a build folder which holds what
ninja makes for the target `product` and nothing else. The slow blocks (finite elements) are left to tests/package/bare_root.py.

usage: after_run.py SOURCE BUILD"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PAGES = ("README.md", "docs/tutorial.md")
#: Files that a rule makes beside the one it names, by their folder.
WHOLE = ("words", "share")


def made(build: pathlib.Path) -> set[pathlib.Path]:
    """What stands in the build folder after `ninja product`."""
    graph = subprocess.run(["ninja", "-C", str(build), "-t", "graph", "product"], capture_output=True, text=True, check=True).stdout
    files = {build / name for name in re.findall(r'\[label="([^"]+)"', graph)}
    return {file for file in files if file.is_file() and build in file.parents}


def staged(source: pathlib.Path, build: pathlib.Path, there: set[pathlib.Path], root: pathlib.Path) -> pathlib.Path:
    """The source tree, by links, around a build folder with what is `there`."""
    root.mkdir()
    for entry in source.iterdir():
        if entry.name not in ("build", "results", ".git"):
            (root / entry.name).symlink_to(entry)
    inside = root / build.relative_to(source)
    for file in there:
        if file.relative_to(build).parts[0] in WHOLE:
            continue
        at = inside / file.relative_to(build)
        at.parent.mkdir(parents=True, exist_ok=True)
        os.link(file, at)
    for name in WHOLE:
        (inside / name).symlink_to(build / name)
    for file in (build / "python/rimpact").glob("*.py"):  # links that configuring makes
        (inside / "python/rimpact" / file.name).symlink_to(file.resolve())
    return inside


def not_made(build: pathlib.Path, there: set[pathlib.Path]) -> list[str]:
    """What `cmake --install` takes from the build folder and ./run does not make."""
    scripts = "\n".join(file.read_text(encoding="utf-8") for file in build.glob("**/cmake_install.cmake") if "_deps" not in file.parts)
    wanted = {pathlib.Path(each) for each in re.findall(r'"(' + re.escape(str(build)) + r'/[^"$]+)"', scripts)}
    wanted = {each for each in wanted if each.suffix not in (".cmake", ".txt") and each.relative_to(build).parts[0] not in WHOLE}
    missing = sorted(str(each) for each in wanted if each.is_file() and each not in there)
    words = build / "words/completion/rimpact"
    return missing + ([] if words in there else [str(words)]) + ([] if wanted else ["nothing to install was found"])


def main(source: pathlib.Path, build: pathlib.Path) -> int:
    there = made(build)
    faults = [f"cmake --install needs {each}, which ./run does not make" for each in not_made(build, there)]
    with tempfile.TemporaryDirectory() as folder:
        inside = staged(source, build, there, pathlib.Path(folder) / "rimpact")
        environment = {**os.environ, "RIMPACT": str(inside / "bin/rimpact"), "RIMPACT_SOURCE": str(source), "PYTHONPATH": str(inside / "python")}
        for page in PAGES:
            done = subprocess.run([sys.executable, str(source / "tests/docs/run_pages.py"), "--light", "--only", page], env=environment, capture_output=True, text=True)
            print(f"{page}: {done.stdout.strip()}")
            faults += [f"{page}: {done.stderr}"] if done.returncode else []
    print("\n".join(faults) or "README, tutorial and cmake --install need nothing that ./run does not make")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
