"""Speed against error: every run of a study, its frontier, and the wanted error."""
from typing import Any

from ..stored_studies import cost_name, cost_of
from ..style import FE, FITTED, GREEN, INK, MUTED, PURPLE, RIM, figure, literal, save

COLOURS = {"reduced": FITTED, "rim": FE, "rigid-dish": GREEN, "full": PURPLE}
FLOOR = 1e-5  # errors below are drawn here


def draw(study: dict[str, Any], path: str) -> str | None:
    """One panel; None without rows."""
    rows = study["rows"]
    if not rows:
        return None
    fig, grid = figure(1, 1, 3.4)
    ax = grid[0, 0]
    error = lambda row: 100 * max(row["error"], FLOOR)  # noqa: E731
    time = cost_name(rows)
    if study["extrapolated_peak_force_N"] is None:  # the reference's own error is not known
        reference = next(row for row in rows if row["reference"])
        rows = [row for row in rows if row is not reference]
        ax.axvline(cost_of(reference), color=MUTED, lw=0.8, ls="--", label=f"reference: {literal(reference['name'])}")
    for rung in dict.fromkeys(row["rung"] for row in rows):
        chosen = [row for row in rows if row["rung"] == rung]
        ax.plot([cost_of(row) for row in chosen], [error(row) for row in chosen], ls="none", marker="o", ms=5,
                color=COLOURS.get(rung, INK), label=rung)
    frontier = [row for row in rows if row["on_frontier"]]
    ax.plot([cost_of(row) for row in frontier], [error(row) for row in frontier], color=MUTED, lw=1.0,
            label="frontier")
    for row in rows:
        ax.annotate(literal(row["name"]), (cost_of(row), error(row)), xytext=(5, 3), textcoords="offset points", fontsize=6.5)
    ax.axhline(100 * study["wanted_error"], color=RIM, lw=0.7, ls=":", label="wanted")
    quantity = "peak displacement" if study.get("error_of") == "peak_displacement" else "peak force"
    ax.set(xscale="log", yscale="log", xlabel=f"{time} (s)", ylabel=f"error of the {quantity} (%)")
    ax.margins(x=0.18)
    ax.legend(loc="best")
    return save(fig, path)
