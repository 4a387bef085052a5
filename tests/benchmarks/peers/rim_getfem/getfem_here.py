"""Whether GetFEM is installed, for scripts that compare with it."""
import argparse
import importlib.util


def is_ready(options: argparse.Namespace) -> bool:
    """Makes the folder; False, with a word, where there is nothing to compare with."""
    if importlib.util.find_spec("getfem") is None:
        print("skipped: GetFEM (Debian's python3-getfem) is not installed, so there is nothing to compare with")
        return False
    options.folder = options.folder.resolve()
    options.folder.mkdir(parents=True, exist_ok=True)
    return True
