#!/usr/bin/env python3
"""Runs the README, the tutorial, the Python page, the guide and the examples as they are written, each in a folder of its own.

In a page a block of shell commands stands as ```sh; a block ```text right behind it is what they print. Numbers in it are met within 2 % (the last digit apart),
words to the letter; a line `...` stands for any lines. Blocks ```sh slow are left out with --light: they need finite elements.
```python blocks run in one interpreter a page, in the same folder, unless they are marked ```python part.
`--only PAGE` runs one. Of a block ```sh part, which needs files of the reader's, the verbs and options are sought in the program's help.
"""
import functools
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
PROGRAM = pathlib.Path(os.environ["RIMPACT"]).resolve()
BLOCK = re.compile(r"^```(\w+)([^\n]*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+(?:,\d{3})*(?:\.\d+)?(?:e[-+]?\d+)?")
NEAR = 0.02
NEED_FE = {"run", "mesh", "curve", "version"}


def same(told: str, printed: str) -> bool:
    """One line against another: words alike, numbers near."""
    if NUMBER.sub("#", told).split() != NUMBER.sub("#", printed).split():
        return False
    for a, b in zip(NUMBER.findall(told), NUMBER.findall(printed)):
        x, y = float(a.replace(",", "")), float(b.replace(",", ""))
        digits = len(a.split(".")[1]) if "." in a and "e" not in a else 0
        if abs(x - y) > NEAR * max(abs(x), abs(y)) + 1.01 * 10.0 ** -digits * ("." in a):
            return False
    return True


def timeless(text: str) -> str:
    """What a run took is not the page's to say."""
    return re.sub(r"\bin \d+ s\b", "in some s", text)


def missing(told: str, printed: list[str]) -> str | None:
    """The first line of the page that the output does not hold in this order; None: all are there."""
    at = 0
    for line in told.splitlines():
        if not line.strip() or line.strip() == "...":
            continue
        while at < len(printed) and not same(line, printed[at]):
            at += 1
        if at == len(printed):
            return line
        at += 1
    return None


@functools.cache
def options_of(verb: str) -> set[str]:
    """What `rimpact VERB --help` knows; nothing for a verb that is not there or not built."""
    done = subprocess.run([PROGRAM, verb, "--help"], capture_output=True, text=True, check=False)
    return set(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", done.stdout)) if not done.returncode else set()


def unknown(body: str, light: bool) -> list[str]:
    """Options of a block's rimpact commands that the program does not have."""
    found = list[str]()
    for line in body.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words[:1] != ["rimpact"] or light and words[1] in NEED_FE:
            continue
        known = options_of(words[1])
        found += [f"rimpact {words[1]} {word}" for word in words[2:] if word.startswith("-") and word.split("=")[0] not in known]
    return found


def run_page(page: pathlib.Path, light: bool, folder: pathlib.Path) -> tuple[list[str], int]:
    environment = {**os.environ, "RIMPACT_SOURCE": str(SOURCE), "PATH": f"{PROGRAM.parent}:/usr/bin:{os.environ['PATH']}", "RIMPACT_PROGRAM": str(PROGRAM),
                   "MPLBACKEND": "Agg", "LANG": "C.UTF-8"}
    printed: list[str] | None = None
    python, errors, n_run = "", list[str](), 0
    for kind, mark, body in BLOCK.findall(page.read_text(encoding="utf-8")):
        if kind == "sh" and "part" in mark:
            printed = None
            errors += [f"{page}: {each} is not an option" for each in unknown(body, light)]
            n_run += 1
        elif kind == "sh":
            printed = None
            if "slow" in mark and light:
                continue
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", body], cwd=folder, env=environment, capture_output=True, text=True, check=False)
            n_run += 1
            if done.returncode:
                return [f"{page}: exit code {done.returncode} from\n{body}{done.stderr[-2000:]}"], n_run
            printed = timeless(done.stdout + done.stderr).splitlines()
        elif kind == "text" and "part" not in mark and printed is not None:
            if (line := missing(timeless(body), printed)) is not None:
                errors.append(f"{page}: not printed: {line}\nbut:\n" + "\n".join(printed[:60]))
            printed = None
        elif kind == "python" and "part" not in mark:
            if "slow" in mark and light:
                continue
            python += body
            done = subprocess.run([sys.executable, "-c", python], cwd=folder, env=environment, capture_output=True, text=True, check=False)
            n_run += 1
            if done.returncode:
                return [f"{page}: {done.stderr[-2000:]}"], n_run
            printed = done.stdout.splitlines()
    return errors, n_run


def main(*options: str) -> int:
    errors, n_run = list[str](), 0
    pages = [SOURCE / "README.md", SOURCE / "docs/tutorial.md", SOURCE / "docs/python.md",
             *sorted((SOURCE / "docs/guide").glob("*.md")), *sorted((SOURCE / "examples").glob("*/README.md"))]
    if "--only" in options:
        pages = [SOURCE / options[options.index("--only") + 1]]
    for page in pages:
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary) / page.parent.name
            if page.parent == SOURCE or SOURCE / "docs" in page.parents:
                folder.mkdir()
            else:
                shutil.copytree(page.parent, folder)
            found, n = run_page(page, "--light" in options, folder)
            errors, n_run = errors + found, n_run + n
    print("\n".join(errors) or f"{n_run} blocks of README, tutorial, guide and examples print what they say")
    return 1 if errors or n_run < (1 if "--only" in options else 8) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
