"""The command `rimpact`, for what runs beside this process."""
from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Collection
from pathlib import Path

from rimpact.errors import InputError, of_code


def path() -> str:
    """RIMPACT_PROGRAM, else the one inside this package (pip's), else the one installed with it (PREFIX/bin), else the build folder's, else
    the one in PATH."""
    given = os.environ.get("RIMPACT_PROGRAM")
    folders = Path(__file__).absolute().parents
    near = [folders[depth] / "bin" / "rimpact" for depth in (0, 2, 4) if len(folders) > depth]
    for each in [given, *map(str, near), shutil.which("rimpact")]:
        if each and os.access(each, os.X_OK):
            return each
    raise InputError("the command rimpact was not found; set RIMPACT_PROGRAM to it")


def run(*words: str, accept: Collection[int] = (0,), progress: Callable[[str], object] | None = None) -> str:
    """Runs a verb and returns what it prints; a failure, an exit code that is not among `accept`, raises its exception with the
    command's own sentence. `progress` is called with each line of its messages as it comes."""
    with tempfile.TemporaryFile("w+") as printed:
        with subprocess.Popen([path(), *words], stdout=printed, stderr=subprocess.PIPE, text=True) as process:
            messages = []
            try:
                for line in process.stderr or ():
                    messages.append(line.rstrip("\n"))
                    if progress:
                        progress(messages[-1])
            except BaseException:  # Ctrl-C, or an error of `progress`: the run writes its checkpoint
                process.terminate()
                raise
        if process.returncode not in accept:
            said = [line for line in messages if line.startswith("error: ")]
            raise of_code(process.returncode)((said or [f"rimpact {words[0]} ended with code {process.returncode}"])[-1].removeprefix("error: "))
        printed.seek(0)
        return printed.read()
