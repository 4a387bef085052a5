"""Pictures of a reliability study: IDA curves, fragilities, hazard, reliability curves, reductions, disaggregation."""
import numpy as np
from matplotlib.figure import Figure

from ..style import CYCLE, FE, FITTED, INK, MUTED, figure, literal, save, shared_legend
from .tables import Layout, Row

MOST_PANELS, COLUMNS = 16, 4
AXES = {"peak_displacement_m": "base displacement (m)", "peak_lateral_force_N": "lateral force (N)",
        "peak_impact_force_N": "rim force (N)", "residual_displacement_m": "residual displacement (m)",
        "ductility": "ductility", "peak_drift_m": "drift (m)", "peak_storey_shear_N": "storey shear (N)",
        "peak_floor_acceleration_m_s2": "floor acceleration (m/s²)", "collapsed": "collapse"}


def _panels(layout: Layout) -> list[tuple[str, list[int]]]:
    return list(layout.panels.items())[:MOST_PANELS]


def _grid(layout: Layout, height: float = 1.9) -> tuple[Figure, np.ndarray, list[tuple[str, list[int]]]]:
    panels = _panels(layout)
    columns = min(COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    fig, grid = figure(rows, columns, 0.5 + height * rows, sharex=True, sharey=True)
    for ax in grid.flat[len(panels):]:
        ax.set_visible(False)
    for (label, _), ax in zip(panels, grid.flat):
        ax.set_title(literal(label.replace(", ", "\n")), fontsize=6)
    return fig, grid, panels


def _colours(layout: Layout) -> dict[str, str]:
    names = list(dict.fromkeys(layout.series(system) for system in layout.systems))
    return {name: CYCLE[i % len(CYCLE)] for i, name in enumerate(names)}


def hazard(points: list[tuple[float, float]], levels: list[Row], period: float, path: str) -> str:
    """The hazard's points and the study's levels on its lines."""
    fig, grid = figure(1, 1, 2.6, width=4.2)
    ax = grid[0, 0]
    ax.loglog([x for x, _ in points], [1 / years for _, years in points], "-", color=FE, label="hazard")
    ax.loglog([level["level_g"] for level in levels], [1 / level["return_period_years"] for level in levels], "o", ms=4,
              color=FITTED, label="levels with records")
    ax.set_xlabel(f"$S_a$({period:g} s) (g)")
    ax.set_ylabel("annual rate of exceedance")
    ax.legend()
    return save(fig, path)


def ida(layout: Layout, rows: list[Row], quantity: str, path: str) -> str | None:
    """Median and 16 to 84 % of the runs of each system over intensity; a fractile that a collapse reaches is not there."""
    fig, grid, panels = _grid(layout)
    colours, drawn = _colours(layout), False
    for (_, systems), ax in zip(panels, grid.flat):
        for system in systems:
            own = [row for row in rows if row["system"] == system and row["quantity"] == quantity]
            name = layout.series(system)
            for share, style in (("p16", dict(lw=0.5)), ("p50", dict(lw=1.2, label=name)), ("p84", dict(lw=0.5))):
                line = [(row[share], row["level_g"]) for row in own if row[share] is not None]
                if line:
                    drawn = True
                    ax.plot(*zip(*line), color=colours[name], **style)
    for ax in grid[-1, :]:
        ax.set_xlabel(AXES.get(quantity, quantity))
    grid[0, 0].set_ylabel("$S_a$ (g)")
    shared_legend(fig, grid.flat)
    return save(fig, path) if drawn else None


def fragility(layout: Layout, rows: list[Row], quantity: str, limits: list[float], path: str) -> str:
    """P(quantity > limit) over intensity; one figure for all chosen limits, the thinner the larger the limit."""
    fig, grid, panels = _grid(layout)
    colours = _colours(layout)
    for (_, systems), ax in zip(panels, grid.flat):
        for system in systems:
            name = layout.series(system)
            for i, limit in enumerate(limits):
                own = [row for row in rows if row["system"] == system and row["quantity"] == quantity and row["limit"] == limit]
                x = [row["level_g"] for row in own]
                ax.plot(x, [row["probability"] for row in own], color=colours[name], lw=1.4 - 0.4 * i,
                        label=name if i == 0 else None)
                ax.fill_between(x, [row["low"] for row in own], [row["high"] for row in own], color=colours[name], alpha=0.12, lw=0)
    for ax in grid[-1, :]:
        ax.set_xlabel("$S_a$ (g)")
    grid[0, 0].set_ylabel("probability")
    shared_legend(fig, grid.flat)
    return save(fig, path)


def reliability(layout: Layout, rows: list[Row], quantity: str, years: float, path: str) -> str:
    """Probability in a lifetime over the limit, with its band; dotted: the range where the levels do not decide it."""
    fig, grid, panels = _grid(layout)
    colours = _colours(layout)
    for (_, systems), ax in zip(panels, grid.flat):
        for system in systems:
            own = [row for row in rows if row["system"] == system and row["quantity"] == quantity and row["probability"] > 0]
            name, x = layout.series(system), [row["limit"] for row in own]
            ax.semilogy(x, [row["probability"] for row in own], color=colours[name], label=name,
                        marker="o" if len(own) == 1 else None, ms=3)
            ax.fill_between(x, [max(row["probability_low"], 1e-9) for row in own], [row["probability_high"] for row in own],
                            color=colours[name], alpha=0.12, lw=0)
            unsettled = [row for row in own if row.get("settled") == 0]
            for end in ("probability_range_low", "probability_range_high"):
                ax.plot([row["limit"] for row in unsettled], [max(row[end], 1e-9) for row in unsettled], ":", lw=0.8, color=colours[name])
    for ax in grid[-1, :]:
        ax.set_xlabel(AXES.get(quantity, quantity))
    grid[0, 0].set_ylabel(f"probability in {years:g} years")
    shared_legend(fig, grid.flat)
    return save(fig, path)


def reduction(layout: Layout, rows: list[Row], quantity: str, path: str) -> str | None:
    """1 - P / P of the reference over the limit, with its band."""
    fig, grid, panels = _grid(layout)
    colours, drawn = _colours(layout), False
    for (_, systems), ax in zip(panels, grid.flat):
        ax.axhline(0, color=MUTED, lw=0.6)
        for system in systems:
            own = [row for row in rows if row["system"] == system and row["quantity"] == quantity]
            if not own:
                continue
            drawn, name, x = True, layout.series(system), [row["limit"] for row in own]
            ax.plot(x, [100 * row["reduction"] for row in own], color=colours[name], label=name, marker="." if len(own) == 1 else None)
            ax.fill_between(x, [100 * row["reduction_low"] for row in own], [100 * row["reduction_high"] for row in own],
                            color=colours[name], alpha=0.12, lw=0)
    for ax in grid[-1, :]:
        ax.set_xlabel(AXES.get(quantity, quantity))
    grid[0, 0].set_ylabel("reduction (%)")
    shared_legend(fig, grid.flat)
    return save(fig, path) if drawn else None


def shares(rows: list[Row], quantity: str, limits: list[float], path: str) -> str:
    """Share of the rate of each level, the mean of all systems, for a few limits."""
    fig, grid = figure(1, 1, 2.4, width=4.6)
    ax = grid[0, 0]
    for i, limit in enumerate(limits):
        own = [row for row in rows if row["quantity"] == quantity and row["limit"] == limit]
        levels = sorted({row["level_g"] for row in own})
        mean = [sum(row["share"] for row in own if row["level_g"] == level) / max(1, sum(row["level_g"] == level for row in own))
                for level in levels]
        ax.plot(levels, [100 * share for share in mean], "o-", ms=3, color=CYCLE[i % len(CYCLE)], label=f"> {limit:g}")
    ax.set_xlabel("$S_a$ (g)")
    ax.set_ylabel("share of the rate (%)")
    ax.legend(title=AXES.get(quantity, quantity), title_fontsize=7, labelcolor=INK)
    return save(fig, path)
