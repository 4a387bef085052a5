"""The geometry study: every run against the surrogate's formula, or over speed while there is none."""
from typing import Any

from ..style import FE, MUTED, figure, save


def by_formula(surrogate: dict[str, Any], row: dict[str, float]) -> float:
    value = surrogate["coefficient"]
    for name, item in surrogate["inputs"].items():
        value *= (row[name] / item["centre"]) ** item["exponent"]
    return value


def draw(study: dict[str, Any], path: str) -> str | None:
    """Four panels; None without rows."""
    rows = study["rows"]
    if not rows:
        return None
    fig, grid = figure(2, 2, 5.2)
    for ax, (name, surrogate) in zip(grid.flat, study["surrogates"].items()):
        values = [row[name] for row in rows]
        if surrogate:
            ends = [min(values), max(values)]
            ax.plot(ends, ends, lw=0.8, color=MUTED)
            ax.plot(values, [by_formula(surrogate, row) for row in rows], ls="none", marker="o", ms=3.5, color=FE)
            error = 100 * surrogate["left_out_error_rms"]
            ax.set(title=f"{name}: errs by {error:.0f} % on rows left out", ylabel="by the formula",
                   xlabel=f"finite elements ({surrogate['unit'].replace('-', '–')})")
        else:
            ax.plot([row["speed"] for row in rows], values, ls="none", marker="o", ms=3.5, color=FE)
            ax.set(title=name, xlabel="approach speed (m/s)")
    return save(fig, path)
