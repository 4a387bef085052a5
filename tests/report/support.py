"""What the report's tests share: the source directory on the path, the command as a user runs it, a folder to use, the text of a page."""
import html
import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
if SOURCE not in sys.path:
    sys.path.insert(0, SOURCE)


def command(module: str, *arguments: object, cwd: str = "/") -> subprocess.CompletedProcess[str]:
    """Runs python3 -m MODULE from another directory, as the rimpact command does."""
    environment = os.environ | {"PYTHONPATH": SOURCE, "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, "-m", module, *map(str, arguments)], cwd=cwd, env=environment,
                          capture_output=True, text=True, timeout=110)


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
