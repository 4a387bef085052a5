"""What the report's tests share: the source directory on the path, the command as a user runs it and in this process, pictures that
nobody paints, a folder to use, the text of a page."""
import contextlib
import html
import io
import os
import re
import runpy
import subprocess
import sys
import tempfile
import unittest
import warnings
from typing import IO, Any
from unittest import mock

from PIL import Image

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
if SOURCE not in sys.path:
    sys.path.insert(0, SOURCE)


def command(module: str, *arguments: object, cwd: str = "/") -> subprocess.CompletedProcess[str]:
    """Runs python3 -m MODULE from another directory, as the rimpact command does."""
    environment = os.environ | {"PYTHONPATH": SOURCE, "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, "-m", module, *map(str, arguments)], cwd=cwd, env=environment,
                          capture_output=True, text=True, timeout=110)


def in_process(module: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    """As command(), in this process: exit code and streams are the same, but nothing is loaded again and patches hold."""
    written = io.BytesIO(), io.BytesIO()
    out, err = (io.TextIOWrapper(each, "utf-8", write_through=True) for each in written)
    code: int | str | None = 0
    with mock.patch.object(sys, "argv", [module, *map(str, arguments)]), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), \
         warnings.catch_warnings():
        warnings.filterwarnings("ignore", "'report.* found in sys.modules", RuntimeWarning)  # the test has imported it too
        try:
            runpy.run_module(module, run_name="__main__", alter_sys=True)
        except SystemExit as stop:
            code = stop.code
    said, complained = (each.getvalue().decode() for each in written)
    return subprocess.CompletedProcess([module], code if isinstance(code, int) else 0 if code is None else 1, said, complained)


def _dot(fig: Any, file: IO[bytes], dpi: int = 0) -> None:
    Image.new("RGB", (1, 1)).save(file, "PNG")


#: For tests, and classes of them, that look at no picture: every figure is composed, counted and kept, as one dot. Neither layout nor
#: paint take their time; nor do they find faults, so one test of each kind of page goes without.
unpainted = mock.patch("report.style.write_png", _dot)


def text_of(path: str) -> tuple[str, str]:
    """A page, and what can be read on it."""
    with open(path, encoding="utf-8") as file:
        page = file.read()
    return page, html.unescape(re.sub(r"[ \n]+", " ", re.sub(r"<[^>]+>", " ", re.sub(r"<style.*?</style>", "", page, flags=re.S))))


class InFolder(unittest.TestCase):
    """Each test gets an empty folder."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name

    def path(self, *parts: str) -> str:
        return os.path.join(self.folder, *parts)

    def write(self, name: str, content: str) -> str:
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(content)
        return self.path(name)
