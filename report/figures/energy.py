"""The energy ledger over time: where the energy put in by the ground motion is, stacked, under the input's line."""
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..run_folder import Run
from ..style import ENERGY, INK, figure, literal, save, shared_legend

NAMES = {"kinetic": "kinetic", "gravity": "lift against gravity", "elastic": "elastic", "contact": "contact",
         "friction": "friction (spent)", "impact": "impact element", "plastic": "plastic (spent)", "damping": "dashpots and pad (spent)",
         "integrator": "integrator's loss"}


def draw(runs: list[tuple[str, Run]], path: str) -> Figure | str | None:
    """runs: [(title, run)]; two panels a row. None when no run stores energy signals."""
    runs = [(title, run) for title, run in runs if run.has("energy_external") and _terms(run)]
    if not runs:
        return None
    columns = min(2, len(runs))
    rows = -(-len(runs) // columns)
    fig, grid = figure(rows, columns, 0.5 + (1.85 if columns == 2 else 2.3) * rows)
    for ax in grid.flat[len(runs):]:
        ax.axis("off")
    for ax, (title, run) in zip(grid.flat, runs):
        _stack(ax, run)
        ax.set_title(literal(title))
        ax.margins(x=0)
        ax.set_xlabel(run.time_label)
    for ax in grid[:, 0]:
        ax.set_ylabel("energy (kJ)")
    shared_legend(fig, grid.flat[:len(runs)], n_columns=5)
    return save(fig, path)


def _terms(run: Run) -> list[str]:
    return [name for name in list(ENERGY)[::-1] if run.has(f"energy_{name}")]


def _stack(ax: Axes, run: Run) -> None:
    """What is spent lies below, what is stored above it."""
    given = 1e-3 * (run.signals["energy_external"] + _initial(run))
    series = {name: 1e-3 * run.signals[f"energy_{name}"] for name in _terms(run)}
    shown = max(1e-9, 0.005 * np.max(np.abs(given)))
    base: np.ndarray = np.zeros(len(given))
    for name, values in series.items():
        top = base + values
        if np.max(np.abs(values)) > shown:
            ax.fill_between(run.time, base, top, color=ENERGY[name], lw=0, alpha=0.9, label=NAMES[name])
        base = top
    ax.plot(run.time, given, color=INK, lw=1.0, label="put in")


def _initial(run: Run) -> float:
    """Energy present at the start [J]; a window's kinetic energy when the summary does not say."""
    value = (run.summary.get("energy") or {}).get("initial_J")
    return value if value is not None else float(run.signals.get("energy_kinetic", [0.0])[0])
