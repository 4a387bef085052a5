"""Peak impact force and approach speed over the pulse's scale: how steep they are near grazing."""
from typing import Any

from ..style import RIM, figure, line_of, literal, save, shared_legend


def draw(families: dict[str, list[dict[str, Any]]], critical: dict[str, float], labels: dict[str, str], path: str) -> str | None:
    """families: {pulse: [{"scale", "fe": (force N, speed m/s), "fitted": ..., "published": ...}]};
    critical: {pulse: scale at which the rim is first touched}; labels: by model, the reference first."""
    families = {name: rows for name, rows in families.items() if len(rows) > 1}
    if not families:
        return None
    fig, grid = figure(len(families), 2, 0.4 + 1.95 * len(families))
    for row, (name, points) in zip(grid, families.items()):
        for who in labels:
            known = sorted((p["scale"], *p[who]) for p in points if p.get(who))
            if not known:
                continue
            style = line_of(who) | {"marker": "o", "ms": 3.2}
            row[0].plot([k[0] for k in known], [1e-3 * k[1] for k in known], label=labels[who], **style)
            row[1].plot([k[0] for k in known], [k[2] for k in known], **style)
        row[0].set(title=f"{literal(name)}: peak impact force", ylabel="force (kN)")
        row[1].set(title=f"{literal(name)}: approach speed", ylabel="speed (m/s)")
        for ax in row:
            ax.margins(x=0.12)
            ax.set_ylim(bottom=0)
            ax.set_xlabel("scale of the pulse (–)")
            if critical.get(name):
                ax.axvline(critical[name], color=RIM, lw=0.8, ls=(0, (1, 1.5)))
                ax.annotate("first touch", (critical[name], 1), xycoords=("data", "axes fraction"), xytext=(-1, -2),
                            textcoords="offset points", rotation=90, va="top", ha="right", fontsize=6.5, color=RIM)
    shared_legend(fig, grid[:, 0])
    return save(fig, path)
