"""Figures painted by child processes while this one composes the next: finding the layout and painting take most of a report's time.

A child is a fork: it has the figure, needs nothing handed over, and leaves the picture in its file."""
import json
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from typing import IO, Any

from .errors import IoError


@dataclass
class _Painting:
    pid: int
    out: IO[bytes]  #: what the child says, as JSON: {"made": ...}, or {"error": sentence, "io": whether it is the file system's}


class FigureProcesses:
    """`at_once`: so many paint side by side; one more waits for the oldest."""

    def __init__(self, at_once: int) -> None:
        self.at_once = at_once
        self._running: list[_Painting] = []

    def start(self, paint: Callable[[], Any]) -> _Painting:
        """paint() runs in a child; what it returns, as JSON has it, is result()'s."""
        while len(self._running) >= self.at_once:
            self._wait(self._running[0])
        out = tempfile.TemporaryFile()
        pid = os.fork()
        if pid == 0:
            _say_and_exit(paint, out)
        painting = _Painting(pid, out)
        self._running.append(painting)
        return painting

    def _wait(self, painting: _Painting) -> None:
        if painting in self._running:
            os.waitpid(painting.pid, 0)
            self._running.remove(painting)

    def result(self, painting: _Painting) -> Any:
        """Waits for it. Throws ValueError for a figure that could not be painted, IoError for a file that could not be written."""
        self._wait(painting)
        with painting.out as out:
            out.seek(0)
            text = out.read()
        said = json.loads(text) if text else {"error": "its process ended before it had painted", "io": False}
        if "error" in said:
            raise IoError(said["error"]) if said["io"] else ValueError(said["error"])
        return said["made"]


def _say_and_exit(paint: Callable[[], Any], out: IO[bytes]) -> None:
    """In the child: nothing of the parent's is to be run at its exit."""
    try:
        said = {"made": paint()}
    except BaseException as error:
        said = {"error": str(error) or type(error).__name__, "io": isinstance(error, IoError)}
    try:
        out.write(json.dumps(said).encode())
        out.flush()
    finally:
        os._exit(0)
