"""The geometry study: every run against the surrogate's formula, or over speed while there is none."""
from typing import Any

from matplotlib.axes import Axes

from ..style import FE, FITTED, MUTED, figure, save
from . import vary


def by_formula(surrogate: dict[str, Any], row: dict[str, float]) -> float:
    value = surrogate["coefficient"]
    for name, item in surrogate["inputs"].items():
        value *= (row[name] / item["centre"]) ** item["exponent"]
    return value


def region(ax: Axes, pair: dict[str, Any] | None, colour: str, unit: str, label: str = "wanted") -> bool:
    """The speed at which each rim returns the wanted e, and its stiffness there; the band is the surrogate's error."""
    if not pair or not pair["rims"]:
        return False
    rims = pair["rims"]
    dots = ax.scatter([rim["speed"] for rim in rims], [rim["k_i"] for rim in rims], c=[rim[colour] for rim in rims], s=14, zorder=3)
    ax.figure.colorbar(dots, ax=ax, label=f"{colour.replace('_', ' ')} ({unit})")
    wanted, error = pair["wanted"]["k_i"], pair["k_i_error_rms"]
    ax.axhspan(wanted * (1 - error), wanted * (1 + error), color=FITTED, alpha=0.12, lw=0)
    ax.axhline(wanted, color=FITTED, ls=(0, (4, 1.6)), label=label)
    ax.set_ylim(bottom=0)
    return True


def draw(study: dict[str, Any], path: str) -> str | None:
    """Four panels, and two of the wanted pair where one is asked for; of --vary its own; None without rows."""
    if "vary" in study:
        return vary.draw(study, path)
    rows, pair = study["rows"], study.get("pair")
    if not rows:
        return None
    fig, grid = figure(3 if pair else 2, 2, 7.8 if pair else 5.2)
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
    if pair:
        wanted = pair["wanted"]["e"]
        for ax, colour, unit in zip(grid.flat[4:], ("rim_thickness", "yield_stress"), ("mm", "MPa")):
            region(ax, pair, colour, unit)
            ax.set(title=f"speed at which a rim returns e = {wanted:g}", xlabel="approach speed (m/s)", ylabel="k_i there (kN/m)")
    return save(fig, path)
