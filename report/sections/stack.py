"""The deformed bearing of rungs rigid-dish and full: the cut along its travel and the pressure under the pad."""
import os
import re

import numpy as np

from .. import stack_picture, vtu
from ..blocks import Section, heading
from .common import field_files, title_of

MOST = 4  # runs shown


def make(context):
    runs = [(entry, entry.fe) for entry in context.results.entries
            if entry.fe is not None and entry.fe.rung in ("rigid-dish", "full") and field_files(entry.fe)]
    if not runs:
        return None
    section = Section("stack", "The deformed bearing")
    section.lead = "The deformed solids at the stored instant farthest from the vertex."
    for entry, run in runs[:MOST]:
        section.add(None if context.results.single else heading(title_of(entry.name)))
        grid, when = _farthest(run)
        section.add(context.pictures.figure(f"stack-{entry.name}", _caption(run, when), _draw, grid, run))
    return section


def _caption(run, when):
    return "" if when is None else f"At {run.time_label.split(' (')[0]} {when:.4g}{' s' if 'time' in run.time_label else ''}."


def _farthest(run):
    """(fields, their time or None) with the largest displacement."""
    times = _times(run)
    return max(((vtu.read(file), times.get(os.path.basename(file))) for file in field_files(run)),
               key=lambda pair: np.abs(pair[0].point_data["displacement"][:, :2]).max())


def _times(run):
    try:
        with open(os.path.join(run.folder, "fields.pvd"), encoding="utf-8") as file:
            return {os.path.basename(name): float(time)
                    for time, name in re.findall(r'timestep="([^"]+)"[^>]*file="([^"]+)"', file.read())}
    except (OSError, ValueError):
        return {}


def _draw(grid, run, path):
    return stack_picture.draw(grid, path, _dish(run))


def _dish(run):
    """(x, z) [m] of an ellipse or a sphere through the vertex; None for other surfaces."""
    surface = run.get("bearing", "surface", default={})
    radius, reach = surface.get("R0_m"), surface.get("planar_radius_mm")
    if not radius or not reach or surface.get("kind", "ellipse") not in ("ellipse", "sphere"):
        return None
    a = surface.get("a_m") if surface.get("kind", "ellipse") == "ellipse" else radius
    x = np.linspace(-reach / 1e3, reach / 1e3, 400)
    return x, a * a / radius * (1 - np.sqrt(1 - (x / a) ** 2))
