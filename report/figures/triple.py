"""A triple friction pendulum: its section to scale, at rest and against all its rims; travel and rim force of its four faces."""
from typing import Any

import numpy as np
from matplotlib.patches import Polygon

from ..run_folder import Run
from ..style import DPI, FE, INK, MUTED, figure, plt, save, shared_legend
from ..triple import Face, faces, lengths, turns

STEEL, SLIDER, INNER = "#d7dee5", "#b9cfe2", "#e9d8b4"
WIDTH, SHARP = 4.7, 300
NAMES = ("1, bottom plate", "2, lower slide plate", "3, upper slide plate", "4, top plate")
COLOURS = ("#1f5fa8", "#c8741a", "#8a5aa8", "#2f8f5b")


def section(isolator: dict[str, Any], path: str) -> str:
    """`isolator`: the resolved [isolator] table. Throws ValueError where a dimension is missing."""
    known = faces(isolator)
    if not known:
        raise ValueError("the scene does not give every dimension of the triple pendulum")
    high = known[0].height + known[3].height
    reach = max(face.rim_radius for face in (known[0], known[3])) * 1.08
    travel = sum(length * np.sin(turn) for length, turn in zip(lengths(known), turns(known)))
    base = 0.35 * high
    fig, ax = plt.subplots(figsize=(WIDTH, WIDTH * (1.6 * high + 2 * base) / (2 * reach + travel)), layout="constrained")
    for at_rest in (True, False):
        style = dict(facecolor="none", edgecolor=MUTED, ls=(0, (3, 1.6))) if at_rest else dict(edgecolor=INK)
        for outline, fill in bodies(known, (0.0, 0.0, 0.0) if at_rest else turns(known), reach, base):
            ax.add_patch(Polygon(1e3 * outline, closed=True, lw=0.7, zorder=2 if at_rest else 3, **(style if at_rest else style | {"facecolor": fill})))
    ax.set_xlim(-1e3 * reach * 1.03, 1e3 * (reach + travel) * 1.03)
    ax.set_aspect("equal"), ax.autoscale_view(scalex=False), ax.axis("off")
    ax.annotate(f"L$_c$ = {1e3 * travel:.0f} mm", (1e3 * travel, 1e3 * (high + base)), ha="center", va="bottom", color=FE, fontsize=7)
    return save(fig, path, dpi=SHARP)


def bodies(known: list[Face], turn: tuple[float, float, float], reach: float, base: float) -> list[tuple[np.ndarray, str]]:
    """Outlines (n, 2) in m and their colours: plates, slide plates, inner slider at these turns."""
    length = lengths(known)
    down = [np.array([np.sin(a), -np.cos(a)]) for a in turn]
    first = np.array([0.0, known[0].radius])  # the centres of the four spheres, as they hang on each other
    second = first + length[0] * down[0]
    third = second + length[1] * down[1]
    fourth = third + length[2] * down[2]

    def arc(centre: np.ndarray, face: Face, half: float, axis: float, side: int) -> np.ndarray:
        """Of a face about its axis, from -half to half; side -1: below its centre."""
        angle = np.linspace(-np.arcsin(half / face.radius), np.arcsin(half / face.radius), 41) * -side
        return centre + face.radius * np.column_stack([side * -np.sin(axis + angle), side * np.cos(axis + angle)])

    def ring(lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
        return np.vstack([lower, upper[::-1] if np.dot(lower[-1] - lower[0], upper[-1] - upper[0]) > 0 else upper])

    def plate(centre: np.ndarray, face: Face, side: int) -> np.ndarray:
        """Of bottom (side -1) or top: the dish, its rim, and a straight back."""
        dish = arc(centre, face, face.rim_radius, 0.0, side)
        dish = dish[np.argsort(dish[:, 0])]
        lip = dish[-1, 1] - side * face.rim_height
        back, wide = centre[1] + side * (face.radius + base), centre[0] + np.array([-reach, reach])
        return np.vstack([[wide[0], back], [wide[0], lip], [dish[0, 0], lip], dish, [dish[-1, 0], lip], [wide[1], lip], [wide[1], back]])

    a1, a2, a3 = turn
    return [(plate(first, known[0], -1), STEEL),
            (ring(arc(first, known[0], known[0].half, a1, -1), arc(second, known[1], known[1].rim_radius, a1, -1)), SLIDER),
            (ring(arc(second, known[1], known[1].half, a2, -1), arc(third, known[2], known[2].half, a2, 1)), INNER),
            (ring(arc(third, known[2], known[2].rim_radius, a3, 1), arc(fourth, known[3], known[3].half, a3, 1)), SLIDER),
            (plate(fourth, known[3], 1), STEEL)]


def travel(run: Run, path: str, dpi: int = DPI) -> str:
    """What each face adds to the displacement, and the force of its rim, over time."""
    fig, grid = figure(1, 2, 2.5)
    for i, (name, colour) in enumerate(zip(NAMES, COLOURS), 1):
        x, y = run.signals[f"face_{i}_travel_x"], run.signals[f"face_{i}_travel_y"]
        grid.flat[0].plot(run.time, 1e3 * (x if not np.any(y) else np.hypot(x, y)), color=colour, lw=0.9, label=f"face {name}")
        grid.flat[1].plot(run.time, 1e-3 * run.signals[f"face_{i}_rim_force"], color=colour, lw=0.9)
    for ax, title, unit in zip(grid.flat, ("Displacement by face", "Rim forces"), ("displacement (mm)", "force (kN)")):
        ax.set_title(title), ax.set_xlabel(run.time_label), ax.set_ylabel(unit)
    shared_legend(fig, [grid.flat[0]])
    return save(fig, path, dpi)
