"""Whether GetFEM is installed, for scripts that compare with it."""
import importlib.util


def lacks_getfem() -> bool:
    """Says so where it is not."""
    lacks = importlib.util.find_spec("getfem") is None
    if lacks:
        print("skipped: GetFEM (Debian's python3-getfem) is not installed, so there is nothing to compare with")
    return lacks
