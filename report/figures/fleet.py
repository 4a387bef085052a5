"""A sweep: results of all runs over what was varied, with fractiles where the sweep asked for them."""
import numpy as np
from matplotlib.axes import Axes

from ..fleet import Fleet
from ..style import FITTED, MUTED, figure, literal, save

RESULTS = (("peak_displacement_m", 1e3, "peak displacement (mm)"), ("peak_lateral_force_N", 1e-3, "peak lateral force (kN)"),
           ("peak_impact_force_N", 1e-3, "peak impact force (kN)"), ("residual_displacement_m", 1e3, "residual displacement (mm)"))
MOST = 3         # parameters drawn
MOST_NAMED = 10  # curves in the legend


def shown_results(fleet: Fleet) -> list[tuple[str, float, str]]:
    """Those that any run has."""
    return [item for item in RESULTS if item[0] in fleet.columns and np.nanmax(np.abs(np.nan_to_num(fleet.columns[item[0]]))) > 0]


def draw(fleet: Fleet, path: str) -> str | None:
    """Fractiles along their parameter; without them a row a result, a column a parameter. None where no run has a result."""
    results = shown_results(fleet)
    if not results:
        return None
    return _draw_fractiles(fleet, results, path) if fleet.along in fleet.columns else _draw_scatter(fleet, results, path)


def _draw_fractiles(fleet: Fleet, results: list[tuple[str, float, str]], path: str) -> str:
    rows = -(-(len(results) + 1) // 2)
    fig, grid = figure(rows, 2, 0.3 + 2.0 * rows)
    axes, table = list(grid.flat), fleet.fractiles
    for ax, (name, factor, label) in zip(axes, results):
        ax.plot(fleet.columns[fleet.along], factor * fleet.columns[name], ".", ms=2.5, color=MUTED, alpha=0.5, mew=0)
        for label_of_group, rows_of in grouped(fleet) if f"p50_{name}" in table else []:
            x, low, middle, high = table[fleet.along][rows_of], *(factor * table[f"{p}_{name}"][rows_of] for p in ("p16", "p50", "p84"))
            line, = ax.plot(x, middle, label=literal(label_of_group) or None)
            ax.fill_between(x, low, high, color=line.get_color(), alpha=0.16, lw=0)
        ax.set(xlabel=fleet.along, ylabel=label)
    _draw_touched(axes[len(results)], fleet)
    axes[0].set_title("Dots: runs; line and band: 50 %, 16 to 84 %")
    for ax in axes[len(results) + 1:]:
        ax.axis("off")
    if 1 < len(grouped(fleet)) <= MOST_NAMED:
        axes[0].legend()
    return save(fig, path)


def grouped(fleet: Fleet) -> list[tuple[str, np.ndarray]]:
    """(name, rows of the fractiles) of each curve; one without a name where the sweep gives them by nothing."""
    names = np.array(fleet.groups)
    return [(str(name), np.flatnonzero(names == name)) for name in dict.fromkeys(fleet.groups)]


def share_touching(fleet: Fleet, name: str) -> tuple[np.ndarray, np.ndarray]:
    """(values of a parameter, share of the runs at each that touch the rim)."""
    values = fleet.columns[name]
    levels = np.unique(values[np.isfinite(values)])
    touched = np.nan_to_num(fleet.columns["n_impacts"]) > 0
    return levels, np.array([touched[values == level].mean() for level in levels])


def _draw_touched(ax: Axes, fleet: Fleet) -> None:
    if "n_impacts" not in fleet.columns:
        ax.axis("off")
        return
    levels, share = share_touching(fleet, fleet.along)
    ax.plot(levels, 100 * share, color=FITTED, marker="o", ms=3)
    ax.set(xlabel=fleet.along, ylabel="runs that touch the rim (%)", ylim=(-3, 103))


def _draw_scatter(fleet: Fleet, results: list[tuple[str, float, str]], path: str) -> str:
    names = fleet.varied[:MOST] or ["run"]
    fig, grid = figure(len(results), len(names), 0.3 + 1.75 * len(results), sharex="col", sharey="row")
    touched = np.nan_to_num(fleet.columns.get("n_impacts", np.zeros(len(fleet.status)))) > 0
    for row, (name, factor, label) in zip(grid, results):
        for ax, parameter in zip(row, names):
            for chosen, colour in ((~touched, MUTED), (touched, FITTED)):
                ax.plot(fleet.columns[parameter][chosen], factor * fleet.columns[name][chosen], ".", ms=3.5, color=colour, alpha=0.7, mew=0)
        row[0].set_ylabel(label)
    for ax, parameter in zip(grid[-1], names):
        ax.set_xlabel(parameter)
    if touched.any():
        grid[0, 0].set_title("Orange: runs that touch the rim")
    return save(fig, path)
