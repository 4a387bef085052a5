"""paraview_state.py beside a run's fields: a script that shows the deformed bearing, coloured by stress, in ParaView."""
import os

import jinja2

from . import vtu
from .field_catalogue import info_of
from .files import write_whole
from .page import TEMPLATES

NAME = "paraview_state.py"
COLOURED_BY = ("von_mises_MPa", "equivalent_plastic_strain")


def write(folder: str, grid: vtu.Grid) -> str | None:
    """Gives the script's path; None where the fields hold nothing to colour by. `grid`: one of the run's instants."""
    field = next((name for name in COLOURED_BY if name in grid.point_data), None)
    if field is None or not os.path.isfile(os.path.join(folder, "fields.pvd")):
        return None
    y = grid.points[:, 1]
    title = {"von_mises_MPa": "von Mises stress"}.get(field, field.replace("_", " "))
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), trim_blocks=True, undefined=jinja2.StrictUndefined, autoescape=False)
    text = environment.get_template(NAME + ".j2").render(folder=os.path.abspath(folder), field=field, title=f"{title} ({info_of(field).unit})",
                                                         half=bool(y.min() > -1e-6 or y.max() < 1e-6))
    path = os.path.join(folder, NAME)
    write_whole(path, lambda file: file.write(text.encode()))
    return path
