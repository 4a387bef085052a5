"""k_i and e over impact speed, beside one pair of the same law fitted to all, the speeds at which that holds, and the published pair."""
from collections.abc import Callable

from matplotlib.axes import Axes

from ..calibration_file import Calibration, Parameter, WindowRow
from ..style import FE, FITTED, INK, MUTED, PUBLISHED, figure, save, shared_legend


def draw(calibration: Calibration, path: str) -> str | None:
    """None when no window gave k_i or e."""
    rows = calibration.windows
    with_e = [r for r in rows if r.e or r.restitution is not None]
    if not with_e and not any(r.k_i for r in rows):
        return None
    judged = calibration.is_pair and any(row.pair_force_error is not None for row in rows)
    fig, grid = figure(1, 3 if judged else 2, 2.55)
    k_ax, e_ax, *force_ax = grid[0]
    draw_stiffness(k_ax, calibration, "(a) Impact stiffness")
    _points(e_ax, with_e, lambda r: r.e, 1.0)
    rebound = [r for r in rows if r.restitution is not None]
    e_ax.plot([r.speed for r in rebound], [r.restitution for r in rebound], ls="none", marker="x", ms=4, mew=0.9,
              color=MUTED, label="rebound / approach")
    _constants(e_ax, calibration.pair("e"), 1.0)
    for ax in force_ax:
        _force(ax, rows, calibration.tolerance)
    e_ax.set(title="(b) Restitution", ylabel="e (–)")
    for ax in (e_ax, *force_ax):
        _speed_axis(ax, calibration)
    e_ax.set_ylim(0, max(1.0, e_ax.get_ylim()[1]))
    shared_legend(fig, (k_ax, e_ax))
    return save(fig, path)


def draw_stiffness(ax: Axes, calibration: Calibration, title: str) -> None:
    """k_i over approach speed: each window alone, one pair of the same law for all, the published value."""
    _points(ax, [row for row in calibration.windows if row.k_i], lambda r: r.k_i, 1e-5)
    _constants(ax, calibration.pair("k_i"), 1e-5)
    ax.set(title=title, ylabel="k$_i$ (10⁵ kN/m)")
    _speed_axis(ax, calibration)
    ax.set_ylim(bottom=0)


def _speed_axis(ax: Axes, calibration: Calibration) -> None:
    ax.set_xlabel("approach speed (m/s)")
    ax.set_xlim(left=0)
    if calibration.valid_from is not None and calibration.valid_to is not None:
        ax.axvspan(calibration.valid_from, calibration.valid_to, color=FITTED, alpha=0.10, lw=0, zorder=0)


def _points(ax: Axes, rows: list[WindowRow], parameter: Callable, factor: float) -> None:
    rows = [row for row in rows if parameter(row)]
    if not rows:
        return
    speeds, values = [r.speed for r in rows], [factor * parameter(r).value for r in rows]
    below, above = [], []
    for row, value in zip(rows, values):
        low, high = parameter(row).interval or (parameter(row).value, parameter(row).value)
        below.append(max(0.0, value - factor * low))
        above.append(max(0.0, factor * high - value))
    ax.errorbar(speeds, values, yerr=[below, above], color=FE, marker="o", ms=3.5, lw=1.2, elinewidth=0.8,
                capsize=2, label="each window alone, 95 %")


def _constants(ax: Axes, parameter: Parameter | None, factor: float) -> None:
    if parameter is None:
        return
    ax.axhline(factor * parameter.value, color=FITTED, lw=1.1, label="one pair, all runs")
    if parameter.interval:
        ax.axhspan(factor * parameter.interval[0], factor * parameter.interval[1], color=FITTED, alpha=0.15, lw=0)
    if parameter.published is not None:
        ax.axhline(factor * parameter.published, color=PUBLISHED, lw=0.9, ls=(0, (4, 1.6)), label="published pair")


def _force(ax: Axes, rows: list[WindowRow], tolerance: float | None) -> None:
    errors = [(row.speed, 100 * row.pair_force_error) for row in rows if row.pair_force_error is not None]
    ax.set(title="(c) Peak force by one pair", ylabel="error of peak force (%)")
    ax.plot([speed for speed, _ in errors], [error for _, error in errors], color=FITTED, marker="o", ms=3.5)
    ax.axhline(0, color=INK, lw=0.5)
    if tolerance:
        for level in (tolerance, -tolerance):
            ax.axhline(100 * level, color=MUTED, lw=0.7, ls=(0, (1, 1.5)))
