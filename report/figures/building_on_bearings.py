"""A building on many bearings: the plan with every bearing's orbit inside its rim, and elevations at the hardest impact."""
import csv
import os

import numpy as np
from matplotlib.axes import Axes

from ..errors import DataError
from ..run_folder import Run
from ..style import FE, FITTED, MUTED, RIM, figure, save


def draw(run: Run, path: str) -> str:
    nodes, elements = _rows(run, "nodes.csv"), _rows(run, "elements.csv")
    at_hardest = _rows(run, "elevation.csv")
    at = np.array([[row["x_m"], row["y_m"], row["z_m"]] for row in nodes], float)
    moved = np.array([[row["ux_m"], row["uy_m"], row["uz_m"]] for row in at_hardest], float)
    bearings = [i for i, row in enumerate(nodes) if row["bearing"] not in ("0", "")]
    members = [(int(row["i"]) - 1, int(row["j"]) - 1) for row in elements]
    axes = [axis for axis in (0, 1) if np.ptp(at[:, axis]) > 0]  # one of a frame in the plane
    fig, grid = figure(1, 1 + len(axes), 3.6, gridspec_kw={"width_ratios": [1.25] + [1] * len(axes)})
    _plan(grid[0, 0], run, at, bearings, at_hardest)
    scale = 0.18 * np.ptp(at[:, :2]) / max(np.abs(moved).max(), 1e-9)
    time = float(at_hardest[0]["time_s"])
    for ax, axis in zip(grid[0, 1:], axes):
        _elevation(ax, at, moved, members, axis, scale)
        _hinges(ax, run, at + scale * moved, members, axis)
        ax.set_title(f"Along {'xy'[axis]} at {time:.2f} s")
    grid[0, 1].set_ylabel("height (m)")
    return save(fig, path)


def _rows(run: Run, name: str) -> list[dict[str, str]]:
    path = os.path.join(run.folder, name)
    try:
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
    except (OSError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not readable ({error})") from None
    if not rows:
        raise DataError(f"{path} holds no rows")
    return rows


def _plan(ax: Axes, run: Run, at: np.ndarray, bearings: list[int], at_hardest: list[dict[str, str]]) -> None:
    """Orbits are drawn larger than the plan, so that they can be read: each fills its share of the closest neighbours' distance."""
    points = at[bearings, :2]
    distance = min((np.hypot(*(p - q)) for i, p in enumerate(points) for q in points[:i]), default=1.0)
    capacity = max(float(np.median(run.signals[f"bearing_{b}_gap"] + np.hypot(run.signals[f"bearing_{b}_displacement_x"], run.signals[f"bearing_{b}_displacement_y"])))
                   for b in range(1, len(bearings) + 1))
    scale = 0.42 * distance / capacity
    angle = np.linspace(0, 2 * np.pi, 121)
    for number, (node, p) in enumerate(zip(bearings, points), 1):
        x, y = (run.signals[f"bearing_{number}_displacement_{axis}"] for axis in "xy")
        gap = run.signals[f"bearing_{number}_gap"]
        own = scale * float(np.median(gap + np.hypot(x, y)))
        ax.plot(p[0] + own * np.cos(angle), p[1] + own * np.sin(angle), color=RIM, lw=0.7)
        ax.plot(p[0] + scale * x, p[1] + scale * y, color=FE, lw=0.6)
        pressed = gap < 0
        if pressed.any():  # no line from one impact to the next
            ax.plot(p[0] + scale * np.where(pressed, x, np.nan), p[1] + scale * y, color=FITTED, lw=1.6, marker=".", ms=1.6)
        force = float(at_hardest[node]["normal_force_N"] or 0) / 1e3
        ax.annotate(f"{number}: {force:.0f} kN", p - [0, own], ha="center", va="top", fontsize=6, color=MUTED,
                    xytext=(0, -1.5), textcoords="offset points")
    ax.set_aspect("equal")
    ax.set(title=f"Plan: orbits × {scale:.0f} in their rims", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.08)


def _hinges(ax: Axes, run: Run, there: np.ndarray, members: list[tuple[int, int]], axis: int) -> None:
    """Ends of inelastic members that yielded in the run, the larger the more."""
    if not os.path.isfile(os.path.join(run.folder, "hinges.csv")):
        return
    for row in _rows(run, "hinges.csv"):
        ductility = float(row["peak_ductility"])
        if ductility > 1:
            ends = members[int(row["element"]) - 1]
            p, q = there[list(ends if row["end"] == "i" else ends[::-1])]
            at = p + 0.06 * (q - p)
            ax.plot(at[axis], at[2], color=FITTED, marker="o", ms=min(2 + 0.3 * ductility, 6), mec="none")


def _elevation(ax: Axes, at: np.ndarray, moved: np.ndarray, members: list[tuple[int, int]], axis: int, scale: float) -> None:
    for i, j in members:
        rest, there = at[[i, j]], at[[i, j]] + scale * moved[[i, j]]
        ax.plot(rest[:, axis], rest[:, 2], color=MUTED, lw=0.4)
        ax.plot(there[:, axis], there[:, 2], color=FE, lw=1.0)
    ax.set_aspect("equal")
    ax.set_xlabel(f"{'xy'[axis]} (m), displacements × {scale:.0f}")
