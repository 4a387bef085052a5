"""How a law does: signed errors of every run beside the published pair's, what the residuals look like; a fit's parameters."""
from collections.abc import Callable
from typing import Any

import numpy as np

from ..calibration_file import Calibration
from ..numbers import is_number
from ..results import Entry, Run
from ..series import contact_stretches, impact_curve
from ..style import FE, FITTED, INK, MUTED, PUBLISHED, figure, literal, save, shared_legend

METRICS = (("peak_force", "peak impact force"), ("rebound", "rebound speed"),
           ("peak_displacement", "peak displacement"))


def draw_errors(rows: list[dict[str, Any]], law: str, path: str) -> str | None:
    """rows: {"name", "fitted": {metric: error}, "published": {...}}; a group of bars a run, a panel a metric. `law`: of "fitted"."""
    rows = [row for row in rows if row["fitted"] or row["published"]]
    if not rows:
        return None
    fig, grid = figure(1, 3, 0.75 + 0.34 * len(rows), sharey=True)
    y = np.arange(len(rows))[::-1]
    for ax, (metric, title) in zip(grid[0], METRICS):
        both = any(row["published"] for row in rows)
        for shift, who, colour in ((0.19, "fitted", FITTED), (-0.19, "published", PUBLISHED)) if both else ((0.0, "fitted", FITTED),):
            values = [100 * row[who][metric] if is_number(row[who].get(metric)) else np.nan for row in rows]
            ax.barh(y + shift, values, 0.34, color=colour, label=literal(law) if who == "fitted" else "published pair")
        ax.axvline(0, color=INK, lw=0.6)
        ax.set(title=title.capitalize(), xlabel="error against FE (%)")
        ax.grid(axis="y", visible=False)
        low, high = ax.get_xlim()
        ax.set_xlim(min(low, -1.0), max(high, 1.0))
    grid[0, 0].set_yticks(y, [literal(row["name"]) for row in rows])
    shared_legend(fig, grid[0, :1])
    return save(fig, path)


def draw_residuals(entries: list[Entry], path: str, label: Callable = str) -> str | None:
    """Reduced minus FE rim force through the first impact of every run, both from their own touch, over the peak."""
    runs: list[tuple[str, tuple[Run, Run]]] = [(entry.name, (entry.fe, getattr(entry, entry.best))) for entry in entries
                                               if entry.fe is not None and getattr(entry, entry.best) is not None]
    touched = [(name, both, [contact_stretches(run) for run in both]) for name, both in runs]
    drawn = [(name, both, [parts[0] for parts in stretches]) for name, both, stretches in touched if all(stretches)]
    if not drawn:
        return None
    fig, grid = figure(1, 2, 2.6, gridspec_kw={"width_ratios": [1.25, 1]})
    over_time, scatter = grid[0]
    largest = 0.0
    for i, (name, both, parts) in enumerate(drawn):
        time, reference, candidate = _aligned(both, parts)
        style = dict(color=f"C{i % 8}", lw=1.1)
        over_time.plot(1e3 * time, 100 * (candidate - reference) / reference.max(), label=literal(label(name)), **style)
        scatter.plot(1e-3 * reference, 1e-3 * candidate, **style)
        largest = max(largest, 1e-3 * reference.max(), 1e-3 * candidate.max())
    over_time.axhline(0, color=INK, lw=0.6)
    over_time.set(title="(a) Residual of the rim force", xlabel="time since the model's own touch (ms)",
                  ylabel="(reduced − FE) / FE peak (%)")
    scatter.plot([0, largest], [0, largest], color=MUTED, lw=0.8, ls=(0, (1, 1.5)))
    scatter.set(title="(b) Reduced over FE", xlabel="FE rim force (kN)", ylabel="reduced rim force (kN)")
    shared_legend(fig, [over_time], n_columns=3)
    return save(fig, path)


def _aligned(runs: tuple[Run, Run], parts: list[slice]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    series = []
    for run, part in zip(runs, parts):
        series.append(impact_curve(run, part)[:2])
    end = max(series[0][0][-1], series[1][0][-1])
    time = np.linspace(0.0, end, 400)
    first, second = (np.interp(time, t, f, left=0.0, right=0.0) for t, f in series)
    return time, first, second


def draw_parameters(calibration: Calibration, path: str) -> str | None:
    """Fitted value with its 95 % interval beside the published one, relative to the fitted value."""
    shown = [p for p in calibration.parameters if p.value]
    if not shown:
        return None
    fig, grid = figure(1, 1, 0.55 + 0.3 * len(shown), width=4.2)
    ax = grid[0, 0]
    for y, parameter in enumerate(shown[::-1]):
        low, high = parameter.interval or (parameter.value, parameter.value)
        ax.plot([low / parameter.value, high / parameter.value], [y, y], color=FITTED, lw=3, solid_capstyle="butt")
        ax.plot(1, y, "o", color=FITTED, ms=5, label="this fit, 95 %" if y == 0 else None)
        if parameter.published is not None:
            ax.plot(parameter.published / parameter.value, y, "D", color=PUBLISHED, ms=4.5,
                    label="published" if y == 0 else None)
    ax.set_yticks(range(len(shown)), ["k$_i$" if p.name == "k_i" else literal(p.name) for p in shown[::-1]])
    ax.set_xlabel("value / value of this fit")
    ax.set_ylim(-0.6, len(shown) - 0.4)
    ax.grid(axis="y", visible=False)
    ax.axvline(1, color=FE, lw=0.4, zorder=0)
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    return save(fig, path)
