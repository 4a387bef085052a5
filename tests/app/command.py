"""Runs the command and keeps what it printed."""
import os
import pty
import subprocess
import unittest
from collections.abc import Sequence

Done = subprocess.CompletedProcess[str]
RIMPACT = os.environ["RIMPACT"]


def rimpact(*arguments: str, cwd: str | None = None, **environment: str) -> Done:
    return subprocess.run([RIMPACT, *arguments], capture_output=True, text=True, cwd=cwd, timeout=900,
                          env={**os.environ, **environment})


def on_two_ranks(*arguments: str) -> Done:
    """The command under mpirun, as any user, root too."""
    return subprocess.run(["mpirun", "--oversubscribe", "-np", "2", RIMPACT, *arguments], capture_output=True, text=True, timeout=900,
                          env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                               "OMPI_MCA_mpi_yield_when_idle": "1"})


def in_terminal(*arguments: str, **environment: str) -> str:
    """What the command prints to stderr when that is a terminal."""
    try:
        master, slave = pty.openpty()
    except OSError as error:  # a root without /dev/pts
        raise unittest.SkipTest(f"no terminal can be had here: {error}") from None
    base = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    subprocess.run([RIMPACT, *arguments], stdout=subprocess.DEVNULL, stderr=slave, env={**base, **environment}, timeout=60)
    os.close(slave)
    text = b""
    try:
        while chunk := os.read(master, 4096):
            text += chunk
    except OSError:  # how Linux says that nobody writes any more
        pass
    os.close(master)
    return text.decode()


class Refusals(unittest.TestCase):
    """Bad input is refused with one sentence and the right exit code."""

    def refused(self, code: int, *needles: str, arguments: Sequence[str]) -> Done:
        run = rimpact(*arguments)
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual(len([line for line in run.stderr.splitlines() if line.startswith("error:")]), 1, run.stderr)
        for needle in needles:
            self.assertIn(needle, run.stderr)
        return run
