"""The report as PDF, printed by a headless Chromium where one is installed."""
import os
import pathlib
import shutil
import subprocess
import tempfile

from .errors import IoError
from .files import remove, write_whole

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
PATIENCE = 180  # seconds


def browser() -> str | None:
    """Path of the first one found, or None."""
    return next((path for name in BROWSERS if (path := shutil.which(name))), None)


def print_to(html: str, path: str) -> str | None:
    """Writes the PDF; gives None, or a sentence where no browser is installed (an earlier PDF is gone then: it would show
    other results). Throws IoError where the browser fails."""
    program = browser()
    if program is None:
        remove(path)
        return (f"no PDF: none of {', '.join(BROWSERS)} is installed. Open {html} in a browser and print it to a file "
                "(A4, background graphics on, no headers and footers), or apt-get install chromium and ask again")
    with tempfile.TemporaryDirectory(prefix="rimpact-pdf-") as folder:
        made = os.path.join(folder, "report.pdf")
        command = [program, "--headless", "--disable-gpu", f"--user-data-dir={folder}/profile", "--no-pdf-header-footer",
                   f"--print-to-pdf={made}", pathlib.Path(html).resolve().as_uri()]
        if os.geteuid() == 0:  # Chromium refuses its sandbox to root
            command.insert(1, "--no-sandbox")
        said = _run(command, folder)
        if not os.path.isfile(made):
            raise IoError(f"{program} made no PDF of {html}: {said or 'it gave no reason'}")
        with open(made, "rb") as file:
            content = file.read()
    write_whole(path, lambda file: file.write(content))
    return None


def _run(command: list[str], folder: str) -> str:
    """What the browser said last."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return f"it did not end within {PATIENCE} s"
    except OSError as error:
        return str(error)
    return (done.stderr.strip().splitlines() or [""])[-1]
