"""Where the time of each FE run goes."""
import numpy as np

from ..run_folder import Run
from ..style import BLUE, FAINT, FITTED, GREEN, PURPLE, SKY, YELLOW, figure, literal, save, shared_legend

PARTS = {"search": PURPLE, "assembly": BLUE, "factor": FITTED, "solve": YELLOW, "output": GREEN}


def draw(runs: list[tuple[str, Run]], path: str) -> str | None:
    """runs: [(name, run)]; stacked bars of wall time, the unaccounted rest in grey. None when no run tells its time."""
    runs = [(name, run) for name, run in runs if run.summary.get("wall_time_s")]
    if not runs:
        return None
    names, told = [name for name, _ in runs], [run for _, run in runs]
    fig, grid = figure(1, 1, 0.7 + 0.24 * len(runs))
    ax, y = grid[0, 0], np.arange(len(runs))[::-1]
    done = np.zeros(len(runs))
    named = sorted({name for run in told for name in run.summary.get("time_split_s") or {}},
                   key=lambda name: list(PARTS).index(name) if name in PARTS else 99)
    for name in named:
        values = np.array([(run.summary.get("time_split_s") or {}).get(name) or 0.0 for run in told])
        ax.barh(y, values, 0.62, left=done, color=PARTS.get(name, SKY), label=name)
        done += values
    rest = np.maximum(0.0, np.array([run.summary["wall_time_s"] for run in told]) - done)
    ax.barh(y, rest, 0.62, left=done, color=FAINT, label="other")
    ax.set_yticks(y, [literal(name) for name in names])
    ax.set_xlabel("wall time (s)")
    ax.grid(axis="y", visible=False)
    shared_legend(fig, [ax], n_columns=7)
    return save(fig, path)
