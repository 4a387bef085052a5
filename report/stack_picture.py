"""python3 -m report.stack_picture FILE.vtu OUT.png: the deformed bearing of rung rigid-dish, in true scale.

Left: the cut through the axis in the direction of travel, coloured by von Mises stress. Right: the pressure under
the pad, or a slider between two dishes, seen from above, its axes fixed to it. A half model is mirrored where the picture needs the whole. Cells are
drawn as curved as the file has them, values averaged where the cells of a body meet."""
import argparse

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from . import vtu
from .errors import DataError, run_main
from .hexahedra import face_nodes, outlines, patches, smooth
from .painter import bodies, body_of_points, boundary_faces, merged, normals, turned
from .style import MUTED, plt, save

STRESS = LinearSegmentedColormap.from_list("stress", ["#eef2f5", "#b7cfe0", "#5b9bc4", "#1f5f94", "#0a2342"])
PRESSURE = LinearSegmentedColormap.from_list("pressure", ["#f4f6f8", "#f7d794", "#ef8f3f", "#bb372f", "#4a0d3a"])
PAD = 3  # its number among the parts
PAD_REACH, PAD_DEPTH = 0.12, 0.012  # the sliding face lies within this radius and height of the vertex [m]


def travel_angle(grid: vtu.Grid) -> float:
    """Direction in which the bearing has moved [rad]; 0 while it is at rest."""
    moved = grid.point_data["displacement"]
    slider = grid.points[:, 2] > grid.points[:, 2].max() - 1e-6
    x, y = moved[slider].mean(axis=0)[:2]
    if _is_half(grid.points):
        y = 0.0  # in its plane, whatever its half of the face does
    return float(np.arctan2(y, x)) if np.hypot(x, y) > 1e-4 else 0.0


def _is_half(points: np.ndarray) -> bool:
    return bool(points[:, 1].min() > -1e-6 or points[:, 1].max() < 1e-6)


class Stack:
    """The model turned so that it has moved towards +x."""

    def __init__(self, grid: vtu.Grid) -> None:
        for name in ("displacement", "contact_pressure_MPa", "von_mises_MPa"):
            if name not in grid.point_data:
                raise DataError(f"the VTU file holds no field `{name}`")
        angle = travel_angle(grid)
        self.cells = grid.hexahedra
        self.points = turned(grid.points, angle)
        self.moved = self.points + turned(grid.point_data["displacement"].astype(float), angle)
        self.pressure = grid.point_data["contact_pressure_MPa"].astype(float)
        self.half = _is_half(self.points)
        self.has_pad = "part" not in grid.point_data or bool(np.any(np.round(grid.point_data["part"]) == PAD))
        self.place = merged(self.points)
        body = body_of_points(self.cells, bodies(self.cells, self.place), len(self.points))
        self.stress = smooth(grid.point_data["von_mises_MPa"].astype(float), self.place, body)

    def cut(self) -> tuple[np.ndarray, np.ndarray]:
        """Nodes (n, 4, 8 or 9, 2) in (x, z) [mm] of the faces on the plane y = 0, and the stress at their corners."""
        faces = face_nodes(self.cells)
        faces = faces[np.all(np.abs(self.points[faces][:, :, 1]) < 1e-6, axis=1)]
        return 1e3 * self.moved[faces][:, :, [0, 2]], self.stress[faces[:, :4]]

    def pad(self) -> tuple[np.ndarray, np.ndarray]:
        """Nodes (n, 4, 8 or 9, 2) in (x, y) [mm] of the sliding face about its own middle, and the pressure at them."""
        faces, _ = boundary_faces(self.cells, self.place)
        quads = self.points[faces[:, :4]]
        sliding = (quads[:, :, 2].min(axis=1) > -1e-6) & (normals(quads)[:, 2] < -0.7)
        if self.has_pad:
            sliding &= ((np.hypot(*quads[:, :, :2].reshape(-1, 2).T).reshape(-1, 4).max(axis=1) < PAD_REACH)
                        & (quads[:, :, 2].max(axis=1) < PAD_DEPTH))
        flat, values = 1e3 * self.points[faces[sliding]][:, :, :2], self.pressure[faces[sliding]]
        if self.half and len(flat):
            flat, values = np.concatenate([flat, flat * [1, -1]]), np.concatenate([values, values])
        return flat, values


def draw(grid: vtu.Grid, path: str, dish: tuple[np.ndarray, np.ndarray] | None = None, said: str = "") -> str:
    """Writes the picture. `dish`: (x, z) [m] of the sliding surface along the cut, drawn as a line. `said`: of the instant."""
    stack = Stack(grid)
    fig, (left, right) = plt.subplots(1, 2, figsize=(7.2, 2.9), layout="constrained",
                                      gridspec_kw={"width_ratios": [2.1, 1.0]})
    _draw_cut(fig, left, stack, dish)
    left.set_title(f"Cut along the travel, true scale{', ' + said if said else ''}")
    _draw_pad(fig, right, stack)
    return save(fig, path)


def _draw_cut(fig: Figure, ax: Axes, stack: Stack, dish: tuple[np.ndarray, np.ndarray] | None) -> None:
    nodes, stress = stack.cut()
    norm = Normalize(0.0, max(np.percentile(stress, 99.0), 1e-3) if len(stress) else 1.0)
    _fill(ax, nodes, stress, STRESS, norm, 0.4)
    if dish is not None:
        ax.plot(1e3 * dish[0], 1e3 * dish[1], color=MUTED, lw=1.2)
    corners = nodes.reshape(-1, 2)
    ax.set_xlim(corners[:, 0].min() - 15, corners[:, 0].max() + 15)
    ax.set_ylim(min(corners[:, 1].min(), 0) - 10, corners[:, 1].max() + 10)
    ax.set_aspect("equal", adjustable="box")
    ax.grid(False)
    ax.set(xlabel="along the travel (mm)", ylabel="z (mm)")
    bar = fig.colorbar(ScalarMappable(norm, STRESS), ax=ax, orientation="horizontal", shrink=0.6, aspect=35, extend="max")
    bar.set_label("von Mises stress (MPa)")
    bar.outline.set_visible(False)


def _fill(ax: Axes, nodes: np.ndarray, values: np.ndarray, colours: LinearSegmentedColormap, norm: Normalize, strength: float) -> None:
    """Faces in the plane, shaded; `strength` of their cells' edges, 0..1."""
    quads, shades = patches(nodes, values)
    ax.add_collection(PolyCollection(quads, facecolors=colours(norm(shades)), edgecolors="face", linewidths=0.3))
    ax.add_collection(PolyCollection(outlines(nodes), facecolors="none", edgecolors=(0.1, 0.15, 0.2, strength), linewidths=0.3))


def _draw_pad(fig: Figure, ax: Axes, stack: Stack) -> None:
    nodes, pressure = stack.pad()
    if not len(nodes):
        ax.axis("off")
        return
    norm = Normalize(0.0, max(pressure.max(), 1e-3))
    _fill(ax, nodes, pressure, PRESSURE, norm, 0.3)
    reach = 1.05 * np.abs(nodes).max()
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel="along the travel (mm)",
           title=f"Pressure under the {'pad' if stack.has_pad else 'slider'}")
    ax.set_aspect("equal", adjustable="box")
    ax.grid(False)
    bar = fig.colorbar(ScalarMappable(norm, PRESSURE), ax=ax, orientation="horizontal", shrink=0.9, aspect=22)
    bar.set_label(f"MPa, largest {pressure.max():.0f}")
    bar.outline.set_visible(False)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.stack_picture", description=__doc__.splitlines()[0])
    parser.add_argument("vtu")
    parser.add_argument("png")
    options = parser.parse_args(arguments)
    draw(vtu.read(options.vtu), options.png)


if __name__ == "__main__":
    run_main(main)
