"""The deformed bearing of rungs rigid-dish and full: the cut along its travel and the pressure under the pad."""
import numpy as np

from .. import stack_picture, vtu
from ..bearing import height, value
from ..blocks import Section, heading
from .common import instants, title_of

MOST = 4  # runs shown


def make(context):
    runs = [(entry, entry.fe) for entry in context.results.entries
            if entry.fe is not None and entry.fe.rung in ("rigid-dish", "full") and instants(entry.fe)]
    if not runs:
        return None
    section = Section("stack", "The deformed bearing")
    section.lead = "The deformed solids at the stored instant farthest from the vertex."
    for entry, run in runs[:MOST]:
        section.add(None if context.results.single else heading(context.doubts.marked(entry.name, title_of(entry.name))))
        section.add(context.pictures.figure(f"stack-{entry.name}", "", _draw, run))
    return section


def _farthest(files):
    """(fields, their time or None) with the largest displacement."""
    return max(((vtu.read(file), time) for file, time in files),
               key=lambda pair: np.abs(pair[0].point_data["displacement"][:, :2]).max())


def _draw(run, path):
    grid, time = _farthest(instants(run))
    unit = " s" if "time" in run.time_label else ""
    said = f"{run.time_label.split(' (')[0]} {time:.4g}{unit}" if time is not None else ""
    return stack_picture.draw(grid, path, _dish(run), said)


def _dish(run):
    """(x, z) [m] of the sliding surface through the vertex; None where the scene does not give it."""
    bearing = run.get("bearing", default={})
    reach = value(bearing, "surface", "planar_radius_mm")
    if not reach:
        return None
    x = np.linspace(-reach, reach, 400)
    return x, height(bearing, x)
