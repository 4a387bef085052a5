"""Storeys: the largest drift, shear and acceleration over the height, and every storey's drift with the roof over time."""
import numpy as np
from matplotlib import colormaps

from ..building_tables import floor_count, storeys
from ..interactive import Line, Panel, kept
from ..numbers import is_number
from ..run_folder import Run
from ..style import FE, FITTED, MUTED, figure, save, shared_legend

G = 9.80665
PROFILES = (("peak_drift_m", 1e3, "largest drift (mm)"), ("peak_shear_N", 1e-3, "largest shear (kN)"),
            ("peak_acceleration_m_s2", 1 / G, "largest acceleration of its floor (g)"))


def draw_profiles(run: Run, path: str) -> str | None:
    """None where the summary has fewer than two storeys."""
    rows = storeys(run)
    shown = [item for item in PROFILES if rows and all(is_number(row.get(item[0])) for row in rows)]
    if len(rows) < 2 or not shown:
        return None
    fig, grid = figure(1, len(shown), 0.9 + 0.22 * min(len(rows), 12), sharey=True)
    number = np.arange(1, len(rows) + 1)
    for ax, (key, factor, label) in zip(grid[0], shown):
        ax.barh(number, [factor * row[key] for row in rows], height=0.62, color=FE)
        ax.set_xlabel(label)
        ax.grid(axis="y", visible=False)
    grid[0, 0].set_ylabel("storey")
    grid[0, 0].set_yticks(number if len(rows) <= 12 else number[::max(1, len(rows) // 8)])
    return save(fig, path)


def histories(run: Run) -> list[Panel]:
    """Drift of each storey and the roof's motion of a building on many bearings; empty for other runs."""
    floors, panels = floor_count(run), []
    for axis in "xy":
        names = [f"floor_{i}_drift_{axis}" for i in range(1, floors + 1)]
        if names and run.has(*names) and max(np.abs(run.signals[name]).max() for name in names) > 1e-9:
            panels.append(Panel(f"Drift of the storeys along {axis}", run.time_label, "drift (mm)",
                                [_line(run, name, 1e3, f"storey {i}", _colour(i, floors)) for i, name in enumerate(names, 1)], group="t"))
    for part, factor, title, label in (("displacement", 1e3, "Roof, relative to the ground", "displacement (mm)"),
                                       ("acceleration", 1 / G, "Roof's acceleration, absolute", "acceleration (g)")):
        lines = [_line(run, f"floor_{floors}_{part}_{axis}", factor, f"roof, {axis}", colour) for axis, colour in (("x", FE), ("y", FITTED))
                 if run.has(f"floor_{floors}_{part}_{axis}") and np.abs(run.signals[f"floor_{floors}_{part}_{axis}"]).max() > 1e-9]
        panels.append(Panel(title, run.time_label, label, lines, group="t"))
    return [panel for panel in panels if panel.lines]


def _colour(i: int, n: int) -> str:
    return "#" + "".join(f"{round(255 * c):02x}" for c in colormaps["viridis_r"](0.15 + 0.8 * (i - 1) / max(1, n - 1))[:3])


def _line(run: Run, name: str, factor: float, label: str, colour: str) -> Line:
    at = kept([run.time, run.signals[name]])
    return Line(label, run.time[at], factor * run.signals[name][at], colour)


def draw_histories(run: Run, path: str) -> str | None:
    panels = histories(run)
    if not panels:
        return None
    rows = -(-len(panels) // 2)
    fig, grid = figure(rows, 2, 0.5 + 1.85 * rows)
    for ax in grid.flat[len(panels):]:
        ax.axis("off")
    for ax, panel in zip(grid.flat, panels):
        for line in panel.lines:
            ax.plot(line.x, line.y, color=line.colour, lw=0.9, label=line.label)
        ax.set(title=panel.title, xlabel=panel.x, ylabel=panel.y)
        ax.margins(x=0)
        ax.axhline(0, color=MUTED, lw=0.4, zorder=0)
    shared_legend(fig, grid.flat[:len(panels)], n_columns=6)
    return save(fig, path)
