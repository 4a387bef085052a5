"""The README's two commands on a bare Debian or Ubuntu, from a clone of the last commit: ./run, what the README and the tutorial
say to do after it, `cmake --install`, and with --tests ./test too. Says the minutes of each.

usage: bare_root.py SUITE [--tests] [--cache FOLDER] (bookworm, trixie, noble; root and debootstrap are needed, else exit 77: skipped)
--cache: a folder of ccache, which is used and filled; without it everything is compiled.
"""
import pathlib
import sys

from debian_root import Inside, bare_root, call, skip_unless_possible

SOURCE = pathlib.Path(__file__).resolve().parents[2]
HERE = str(SOURCE)  # the same place as here, so that kept compilations serve
PAGES = ("README.md", "docs/tutorial.md")


def kept(root: pathlib.Path, cache: str) -> dict[str, str]:
    """Lets the root use that folder of ccache."""
    pathlib.Path(cache).mkdir(parents=True, exist_ok=True)
    (root / "ccache").mkdir()
    call("mount", "--bind", cache, root / "ccache")
    return {"CCACHE_DIR": "/ccache"}


def walk(inside: Inside) -> None:
    """What the README promises after ./run."""
    program = f"{HERE}/build/release/bin/rimpact"
    inside("it says its version and its threads", f"{program} version", "OpenMP threads  1")
    for page in PAGES:
        inside(f"{page} as it says, finite elements too",
               f"cd /tmp && RIMPACT={program} RIMPACT_SOURCE={HERE} PYTHONPATH={HERE}/build/release/python python3 {HERE}/tests/docs/run_pages.py --only {page}")
    inside("cmake --install", f"cmake --install {HERE}/build/release --prefix /opt/rimpact && test -s /opt/rimpact/share/man/man1/rimpact-run.1")
    inside("the installed program and its Python", "cd /tmp && /opt/rimpact/bin/rimpact list bearings && PYTHONPATH=/opt/rimpact/lib/python3/dist-packages "
           "python3 -c \"import rimpact; print(len(rimpact.run_reduced('impact-window').impacts))\"", "1")


def main(suite: str, *options: str) -> int:
    skip_unless_possible()
    with bare_root(suite) as root:
        call("git", "clone", "-q", SOURCE, root / HERE[1:])
        cache = options[options.index("--cache") + 1] if "--cache" in options else ""
        inside = Inside(root, **kept(root, cache) if cache else {})
        inside("./run", f"cd {HERE} && ./run", "report.html")
        walk(inside)
        if "--tests" in options:
            said = inside("./test", f"cd {HERE} && ./test")
            print(said[said.rfind("tests passed") - 8:])
    print(f"{suite}: {len(inside.failures)} failures")
    return bool(inside.failures)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
