"""Programs that run side by side: as many at a time as there are cores, none left behind by an interrupt."""
import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import IO

from .child import INTERRUPTED

PAUSE = 0.02  #: between looks at what runs [s]


def cores_to_use() -> int:
    """Those this process may run on."""
    return len(os.sched_getaffinity(0))


def _stream() -> IO[str]:
    return tempfile.TemporaryFile("w+", errors="replace")


@dataclass
class _Child:
    """What it says goes to files: a pipe that nobody empties would stop it."""
    words: list[str]
    out: IO[str] = field(default_factory=_stream)
    err: IO[str] = field(default_factory=_stream)

    def __post_init__(self) -> None:
        self.process = subprocess.Popen(self.words, stdout=self.out, stderr=self.err)

    def said(self) -> subprocess.CompletedProcess[str]:
        texts = []
        for file in (self.out, self.err):
            file.seek(0)
            texts.append(file.read())
            file.close()
        return subprocess.CompletedProcess(self.words, self.process.returncode, *texts)


def run_side_by_side(commands: dict[str, list[str]], at_once: int, on_start: Callable[[str], None]) -> Iterator[tuple[str, subprocess.CompletedProcess[str]]]:
    """Starts them in their order, `at_once` >= 1 at a time, and gives each, by name, once it has ended. Raises KeyboardInterrupt where this program
    or one of them was interrupted; the others have then been interrupted and have ended."""
    if at_once < 1:
        raise ValueError(f"{at_once} runs at a time: at least 1")
    waiting, running = list(commands), dict[str, _Child]()
    try:
        while waiting or running:
            while waiting and len(running) < at_once:
                name = waiting.pop(0)
                on_start(name)
                running[name] = _Child(commands[name])
            ended = [name for name, child in running.items() if child.process.poll() is not None]
            if not ended:
                time.sleep(PAUSE)
            for name in ended:
                if running[name].process.returncode == INTERRUPTED:
                    raise KeyboardInterrupt
                yield name, running.pop(name).said()
    finally:
        for child in running.values():
            if child.process.poll() is None:
                child.process.send_signal(signal.SIGINT)
        for child in running.values():
            child.process.wait()
