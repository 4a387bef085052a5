"""Zoom on each impact: rim force over time since touch, and over penetration; every model from its own touch."""
from typing import Any

from matplotlib.axes import Axes

from ..results import Entry
from ..run_folder import Run
from ..series import contact_stretches, impact_curve
from ..style import MUTED, figure, line_of, literal, save, shared_legend


def draw(models: list[tuple[str, Run]], labels: dict[str, str], path: str, most: int = 4) -> str | None:
    """One row an impact (the first `most`); `labels` by role. None when no model touches the rim."""
    stretches = [(role, run, contact_stretches(run)) for role, run in models]
    n_rows = min(most, max((len(parts) for _, _, parts in stretches), default=0))
    if n_rows == 0:
        return None
    fig, grid = figure(n_rows, 2, 0.45 + 1.95 * n_rows)
    for row, (over_time, over_depth) in enumerate(grid):
        lines = 0
        for role, run, parts in stretches:
            if row < len(parts):
                _draw_one(over_time, over_depth, run, parts[row], line_of(role), labels[role], lines)
                lines += 1
        _finish(over_time, over_depth, row, last=row == n_rows - 1)
    shared_legend(fig, grid[:, 0])
    return save(fig, path)


def _draw_one(over_time: Axes, over_depth: Axes, run: Run, part: slice, style: dict[str, Any], label: str, line: int) -> None:
    """`line`: which line of the panel's corner names this model's peak."""
    time, force, depth = impact_curve(run, part)
    over_time.plot(1e3 * time, 1e-3 * force, label=literal(label), **style)
    over_depth.plot(1e3 * depth, 1e-3 * force, **style)
    over_time.annotate(f"peak {1e-3 * force.max():.0f} kN", (1.0, 1.0), xycoords="axes fraction", ha="right", va="top",
                       xytext=(-2, -2 - 9 * line), textcoords="offset points", fontsize=6.5, color=style["color"])


def _finish(over_time: Axes, over_depth: Axes, row: int, last: bool) -> None:
    over_time.set_title(f"Impact {row + 1}: force over time")
    over_depth.set_title(f"Impact {row + 1}: force over penetration")
    for ax in (over_time, over_depth):
        ax.set_ylabel("rim force (kN)")
        ax.axhline(0, color=MUTED, lw=0.5, zorder=0)
    if last:
        over_time.set_xlabel("time since the model's own touch (ms)")
        over_depth.set_xlabel("penetration (mm)")


def draw_windows(entries: list[Entry], path: str) -> str | None:
    """All single-impact windows of the FE side together, darker with speed; the fitted pair dotted and the best law dashed
    beside."""
    drawn = [(entry, entry.fe) for entry in entries if entry.fe is not None and contact_stretches(entry.fe)]
    if not drawn:
        return None
    from matplotlib import colormaps
    fig, grid = figure(1, 2, 2.9)
    over_time, over_depth = grid[0]
    for i, (entry, reference) in enumerate(drawn):
        colour = colormaps["viridis_r"](0.12 + 0.85 * i / max(1, len(drawn) - 1))
        _window_line(over_time, over_depth, reference, dict(color=colour, lw=1.5),
                     f"{entry.speed:g} m/s" if entry.speed else literal(entry.name))
        for run, dashes in ((entry.fitted, (1, 1.4)), (entry.law, (4, 1.6))):
            if run is not None:
                _window_line(over_time, over_depth, run, dict(color=colour, lw=0.8, ls=(0, dashes)), None)
    over_time.set(title="(a) Force over time", xlabel="time since touch (ms)", ylabel="rim force (kN)")
    over_depth.set(title="(b) Force over penetration", xlabel="penetration (mm)", ylabel="rim force (kN)")
    over_depth.legend(title="approach speed", title_fontsize=7, loc="center left",
                      bbox_to_anchor=(1.0, 0.5))
    return save(fig, path)


def _window_line(over_time: Axes, over_depth: Axes, run: Run, style: dict[str, Any], label: str | None) -> None:
    for part in contact_stretches(run)[:1]:
        time, force, depth = impact_curve(run, part)
        over_time.plot(1e3 * time, 1e-3 * force, **style)
        over_depth.plot(1e3 * depth, 1e-3 * force, label=label, **style)
