"""Which VTU files a run has stored, and when."""
import glob
import os
import re
import xml.etree.ElementTree as tree

from .errors import DataError
from .run_folder import Run


def instants(run: Run) -> list[tuple[str, float | None]]:
    """(VTU file, its time or None) of what fields.pvd lists, in its order: other files in the folder are another run's.
    Without fields.pvd every file there is, by its number."""
    listed = _listed(run)
    if listed is None:
        files = glob.glob(os.path.join(glob.escape(run.folder), "fields", "*.vtu"))
        return [(file, None) for file in sorted(files, key=lambda file: [int(n) for n in re.findall(r"\d+", os.path.basename(file))])]
    return [(file, time) for file, time in listed if os.path.isfile(file)]


def absent(run: Run) -> list[str]:
    """Files that fields.pvd lists and that are not there."""
    return [file for file, _ in _listed(run) or [] if not os.path.isfile(file)]


def _listed(run: Run) -> list[tuple[str, float]] | None:
    """None: there is no fields.pvd."""
    path = os.path.join(run.folder, "fields.pvd")
    if not os.path.isfile(path):
        return None
    try:
        listed = tree.parse(path).getroot().iter("DataSet")
        return [(os.path.join(run.folder, item.get("file", "")), float(item.get("timestep", ""))) for item in listed]
    except (OSError, tree.ParseError, TypeError, ValueError) as error:
        raise DataError(f"{path} is not readable ({error})") from None


def said_of(run: Run, time: float | None) -> str:
    """Of an instant: "time 0.0325 s", or of the load parameter."""
    return "" if time is None else f"{run.time_label.split(' (')[0]} {time:.4g}" + (" s" if "time" in run.time_label else "")
