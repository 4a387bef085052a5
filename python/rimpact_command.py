"""The command of the pip package. It stands beside the package, whose import would cost every call half a second."""
import os
import sys
from pathlib import Path


def main() -> None:
    """Becomes the program; pictures and reports are this Python's, whose environment has what they need."""
    program = Path(__file__).parent / "rimpact" / "bin" / "rimpact"
    os.execve(program, ["rimpact", *sys.argv[1:]], {**os.environ, "RIMPACT_PYTHON": sys.executable})
