"""One frame of a film: the deformed model, the cut along its travel, and where on the force's curve it stands."""
import io
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from . import vtu
from .errors import DataError
from .hexahedra import outlines, patches, smooth
from .painter import bodies, body_of_points, boundary_faces, merged, paint, turned, view
from .run_folder import Run
from .stack_picture import travel_angle
from .stored_fields import said_of
from .style import FE, MUTED, RIM, plt, write_png

DPI = 110
STRESS = LinearSegmentedColormap.from_list("stress", ["#e8edf2", "#9cc3dd", "#4f9d8f", "#f2c14e", "#e4572e", "#7a0f2b"])
EDGE = (0.1, 0.15, 0.2, 0.3)


@dataclass
class Stretch:
    """Instants on one mesh: times [s] and, for each, displacement (n, 3) [m] and stress (n,) [MPa] at the grid's points."""
    grid: vtu.Grid
    times: np.ndarray
    moved: np.ndarray
    stress: np.ndarray

    def at(self, time: float) -> tuple[np.ndarray, np.ndarray]:
        """(displacement, stress), linear between the stored instants."""
        i = int(np.clip(np.searchsorted(self.times, time, side="right") - 1, 0, len(self.times) - 2))
        share = np.clip((time - self.times[i]) / (self.times[i + 1] - self.times[i]), 0.0, 1.0)
        moved, stress = ((1 - share) * values[i] + share * values[i + 1] for values in (self.moved, self.stress))
        return moved, stress


def read(files: list[tuple[str, float]]) -> Stretch:
    """Throws DataError where a field is missing or the mesh changes."""
    grids = [vtu.read(file) for file, _ in files]
    first = grids[0]
    for (file, _), grid in zip(files, grids):
        for name in ("displacement", "von_mises_MPa"):
            if name not in grid.point_data:
                raise DataError(f"{file} holds no field `{name}`")
        if grid.points.shape != first.points.shape or not np.allclose(grid.points, first.points, atol=1e-6):
            raise DataError(f"{file} is of another mesh than {files[0][0]}")
    place = merged(first.points)
    body = body_of_points(first.hexahedra, bodies(first.hexahedra, place), len(first.points))
    return Stretch(first, np.array([time for _, time in files]), np.array([grid.point_data["displacement"] for grid in grids], float),
                   np.array([smooth(grid.point_data["von_mises_MPa"].astype(float), place, body) for grid in grids]))


class Camera:
    """Draws every frame with the same axes and the same colours."""

    def __init__(self, stretch: Stretch, run: Run) -> None:
        self.stretch, self.run = stretch, run
        grid = stretch.grid
        y = grid.points[:, 1]
        self.half = y.min() > -1e-6 or y.max() < 1e-6
        self.angle = self._angle()
        self.points = turned(grid.points, self.angle)
        self.faces, _ = boundary_faces(grid.hexahedra, merged(grid.points))
        self.cut = self.faces[np.all(np.abs(self.points[self.faces][:, :, 1]) < 1e-6, axis=1)]
        self.norm = Normalize(0.0, max(float(np.percentile(stretch.stress.max(axis=0), 99.5)), 1e-3))

    def _angle(self) -> float:
        """Direction of the travel [rad]: to the sector of rim that is modelled, else to where the bearing goes farthest."""
        points = self.stretch.grid.points
        x, y = points[:, :2].mean(axis=0)
        if np.hypot(x, y) > 0.15 * np.ptp(points[:, :2], axis=0).max():
            return float(np.arctan2(0.0 if self.half else y, x))
        far = int(np.argmax(np.abs(self.stretch.moved[:, :, :2]).max(axis=(1, 2))))
        return travel_angle(vtu.Grid(points, self.stretch.grid.hexahedra, {"displacement": self.stretch.moved[far]}, {}))

    def frame(self, time: float) -> bytes:
        """PNG."""
        moved, stress = self.stretch.at(time)
        place = self.points + turned(moved, self.angle)
        fig = plt.figure(figsize=(7.2, 4.4), layout="constrained")
        grid = fig.add_gridspec(2, 2, height_ratios=[2.6, 1.0], width_ratios=[1.5, 1.0])
        body, cut, history = fig.add_subplot(grid[0, 0]), fig.add_subplot(grid[0, 1]), fig.add_subplot(grid[1, :])
        self._body(body, place, stress)
        self._cut(cut, place, stress)
        self._history(history, time)
        bar = fig.colorbar(ScalarMappable(self.norm, STRESS), ax=[body, cut], orientation="horizontal", shrink=0.5, aspect=40, extend="max")
        bar.set_label("von Mises stress (MPa)")
        bar.outline.set_visible(False)
        return _png(fig)

    def _body(self, ax: Axes, place: np.ndarray, stress: np.ndarray) -> None:
        quads, values = patches(place[self.faces], stress[self.faces[:, :4]], 4 if self.faces.shape[1] > 4 else 2)
        rings = outlines(place[self.faces])
        if self.half:
            quads, rings = (np.concatenate([r, np.roll((r * [1, -1, 1])[:, ::-1], 1, axis=1)]) for r in (quads, rings))
            values = np.concatenate([values, values])
        paint(ax, quads, STRESS(self.norm(values)), view(215, 30), outlines=rings, edge=EDGE, line_width=0.25)
        ax.set_title("Displacements in true scale")

    def _cut(self, ax: Axes, place: np.ndarray, stress: np.ndarray) -> None:
        if not len(self.cut):
            ax.axis("off")
            return
        quads, values = patches(1e3 * place[self.cut][:, :, [0, 2]], stress[self.cut[:, :4]])
        ax.add_collection(PolyCollection(quads, facecolors=STRESS(self.norm(values)), edgecolors="face", linewidths=0.3))
        ax.add_collection(PolyCollection(outlines(1e3 * place[self.cut][:, :, [0, 2]]), facecolors="none", edgecolors=EDGE, linewidths=0.3))
        ends = self.points[self.cut.ravel()][:, [0, 2]]
        right, top = 1e3 * ends.max(axis=0)
        wide = 150 if self.run.rung == "rim" or self.run.impacts else 1e3 * np.ptp(ends[:, 0]) + 30
        ax.set(xlim=(right - wide, right + 25), xlabel="along the travel (mm)", ylabel="z (mm)", title="Cut along the travel")
        ax.set_ylim(top - wide, top + 25)
        ax.set_aspect("equal", adjustable="box")
        ax.grid(False)

    def _history(self, ax: Axes, time: float) -> None:
        run, times = self.run, self.stretch.times
        name = "impact" if run.has("impact_x", "impact_y") and np.any(run.norm("impact") > 0) else "force"
        near = (run.time >= times[0] - 0.1 * np.ptp(times)) & (run.time <= times[-1] + 0.1 * np.ptp(times)) if run.has("time") else []
        if run.has("time", f"{name}_x", f"{name}_y") and np.any(near):
            force = 1e-3 * run.norm(name)
            ax.plot(run.time[near], force[near], color=FE, lw=1.2)
            ax.plot(time, np.interp(time, run.time, force), "o", ms=5, color=RIM)
        ax.axvline(time, color=RIM, lw=0.7)
        ax.plot(times, np.zeros_like(times), "|", ms=5, color=MUTED)
        ax.set(xlabel=f"{run.time_label}: {said_of(run, time)}", ylabel=f"{'rim' if name == 'impact' else 'lateral'} force (kN)")


def _png(fig: Figure) -> bytes:
    held = io.BytesIO()
    write_png(fig, held, DPI)
    plt.close(fig)
    return held.getvalue()
