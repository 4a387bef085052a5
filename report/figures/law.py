"""The law over what it was fitted to: force over penetration, loading and unloading, one curve a speed."""
from collections.abc import Callable

import numpy as np
from matplotlib import colormaps
from matplotlib.lines import Line2D

from ..curves import ImpactCurve
from ..style import INK, MUTED, figure, literal, save

MOST = 7


def chosen(impacts: list[ImpactCurve]) -> list[ImpactCurve]:
    """At most MOST impacts over the speeds, single ones before those of histories, grazing ones last."""
    able = [i for i in impacts if i.law is not None and len(i.law.force) and len(i.reference.force)]
    firm = [i for i in able if not i.grazing] or able
    windows = [i for i in firm if "window" in i.name]
    ordered = sorted(windows if len(windows) >= 2 else firm, key=lambda i: i.speed or 0.0)
    if len(ordered) <= MOST:
        return ordered
    return [ordered[round(k * (len(ordered) - 1) / (MOST - 1))] for k in range(MOST)]


def pressed(force: np.ndarray) -> slice:
    """From the sample before the first force to the one after the last: the flight to and from the rim is no loop."""
    touching = np.flatnonzero(force)
    return slice(max(0, touching[0] - 1), touching[-1] + 2) if len(touching) else slice(0, 0)


LABELS = {"penetration": "penetration", "rim_force": "rim force", "law_name": "law"}


def draw(impacts: list[ImpactCurve], law: str, path: str, width: float = 3.55, height: float = 2.45, dpi: int = 300, labels: dict[str, str] | None = None,
         number: Callable[[str], str] = str) -> str | None:
    """None without a curve and its law. `labels`: LABELS in another language, with `law` and `source` for the legend; `number`: how it
    writes decimals."""
    words = labels or LABELS
    drawn = chosen(impacts)
    if not drawn:
        return None
    fig, grid = figure(1, 1, height, width=width)
    ax = grid[0, 0]
    for k, impact in enumerate(drawn):
        colour = colormaps["viridis_r"](0.12 + 0.85 * k / max(1, len(drawn) - 1))
        label = number(f"{impact.speed:.3g}") if impact.speed is not None else literal(impact.name)
        ax.plot(1e3 * impact.reference.penetration, 1e-3 * impact.reference.force, color=colour, lw=2.4, alpha=0.75, label=label)
        law_curve = impact.law or impact.reference
        part = pressed(law_curve.force)
        ax.plot(1e3 * law_curve.penetration[part], 1e-3 * law_curve.force[part], color=INK, lw=0.75, zorder=4)
    ax.axhline(0, color=MUTED, lw=0.5, zorder=0)
    ax.set(xlabel=f"{words['penetration']} (mm)", ylabel=f"{words['rim_force']} (kN)")
    if labels:
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_formatter(lambda value, _: number(f"{value:g}"))
    ax.set_xlim(left=min(0.0, ax.get_xlim()[0]))
    kinds = [Line2D([], [], color=colormaps["viridis_r"](0.5), lw=2.4, alpha=0.75), Line2D([], [], color=INK, lw=0.75)]
    fig.get_layout_engine().set(rect=(0, 0, 1, 1 - 0.2 / height))
    said = [literal(words.get("source") or drawn[0].source), f"{words['law_name']} {literal(words.get('law', law))}"]
    fig.legend(kinds, said, loc="upper center", ncol=2, fontsize=6.5, borderaxespad=0.1)
    ax.legend(title="m/s", title_fontsize=6.5, fontsize=6.5, loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)
    return save(fig, path, dpi=dpi)
