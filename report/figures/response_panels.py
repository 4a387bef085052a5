"""The panels of thesis Figures 2-7 and 2-8: displacement, lateral force, loop, vertical displacement.

Forces are drawn as −F, so that a positive displacement meets a positive force and loops read as in the thesis."""
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..run_folder import Run
from ..style import DPI, MUTED, RIM, figure, line_of, literal, save, shared_legend


def draw(models: list[tuple[str, Run]], labels: dict[str, str], capacity: float | None, path: str, dpi: int = DPI) -> str:
    """models: (role, run) pairs, the reference first; `labels` by role; `capacity`: L_c [m] or None. One line of motion gives four panels, a plane motion six."""
    planar = all(run.is_planar() for _, run in models)
    if planar:
        fig, grid = figure(2, 2, 4.5)
        panels = dict(zip(("u", "F", "loop", "z"), grid.flat))
        _draw_direction(panels, models, models[0][1].direction(), "", labels)
    else:
        fig, grid = figure(3, 2, 6.4)
        panels = dict(zip(("u", "F", "loop", "loop_y", "path", "z"), grid.flat))
        _draw_plane(panels, models, labels)
    _draw_vertical(panels["z"], models)
    _draw_capacity(panels, capacity, planar)
    _letters(grid.flat)
    shared_legend(fig, [panels["u"]])
    return save(fig, path, dpi)


def _draw_direction(panels: dict[str, Axes], models: list[tuple[str, Run]], direction: np.ndarray, axis: str, labels: dict[str, str]) -> None:
    for role, run in models:
        u = 1e3 * run.along("displacement", direction)
        force = -1e-3 * run.along("force", direction) if run.has("force_x", "force_y") else np.zeros_like(u)
        style = line_of(role)
        panels["u"].plot(run.time, u, label=literal(labels[role]), **style)
        panels["F"].plot(run.time, force, **style)
        panels["loop"].plot(u, force, **style)
    _name(panels["u"], "Lateral displacement", models[0][1].time_label, f"displacement u{axis} (mm)")
    _name(panels["F"], "Lateral force", models[0][1].time_label, f"lateral force −F{axis} (kN)")
    _name(panels["loop"], "Loop", f"displacement u{axis} (mm)", f"lateral force −F{axis} (kN)")


def _draw_plane(panels: dict[str, Axes], models: list[tuple[str, Run]], labels: dict[str, str]) -> None:
    for role, run in models:
        ux, uy = 1e3 * run.signals["displacement_x"], 1e3 * run.signals["displacement_y"]
        fx, fy = -1e-3 * run.signals["force_x"], -1e-3 * run.signals["force_y"]
        size, force = np.hypot(ux, uy), np.hypot(fx, fy)
        style = line_of(role)
        panels["u"].plot(run.time, size, label=literal(labels[role]), **style)
        panels["F"].plot(run.time, force, **style)
        panels["loop"].plot(ux, fx, **style)
        panels["loop_y"].plot(uy, fy, **style)
        panels["path"].plot(ux, uy, **style)
    _name(panels["u"], "Lateral displacement, norm", models[0][1].time_label, "|u| (mm)")
    _name(panels["F"], "Lateral force, norm", models[0][1].time_label, "|F| (kN)")
    _name(panels["loop"], "Loop in x", "displacement u$_x$ (mm)", "lateral force −F$_x$ (kN)")
    _name(panels["loop_y"], "Loop in y", "displacement u$_y$ (mm)", "lateral force −F$_y$ (kN)")
    _name(panels["path"], "Path in plan", "u$_x$ (mm)", "u$_y$ (mm)")
    panels["path"].set_aspect("equal", adjustable="box")


def _draw_vertical(ax: Axes, models: list[tuple[str, Run]]) -> None:
    for role, run in models:
        if run.has("displacement_z"):
            z = 1e3 * run.signals["displacement_z"]
            ax.plot(run.time, z, **line_of(role))
    _name(ax, "Vertical displacement", models[0][1].time_label, "u$_z$ (mm), up positive")


def _draw_capacity(panels: dict[str, Axes], capacity: float | None, planar: bool) -> None:
    if not capacity:
        return
    mm = 1e3 * capacity
    style = dict(color=RIM, lw=0.7, ls=(0, (1, 1.5)), zorder=1)
    for level in ((mm, -mm) if planar else (mm,)):
        panels["u"].axhline(level, **style)
    panels["u"].annotate(f"L$_c$ = {mm:.0f} mm", (1.0, mm), xycoords=("axes fraction", "data"), ha="right", va="bottom",
                         xytext=(0, 1.5), textcoords="offset points", color=RIM, fontsize=6.5)
    for name in ("loop", "loop_y"):
        for level in (mm, -mm):
            if name in panels and abs(panels[name].get_xlim()[0 if level < 0 else 1]) >= 0.6 * mm:
                panels[name].axvline(level, **style)
    if "path" in panels:
        angle = np.linspace(0, 2 * np.pi, 181)
        panels["path"].plot(mm * np.cos(angle), mm * np.sin(angle), **style)


def _name(ax: Axes, title: str, x: str, y: str) -> None:
    ax.set_title(title)
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if x in ("time (s)", "load parameter (–)"):
        ax.margins(x=0)
        ax.axhline(0, color=MUTED, lw=0.4, zorder=0)


def _letters(axes: Any) -> None:
    for letter, ax in zip("abcdef", axes):
        ax.set_title(f"({letter}) {ax.get_title(loc='left')}")
