"""The designer's question: force and use of the steel over the varied dimension, with their limits and the solid run that proves the answer."""
from typing import Any

from matplotlib.axes import Axes

from ..style import CYCLE, FE, INK, RIM, figure, save

UNITS = {"mm": "mm", "MPa": "MPa", "m": "m"}


def label_of(key: str) -> str:
    """rim.thickness_mm is "rim thickness (mm)"."""
    words = key.replace(".", " ").split("_")
    unit = UNITS.get(words[-1])
    return f"{' '.join(words[:-1])} ({unit})" if unit else " ".join(words)


def groups(study: dict[str, Any]) -> dict[str, list[dict[str, Any]]]:
    """Rows of one line each: those that share all keys but the first, by what is said of them."""
    found: dict[str, list[dict[str, Any]]] = {}
    for row in study["points"]:
        rest = ", ".join(f"{label_of(key['key'])} {value:g}" for key, value in zip(study["vary"][1:], row["at"][1:]))
        found.setdefault(rest, []).append(row)
    return found


def panel(ax: Axes, study: dict[str, Any], name: str, limit: float | None, factor: float) -> None:
    """One quantity; `factor` [per its unit] scales it."""
    between = study.get("between") or {}
    for colour, (rest, rows) in zip(CYCLE * len(study["points"]), groups(study).items()):
        ax.plot([row["at"][0] for row in rows], [float("nan") if row[name] is None else factor * row[name] for row in rows], color=colour, marker="o", ms=4,
                ls="none" if between else "-", label=rest or "rim curves", zorder=3)
    if between and all(value is not None for value in between[name]):
        ax.plot(between["at"], [factor * value for value in between[name]], color=FE, lw=1.0)
    if limit is not None:
        ax.axhline(factor * limit, color=RIM, ls=(0, (4, 1.6)), lw=1.0, label="limit")
    proof = study["answer"].get("proof") or {}
    if proof.get(name) is not None:
        ax.plot(study["answer"]["design"][0], factor * proof[name], marker="*", ms=9, color=INK, ls="none", label="solid run of the answer", zorder=4)
    ax.set(xlabel=label_of(study["vary"][0]["key"]))
    ax.set_ylim(bottom=0)
    ax.legend()


def draw(study: dict[str, Any], path: str) -> str | None:
    """Two panels; None without rows."""
    if not study["points"]:
        return None
    fig, grid = figure(1, 2, 2.9)
    force, steel = grid.flat
    panel(force, study, "peak_kN", study["targets"].get("peak_kN"), 1)
    force.set(title=f"peak force at {study['speed_m_per_s']:g} m/s", ylabel="peak force (kN)")
    limit = study["strain_limit"]
    panel(steel, study, "strain", limit or study["targets"].get("strain"), 100 / limit if limit else 100)
    steel.set(title="the rim's plastic strain", ylabel="of its limit (%)" if limit else "strain (%)")
    return save(fig, path)
