"""python3 -m report.film DIR [--output FILE.html] [--frames N]: a film of the longest stretch of stored fields of a run.

Frames stand at equal steps of time. Between stored instants displacements and stresses are interpolated linearly. FILE.html holds
the frames and plays them; FILE.mp4 is written beside it where ffmpeg is installed."""
import argparse
import base64
import io
import os
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from . import page, vtu
from .blocks import Section, note
from .errors import DataError, IoError, run_main
from .files import remove, write_whole
from .hexahedra import outlines, patches, smooth
from .painter import bodies, body_of_points, boundary_faces, merged, paint, turned, view
from .run_folder import Run, load_run
from .sections.common import instants, said_of, title_of
from .stack_picture import travel_angle
from .style import FE, MUTED, RIM, plt

LEAST = 5       #: stored instants of which a film is made
FRAMES = 32
DPI = 110
FAR = 6.0       #: a gap between instants so many times the median ends a stretch
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
        return tuple((1 - share) * values[i] + share * values[i + 1] for values in (self.moved, self.stress))


def longest(files: list[tuple[str, float | None]]) -> list[tuple[str, float]]:
    """The instants of the longest stretch in which times rise without a large gap; empty where there are fewer than LEAST."""
    timed = [(file, time) for file, time in files if time is not None]
    if len(timed) < LEAST:
        return []
    steps = np.diff([time for _, time in timed])
    rising = steps[steps > 0]
    if not len(rising):
        return []
    ends = np.flatnonzero((steps <= 0) | (steps > FAR * np.median(rising))) + 1
    stretches = [timed[a:b] for a, b in zip([0, *ends], [*ends, len(timed)])]
    best = max(stretches, key=len)
    return best if len(best) >= LEAST else []


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
        angle = travel_angle(vtu.Grid(grid.points, grid.hexahedra, {"displacement": stretch.moved[-1]}, {}))
        if abs(np.ptp(grid.points[:, 1])) > 0 and grid.points[:, 0].mean() < 0 and abs(angle) < 0.1:
            angle = np.pi
        self.angle = angle
        self.points = turned(grid.points, angle)
        self.faces, _ = boundary_faces(grid.hexahedra, merged(grid.points))
        y = self.points[:, 1]
        self.half = y.min() > -1e-6 or y.max() < 1e-6
        self.cut = self.faces[np.all(np.abs(y[self.faces]) < 1e-6, axis=1)]
        self.norm = Normalize(0.0, max(float(np.percentile(stretch.stress.max(axis=0), 99.5)), 1e-3))

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
    fig.savefig(held, format="png", dpi=DPI)
    plt.close(fig)
    return held.getvalue()


def make(run: Run, output: str, n_frames: int = FRAMES, progress: Callable[[int], None] = lambda done: None) -> list[str]:
    """Writes the film; gives the files. Empty where the run holds fewer than LEAST instants in one stretch."""
    files = longest(instants(run))
    if not files:
        return []
    stretch = read(files)
    times = np.linspace(stretch.times[0], stretch.times[-1], n_frames)
    camera = Camera(stretch, run)
    frames = []
    for i, time in enumerate(times):
        frames.append(camera.frame(time))
        progress(i + 1)
    _write_page(run, output, times, frames, len(files))
    return [output, *_write_mp4(os.path.splitext(output)[0] + ".mp4", frames)]


def _write_page(run: Run, output: str, times: np.ndarray, frames: list[bytes], n_stored: int) -> None:
    apart = f", {1e3 * (times[1] - times[0]):.3g} ms apart," if "time" in run.time_label else ""
    section = Section("film", "Film", lead=f"{len(frames)} frames{apart} of {n_stored} stored instants (ticks below the curve); linear between them.")
    section.add({"kind": "frames", "frames": ["data:image/png;base64," + base64.b64encode(frame).decode() for frame in frames],
                 "labels": [said_of(run, float(time)) for time in times]})
    if run.status != "done":
        section.add(note(f"The run is {run.status}: the film shows what is stored.", "warning"))
    page.write(output, "page.html.j2", title=title_of(run.name), subtitle=f"Finite elements, rung {run.rung}", sections=[section], problems=[],
               footer=run.meta.get("version", ""))


def _write_mp4(path: str, frames: list[bytes]) -> list[str]:
    """With ffmpeg, where it is installed; an earlier film goes first."""
    remove(path)
    program = shutil.which("ffmpeg")
    if program is None:
        return []
    command = [program, "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", "12", "-c:v", "png", "-i", "-", "-vf",
               "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-movflags", "frag_keyframe+empty_moov", "-f", "mp4", "-"]
    try:
        done = subprocess.run(command, input=b"".join(frames), capture_output=True, timeout=300)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise IoError(f"{program} made no film: {error}") from None
    if done.returncode != 0 or not done.stdout:
        raise IoError(f"{program} made no film: {(done.stderr.decode(errors='replace').strip().splitlines() or ['it gave no reason'])[-1]}")
    write_whole(path, lambda file: file.write(done.stdout))
    return [path]


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.film", description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE.html", help="DIR/film.html when not given")
    parser.add_argument("--frames", type=int, default=FRAMES, choices=range(2, 501), metavar="N", help=f"2..500, {FRAMES} when not given")
    options = parser.parse_args(arguments)
    if not os.path.isdir(options.folder):
        raise DataError(f"{options.folder} is not a folder")
    made = make(load_run(options.folder), options.output or os.path.join(options.folder, "film.html"), options.frames)
    if not made:
        raise DataError(f"{options.folder} holds fewer than {LEAST} fields in one stretch of time; a film needs as many")
    print(*made, sep="\n")


if __name__ == "__main__":
    run_main(main)
