"""The deformed bearing of rungs rigid-dish and full: the cut along its travel and the pressure under the pad."""
import numpy as np

from .. import stack_picture, vtu
from ..bearing import height, value
from ..blocks import Section, heading
from ..context import WHOLE, Context
from ..errors import DataError
from ..run_folder import Run
from ..stored_fields import instants, said_of
from .common import title_of, turning_model

MOST = 4  # runs shown


def make(context: Context) -> Section | None:
    runs = [(entry, entry.fe) for entry in context.results.entries
            if entry.fe is not None and entry.fe.rung in WHOLE and instants(entry.fe)]
    if not runs:
        return None
    section = Section("stack", "The deformed bearing")
    section.lead = "The deformed solids at the stored instant farthest from the vertex."
    for entry, run in runs[:MOST]:
        section.add(None if context.results.single else heading(context.doubts.marked(entry.name, title_of(entry.name))))
        try:
            grid, time = _farthest(instants(run))
        except (DataError, KeyError) as error:
            context.problems.append(f"figure stack-{entry.name} could not be drawn: {error}")
            continue
        picture = context.pictures.figure(f"stack-{entry.name}", "", _draw, run, grid, time)
        section.add(picture)
        section.add(turning_model(grid, run, time) if picture else None)
    return section


def _farthest(files: list[tuple[str, float | None]]) -> tuple[vtu.Grid, float | None]:
    """(fields, their time or None) with the largest displacement."""
    return max(((vtu.read(file), time) for file, time in files),
               key=lambda pair: np.abs(pair[0].point_data["displacement"][:, :2]).max())


def _draw(run: Run, grid: vtu.Grid, time: float | None, path: str) -> str:
    return stack_picture.draw(grid, path, _dish(run), said_of(run, time))


def _dish(run: Run) -> tuple[np.ndarray, np.ndarray] | None:
    """(x, z) [m] of the sliding surface through the vertex; None where the scene does not give it."""
    bearing = run.get("bearing", default={})
    reach = value(bearing, "surface", "planar_radius_mm")
    if not reach:
        return None
    x = np.linspace(-reach, reach, 400)
    return x, height(bearing, x)
