"""A compile database of single sources for clang-tidy, and what each of them includes of this repository."""
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
from functools import cache

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def run(*words: str) -> str:
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{shlex.join(words)} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


@cache
def text_of(file: pathlib.Path) -> str:
    return file.read_text(encoding="utf-8", errors="replace")


class Database:
    """Configured in a folder of its own: that of build/release names batches of sources, which hide the sources from the tool."""

    def __init__(self, root: pathlib.Path, fe: str) -> None:
        self.root = root
        self.folder = root / ("build/tidy" if fe == "ON" else "build/tidy-reduced")
        run("cmake", "-S", str(root), "-B", str(self.folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DRIMPACT_UNITY=OFF",
            "-DRIMPACT_NATIVE=OFF", f"-DRIMPACT_FE={fe}")
        self._generate_headers()
        entries = json.loads((self.folder / "compile_commands.json").read_text(encoding="utf-8"))
        self.commands = {pathlib.Path(entry["file"]): str(entry["command"]) for entry in entries}
        self._closures: dict[pathlib.Path, set[pathlib.Path]] = {}

    def _generate_headers(self) -> None:
        """By their own commands alone: as targets they would wait for the libraries that their programs link."""
        ninja = ("ninja", "-C", str(self.folder), "-t")
        outputs = [line.split(":")[0] for line in run(*ninja, "targets", "all").splitlines()]
        for command in sorted(set(run(*ninja, "commands", "-s", *(output for output in outputs if output.endswith(".h"))).splitlines())):
            run("sh", "-c", command)

    def sources(self) -> list[pathlib.Path]:
        """Those with little behind them first."""
        return sorted(self.commands, key=lambda source: (self.weight(source), source))

    def closure(self, source: pathlib.Path) -> set[pathlib.Path]:
        """The source and all that it includes by quoted names, which are this repository's and generated ones."""
        if source not in self._closures:
            folders = [pathlib.Path(word[2:]) for word in shlex.split(self.commands[source]) if word.startswith("-I")]
            found, waiting = {source}, [source]
            while waiting:
                file = waiting.pop()
                named = (resolved(name, (file.parent, *folders)) for name in INCLUDE.findall(text_of(file)))
                new = {each for each in named if each is not None} - found
                found |= new
                waiting += new
            self._closures[source] = found
        return self._closures[source]

    def weight(self, source: pathlib.Path) -> tuple[bool, int]:
        """A guess at the time it takes: deal.II's headers outweigh all of ours."""
        return "deal.II" in self.commands[source], sum(len(text_of(file)) for file in self.closure(source))

    def key(self, source: pathlib.Path, *more: str) -> str:
        """Changes with anything of ours that the tool sees; not with an upgrade of the system's libraries."""
        read = (text_of(file) for file in sorted(self.closure(source)))
        return hashlib.sha256("\0".join([*more, str(self.root), self.commands[source], *read]).encode()).hexdigest()


@cache
def resolved(name: str, folders: tuple[pathlib.Path, ...]) -> pathlib.Path | None:
    for folder in folders:
        file = pathlib.Path(os.path.normpath(folder / name))
        if file.is_file():
            return file
    return None


def changed_files(root: pathlib.Path) -> set[pathlib.Path] | None:
    """Against where this branch left origin/main, on that itself against the commit before; with what is not committed. None without git's history."""
    def git(*words: str) -> str | None:
        done = subprocess.run(["git", "-C", str(root), *words], capture_output=True, text=True)
        return done.stdout.strip() if done.returncode == 0 else None

    head, base = git("rev-parse", "HEAD"), git("merge-base", "HEAD", "origin/main")
    base = base if base and base != head else git("rev-parse", "HEAD~1")
    named, new = git("diff", "--name-only", base or "HEAD"), git("ls-files", "--others", "--exclude-standard")
    if named is None or new is None:
        return None
    return {root / name for name in (named + "\n" + new).splitlines() if (root / name).is_file()}


def sources_to_judge(database: Database, changed: set[pathlib.Path]) -> list[pathlib.Path]:
    """The changed sources, and for each changed header that none of them includes its own source or else the lightest that includes it."""
    chosen = [source for source in database.sources() if source in changed]
    seen = {file for source in chosen for file in database.closure(source)}
    for header in sorted(file for file in changed if file.suffix == ".h"):
        if header in seen:
            continue
        including = [source for source in database.sources() if header in database.closure(source)]
        including.sort(key=lambda source: source != header.with_suffix(".cc"))  # stable: the lightest first behind its own
        if including:
            chosen.append(including[0])
            seen |= database.closure(including[0])
    return chosen
