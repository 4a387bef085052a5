"""Draws an entry as the thesis lays it out: its panels and axes, finite elements below, the reduced model above."""
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..run_folder import Run
from ..style import CYCLE, FE, FITTED, MUTED, WIDTH, figure, literal, plt, save, shared_legend
from .catalogue import Entry
from .pair import draw_pair, draw_region
from .probabilities import draw_hazard, draw_probabilities, draw_reductions
from .runs import Runs
from .spectrum import draw_spectra

SIDES = {"fe": dict(color=FE, lw=1.9, zorder=2), "physical": dict(color=FITTED, lw=1.0, zorder=4)}


def series(run: Run, name: str) -> np.ndarray | None:
    """A signal by name; "-force_x" turned about, "/W" over the dead load, "|u|" and "|F|" as norms, "/L" over what follows."""
    sign = -1.0 if name.startswith("-") else 1.0
    base, _, divisor = name.lstrip("-").partition("/")
    values = run.norm("displacement") if base == "|u|" else run.norm("force") if base == "|F|" else run.signals.get(base)
    if values is None:
        return None
    over = 1e3 * run.get("load", "vertical_kN", default=1.0) if divisor == "W" else float(divisor) if divisor else 1.0
    return sign * values / over


def draw(entry: Entry, runs: Runs, path: str) -> str | None:
    """Gives the picture's path, or None where none of its curves is there."""
    if not entry.panels:
        return None
    columns = min(entry.columns, len(entry.panels))
    rows = -(-len(entry.panels) // columns)
    fig, grid = figure(rows, columns, 0.45 + 2.15 * rows, WIDTH)
    drawn = [_panel(ax, panel, runs) for ax, panel in zip(grid.flat, entry.panels)]
    for ax in list(grid.flat)[len(entry.panels):]:
        ax.axis("off")
    if not any(drawn):
        plt.close(fig)
        return None
    shared_legend(fig, list(grid.flat), 3)
    return save(fig, path)


def _panel(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    kind = panel.get("kind", "curves")
    drawn = {"curves": _curves, "ellipses": _ellipses, "spectra": draw_spectra, "bars": _bars, "pair": draw_pair, "region": draw_region,
             "probabilities": draw_probabilities, "reductions": draw_reductions, "hazard": draw_hazard}[kind](ax, panel, runs)
    if drawn:
        _marks(ax, panel, runs)
    ax.set_title(literal(panel.get("title", "")))
    ax.set_xlabel(panel.get("x_label", ""))
    ax.set_ylabel(panel.get("y_label", ""))
    for key, put in (("x_range", ax.set_xlim), ("y_range", ax.set_ylim)):
        if key in panel:
            put(panel[key])
    if not drawn:
        ax.text(0.5, 0.5, "not run", transform=ax.transAxes, ha="center", color=MUTED)
    return drawn


def _curves(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    n = 0
    for k, curve in enumerate(panel["curves"]):
        run = runs.response(curve["run"])
        if run is None:
            continue
        x = series(run, curve.get("x", panel.get("x", "time")))
        y = series(run, curve.get("y", panel.get("y", "displacement_x")))
        if x is None or y is None:
            continue
        style = SIDES.get(curve.get("side"), dict(color=CYCLE[k % len(CYCLE)], lw=1.0))
        ax.plot(panel.get("x_factor", 1.0) * x, panel.get("y_factor", 1.0) * y, label=literal(curve["label"]), **style)
        n += 1
    return n > 0


def _marks(ax: Axes, panel: dict[str, Any], runs: Runs) -> None:
    """Printed numbers as dashed lines, each in the colour of the curve whose extreme it is."""
    for k, mark in enumerate(panel.get("marks", [])):
        curve = int(mark.get("curve", k))
        style = SIDES.get(panel["curves"][curve].get("side"), dict(color=CYCLE[curve % len(CYCLE)]))
        ax.axhline(mark.get("factor", 1.0) * runs.catalogue.printed(mark["entry"], mark["number"]), color=style["color"], lw=0.7, ls=(0, (4, 3)),
                   zorder=1, label="printed in the thesis" if k == 0 else None)


def _ellipses(ax: Axes, panel: dict[str, Any], _: Runs) -> bool:
    """Plane ellipses z = b (1 - sqrt(1 - (x/a)^2)), b = a^2/R0, over their half-width."""
    for k, shape in enumerate(panel["shapes"]):
        a, b = shape["a_m"], shape["a_m"] ** 2 / shape["R0_m"]
        x = a * np.sin(np.linspace(-np.pi / 2, np.pi / 2, 401))
        ax.plot(x, b * (1 - np.sqrt(np.maximum(0, 1 - (x / a) ** 2))), label=literal(shape["label"]), color=CYCLE[k % len(CYCLE)], lw=1.0)
    ax.set_aspect("equal", adjustable="datalim")
    return True


def _bars(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """One bar a run: the number at `y` of its summary."""
    labels, values = [], []
    for curve in panel["curves"]:
        summary = runs.summary(curve["run"])
        if summary is not None and summary.get(panel["y"]) is not None:
            labels.append(curve["label"])
            values.append(panel.get("y_factor", 1.0) * summary[panel["y"]])
    ax.bar(range(len(values)), values, color=FITTED, width=0.6)
    ax.set_xticks(range(len(labels)), labels)
    return bool(values)
