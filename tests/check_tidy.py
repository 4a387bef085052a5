#!/usr/bin/env python3
"""The pinned clang-tidy finds nothing, by .clang-tidy, in the sources and headers of this repository.

    check_tidy.py ROOT [--fe ON|OFF]             all of them, about an hour at first
    check_tidy.py ROOT [--fe ON|OFF] --changed   what changed since origin/main or the last commit, as far as a minute reaches
    check_tidy.py ROOT --self-test               planted faults are found

A source in which nothing was found is not judged again before it, what it includes, its command or .clang-tidy changes:
build/tidy/clean remembers it. Not among them is tests/fuzz, which CMake does not build."""
import argparse
import concurrent.futures
import functools
import itertools
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator

import tidy_planted
from pinned_tools import SKIPPED, pinned_tool, pinned_version
from tidy_database import Database, changed_files, sources_to_judge

FINDING = re.compile(r"^(/\S+:\d+:\d+): (?:warning|error): (.*)$", re.MULTILINE)
SECONDS = 50  #: of --changed
LEAST = 300  #: sources; fewer means that they were not found


def judge(tidy: str, settings: pathlib.Path, ours: pathlib.Path, database: pathlib.Path, source: pathlib.Path,
          seconds: float | None = None) -> set[str] | None:
    """What the tool finds in one source and its headers under `ours`; None where the seconds did not suffice. A tool that fails without a finding is one."""
    words = [tidy, "--quiet", f"--config-file={settings}", "-p", str(database), str(source)]
    running = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    try:
        said, complaint = running.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(running.pid, signal.SIGKILL)  # the wheel's script and its program
        running.communicate()
        return None
    findings = FINDING.findall(said)
    found = {f"{place}: {what}" for place, what in findings if place.startswith(f"{ours}/")}  # a library's header is not ours to mend
    if running.returncode and not findings:
        found = {f"{source}: clang-tidy ended with {running.returncode}: {said[-500:]}{complaint[-500:]}"}
    return found


def judged(tidy: str, database: Database, sources: list[pathlib.Path], until: float | None) -> Iterator[tuple[pathlib.Path, set[str] | None]]:
    """Each source with its findings, two at a time; None where the time was over."""
    clean = database.folder / "clean"
    clean.mkdir(exist_ok=True)
    settings = (pinned_version(database.root, "clang-tidy"), (database.root / ".clang-tidy").read_text(encoding="utf-8"))

    def one(source: pathlib.Path) -> tuple[pathlib.Path, set[str] | None]:
        mark = clean / database.key(source, *settings)
        if mark.exists():
            return source, set()
        left = None if until is None else until - time.monotonic()
        found = None if left is not None and left <= 0 else judge(tidy, database.root / ".clang-tidy", database.root, database.folder, source, left)
        if found == set():
            mark.touch()
        return source, found

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        yield from (each.result() for each in concurrent.futures.as_completed([pool.submit(one, source) for source in sources]))


def unseen_headers(database: Database) -> list[str]:
    """Headers that no source includes, which nothing judges."""
    seen = set(itertools.chain.from_iterable(database.closure(source) for source in database.sources()))
    headers = {file for file in database.root.rglob("*.h") if file.relative_to(database.root).parts[0] not in ("build", "results")}
    return [f"{header}: no source includes it" for header in sorted(headers - seen)]


def report(tidy: str, database: Database, sources: list[pathlib.Path], until: float | None) -> int:
    found: set[str] = set()
    left = []
    for source, findings in judged(tidy, database, sources, until):
        if findings is None:
            left.append(str(source.relative_to(database.root)))
        else:
            for finding in sorted(findings - found):
                print(finding, flush=True)
            found |= findings
    print(f"{len(found)} findings in {len(sources) - len(left)} sources and what they include")
    if left:
        print(f"left out after {SECONDS} s, judged by the next call or by ./test --full: {', '.join(sorted(left))}")
    return 1 if found else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--fe", choices=("ON", "OFF"), default="ON", help="OFF: without the finite-element side, where deal.II is missing")
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    given = parser.parse_args()
    root = given.root.resolve()
    tidy = pinned_tool(root, "clang-tidy")
    if given.self_test:
        return tidy_planted.missed(functools.partial(judge, tidy, root / ".clang-tidy"))
    until = time.monotonic() + SECONDS if given.changed else None
    changed = changed_files(root) if given.changed else set()
    if changed is None:
        print("skipped: git tells no history here, so that nothing says what changed; ./test --full judges all")
        return SKIPPED
    database = Database(root, given.fe)
    if given.changed:
        return report(tidy, database, sources_to_judge(database, changed), until)
    unseen = unseen_headers(database) if given.fe == "ON" else []
    for header in unseen:
        print(header)
    return max(report(tidy, database, database.sources(), until), 1 if unseen or len(database.sources()) < LEAST else 0)


if __name__ == "__main__":
    sys.exit(main())
