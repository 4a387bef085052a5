"""The energy ledger over time: where the energy put in by the ground motion is, stacked, under the input's line."""
import numpy as np

from ..series import keep_peaks
from ..style import ENERGY, INK, figure, save

NAMES = {"kinetic": "kinetic", "gravity": "lift against gravity", "elastic": "elastic", "contact": "contact",
         "friction": "friction (spent)", "impact": "impact element", "plastic": "plastic (spent)",
         "integrator": "integrator's loss"}


def draw(run, path):
    """None when the run stores no energy signals."""
    terms = [name for name in ENERGY if f"energy_{name}" in run.signals]
    if not terms or "energy_external" not in run.signals:
        return None
    fig, grid = figure(1, 1, 2.5)
    ax = grid[0, 0]
    given = 1e-3 * (run.signals["energy_external"] + _initial(run))
    series = [1e-3 * run.signals[f"energy_{name}"] for name in terms]
    kept = keep_peaks(given, sum(series), limit=1500)
    base = np.zeros(len(kept))
    shown = max(1e-9, 0.002 * np.max(np.abs(given)))
    for name, values in sorted(zip(terms, series), key=lambda pair: list(ENERGY)[::-1].index(pair[0])):
        top = base + values[kept]
        if np.max(np.abs(values)) > shown:
            ax.fill_between(run.time[kept], base, top, color=ENERGY[name], lw=0, alpha=0.9, label=NAMES[name])
        base = top
    ax.plot(run.time[kept], given[kept], color=INK, lw=1.1, label="put in")
    ax.set(title="Where the energy is", xlabel="time (s)", ylabel="energy (kJ)")
    ax.margins(x=0)
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    return save(fig, path)


def _initial(run):
    """Energy present at the start [J]; a window's kinetic energy when the summary does not say."""
    value = (run.summary.get("energy") or {}).get("initial_J")
    return value if value is not None else float(run.signals.get("energy_kinetic", [0.0])[0])
