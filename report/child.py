"""Programs that the report starts: an interrupt is passed on, and waited for."""
import signal
import subprocess
from typing import IO

INTERRUPTED = 130


def run_child(words: list[str], *, stdout: int | IO[str] | None = subprocess.PIPE, stderr: int | IO[str] | None = subprocess.PIPE) -> subprocess.CompletedProcess[str]:
    """Runs a program to its end; both streams are read as text, or go where the arguments say. Raises KeyboardInterrupt where the program or
    this one was interrupted, after the program has ended: it keeps what it has."""
    with subprocess.Popen(words, stdout=stdout, stderr=stderr, text=True) as process:
        try:
            out, err = process.communicate()
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.wait()
            raise
    if process.returncode == INTERRUPTED:
        raise KeyboardInterrupt
    return subprocess.CompletedProcess(words, process.returncode, out or "", err or "")
