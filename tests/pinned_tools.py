"""The tools that judge form, in the versions of tests/tools/requirements.txt: first from build/tools, where ./test installs them, then from PATH."""
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
LIST = "tests/tools/requirements.txt"


def pinned_version(root: pathlib.Path, tool: str) -> str:
    found = re.search(rf"^{re.escape(tool)}==(\S+)$", (root / LIST).read_text(encoding="utf-8"), re.MULTILINE)
    if not found:
        raise ValueError(f"{LIST} names no version of {tool}")
    return found.group(1)


def version_of(program: str) -> str:
    """As the program prints it; empty where it does not run."""
    try:
        said = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    except OSError:
        return ""
    found = re.search(r"\d+\.\d+\.\d+", said)
    return found.group(0) if found else ""


def pinned_tool(root: pathlib.Path, tool: str) -> str:
    """The path of the tool in its pinned version. Without it the check that asks is skipped, and its one line says how to get the tool."""
    version = pinned_version(root, tool)
    places = (root / "build/tools/bin" / tool, shutil.which(f"{tool}-{version.split('.')[0]}"), shutil.which(tool))
    for program in (str(place) for place in places if place):
        if version_of(program) == version:
            print(f"{tool} {version}: {program}")
            return program
    print(f"skipped: {tool} {version} is not here: python3 -m venv build/tools && build/tools/bin/pip install -r {LIST}")
    sys.exit(SKIPPED)
