"""The deformed boundary of a model as data for the page's script view3d.js: places, displacements, fields with their units, bodies.

Cells are as curved as the file has them. A half model is mirrored by the script."""
import base64
import json
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup

from . import vtu
from .hexahedra import on_grid, smooth
from .painter import bodies, body_of_points, boundary_faces, merged

MOST_FACES = 20_000  #: beyond these, faces are drawn by their corners
FIELDS = (("von_mises_MPa", "von Mises stress", "MPa", 1.0), ("equivalent_plastic_strain", "equivalent plastic strain", "%", 100.0),
          ("damage", "damage", "–", 1.0), ("contact_pressure_MPa", "contact pressure", "MPa", 1.0))


@dataclass
class Surface:
    """Of one instant, in SI but for the fields, which are in their own units."""
    points: np.ndarray       #: (n, 3), undeformed
    moved: np.ndarray        #: (n, 3)
    triangles: np.ndarray    #: (m, 3)
    lines: np.ndarray        #: (k, 2): edges of cells
    fields: dict[str, np.ndarray]
    triangle_part: np.ndarray
    line_part: np.ndarray
    parts: list[str]
    half: bool


def surface(grid: vtu.Grid) -> Surface:
    place = merged(grid.points)
    body = bodies(grid.hexahedra, place)
    faces, cell = boundary_faces(grid.hexahedra, place)
    of_point = body_of_points(grid.hexahedra, body, len(grid.points))
    half = grid.points[:, 1].min() > -1e-6 or grid.points[:, 1].max() < 1e-6
    fine = 1 if len(faces) > MOST_FACES else 4 if faces.shape[1] > 4 else 2
    fields = {name: smooth(grid.point_data[name].astype(float), place, of_point) * factor
              for name, _, _, factor in FIELDS if name in grid.point_data and not np.all(grid.point_data[name] == 0)}
    sample = lambda values: on_grid(values, fine).reshape(len(faces) * (fine + 1) ** 2, *values.shape[2:])  # noqa: E731
    triangles, lines = _joined(len(faces), fine)
    part = body[cell]
    return Surface(sample(grid.points[faces]), sample(grid.point_data["displacement"].astype(float)[faces]), triangles, lines,
                   {name: sample(values[faces[:, :4]]) for name, values in fields.items()}, np.repeat(part, 2 * fine * fine),
                   np.repeat(part, 4 * fine), part_names(grid, body), half)


def _joined(n_faces: int, fine: int) -> tuple[np.ndarray, np.ndarray]:
    """Triangles and edge lines of n faces, each an even grid of its own points."""
    at = np.arange((fine + 1) ** 2).reshape(fine + 1, fine + 1)
    a, b, c, d = at[:-1, :-1].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel(), at[:-1, 1:].ravel()
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    ring = np.concatenate([at[:-1, 0], at[-1, :-1], at[:0:-1, -1], at[0, :0:-1]])
    lines = np.column_stack([ring, np.roll(ring, -1)])
    first = (np.arange(n_faces) * at.size)[:, None, None]
    return (first + triangles).reshape(-1, 3), (first + lines).reshape(-1, 2)


def part_names(grid: vtu.Grid, body: np.ndarray) -> list[str]:
    """By where the bodies stand: plate and rim reach farthest, the upper slider highest."""
    n = int(body.max()) + 1
    corners = [grid.points[grid.hexahedra[body == b].ravel()] for b in range(n)]
    reach = np.array([np.hypot(c[:, 0], c[:, 1]).max() for c in corners])
    far = reach > 0.999 * reach.max() if n > 1 and reach.max() > 0.25 else np.zeros(n, bool)
    near = sorted(np.flatnonzero(~far).tolist(), key=lambda b: corners[b][:, 2].mean())
    names = dict.fromkeys(np.flatnonzero(far).tolist(), "plate and rim")
    below = {1: ["pad and foot"], 2: ["pad", "foot"]}.get(len(near) - 1, [f"body {i + 1}" for i in range(len(near) - 1)])
    names |= dict(zip(near, [*below, "upper slider"]))
    return [names[b] for b in range(n)]


def _indices(values: np.ndarray, n_points: int) -> str:
    return _packed(values, "<u2" if _short(n_points) else "<u4")


def _short(n_points: int) -> bool:
    return n_points <= 2**16


def _packed(values: np.ndarray, kind: str) -> str:
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode()


def _grouped(items: np.ndarray, part: np.ndarray, parts: Sequence[str]) -> tuple[np.ndarray, dict[str, list[int]]]:
    """Sorted so that each part is one stretch: (items, {part: [first, count]})."""
    names = sorted(set(parts), key=list(parts).index)
    number = np.array([names.index(name) for name in parts])[part]
    counts = np.bincount(number, minlength=len(names))
    starts = np.cumsum(counts) - counts
    return items[np.argsort(number, kind="stable")], {name: [int(a), int(b)] for name, a, b in zip(names, starts, counts)}


def data(grid: vtu.Grid, said: str = "") -> Markup:
    """JSON for the page. `said`: of the instant."""
    model = surface(grid)
    triangles, of_triangles = _grouped(model.triangles, model.triangle_part, model.parts)
    lines, of_lines = _grouped(model.lines, model.line_part, model.parts)
    middle = (model.points + model.moved).mean(axis=0) * [1, 0 if model.half else 1, 1]
    size = float((np.ptp(model.points + model.moved, axis=0) * [1, 2 if model.half else 1, 1]).max())
    fields = [{"name": title, "unit": unit, "low": 0.0, "high": max(float(np.percentile(model.fields[name], 99.8)), 1e-9),
               "largest": float(grid.point_data[name].max()) * factor, "values": _packed(model.fields[name], "<f4")}
              for name, title, unit, factor in FIELDS if name in model.fields]
    rigid = _rigid(model)
    content = {"points": _packed(model.points - middle + rigid, "<f4"), "moved": _packed(model.moved - rigid, "<f4"),
               "triangles": _indices(triangles, len(model.points)),
               "lines": _indices(lines, len(model.points)), "short": _short(len(model.points)), "half": bool(model.half), "size": size, "said": said,
               "parts": {name: {"triangles": of_triangles[name], "lines": of_lines[name]} for name in of_triangles}, "fields": fields,
               "largest": _nice(0.05 * size / max(float(np.abs(model.moved - rigid).max()), 1e-12))}
    return Markup(json.dumps(content, allow_nan=False).replace("<", "\\u003c"))


def _nice(value: float) -> int:
    return max([step for step in (1, 2, 5, 10, 20, 50, 100) if step <= value], default=1)


def _rigid(model: Surface) -> np.ndarray:
    """Mean motion of each part at its points; it is never enlarged."""
    rigid = np.zeros_like(model.moved)
    for name in set(model.parts) - {"plate and rim"}:
        numbers = [i for i, other in enumerate(model.parts) if other == name]
        own = np.unique(model.triangles[np.isin(model.triangle_part, numbers)])
        rigid[own] = model.moved[own].mean(axis=0) * [1, 0 if model.half else 1, 1]
    return rigid
