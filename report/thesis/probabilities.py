"""Probabilities of a kept reliability study as the thesis draws them: over a limit, a curve a system; how far a gap lowers them; and the hazard behind them.

The study's curves, docs/generate/keep_reliability.py: `limits` of each quantity; `systems`, each with the values `of` its keys and a list of
probabilities a quantity. A panel's `systems` names values, "superstructure.post_yield_ratio=0.05|0.1"; a system that has one of each is drawn."""
from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from matplotlib.axes import Axes

from ..errors import DataError
from ..reliability.tables import short, shown
from ..style import CYCLE, literal

if TYPE_CHECKING:
    from .runs import Runs

DASHES: list[Any] = ["-", (0, (4, 1.6)), (0, (1, 1.2)), (0, (4, 1.2, 1, 1.2))]


def systems_of(study: dict[str, Any], named: list[str]) -> list[dict[str, Any]]:
    """Throws DataError where there are none, or a key is none of theirs."""
    wanted = dict(text.split("=", 1) for text in named)
    for key in wanted:
        if key not in study["systems"][0]["of"]:
            raise DataError(f"the systems of {study['study']} have no key {key}")
    found = [system for system in study["systems"] if all(_same(system["of"][key], value) for key, value in wanted.items())]
    if not found:
        raise DataError(f"{study['study']} has no system with {', '.join(named)}")
    return found


def _same(value: Any, text: str) -> bool:
    return any(value == (float(one) if isinstance(value, (int, float)) else one) for one in text.split("|"))


def _told(key: str, value: Any) -> str:
    """A word as it is, a number after the last part of its key."""
    return value if isinstance(value, str) else f"{short(key)} {shown(value)}"


def probability(study: dict[str, Any], system: dict[str, Any], quantity: str, limit: float) -> float:
    return float(system[quantity][study["limits"][quantity].index(limit)])


class Styles:
    """A colour for each value of one thing, dashes for each of another, in the order they come in; `explain` tells them in the legend."""

    def __init__(self) -> None:
        self.colours: dict[str, Any] = {}
        self.dashes: dict[str, Any] = {}

    def of(self, colour: str, dash: str) -> dict[str, Any]:
        return {"color": self.colours.setdefault(colour, CYCLE[len(self.colours) % len(CYCLE)]),
                "ls": self.dashes.setdefault(dash, DASHES[len(self.dashes) % len(DASHES)])}

    def explain(self, ax: Axes) -> None:
        for name, colour in self.colours.items():
            ax.plot([], [], color=colour, label=literal(name))
        for name, dash in self.dashes.items():
            ax.plot([], [], color="black", ls=dash, label=literal(name))


def draw_probabilities(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """Of exceeding the limits of the quantity `y`. `colour` and `dashes` are keys, whose values have each their own."""
    study, styles = runs.summary(panel["of"]), Styles()
    for system in systems_of(study, panel["systems"]):
        drawn = [(limit, value) for limit, value in zip(study["limits"][panel["y"]], system[panel["y"]]) if value]
        style = styles.of(*(_told(panel[what], system["of"][panel[what]]) for what in ("colour", "dashes")))
        ax.semilogy([limit for limit, _ in drawn], [value for _, value in drawn], lw=0.8, **style)
    styles.explain(ax)
    return True


def draw_hazard(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """Of a kept study, whose points are spectral accelerations [g] and return periods [years]: the rate at which one is exceeded in a year."""
    accelerations, periods = zip(*runs.summary(panel["of"])["hazard"])
    ax.loglog(accelerations, [1 / period for period in periods], marker="o", ms=3, lw=0.9, color=CYCLE[0])
    return True


def draw_reductions(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """By how many per cent the probability of a `limit` of `y` lies below the reference's, over the number in the name of the device."""
    styles = Styles()
    for (first, *rest), points in reductions(runs.summary(panel["of"]), panel["systems"], panel["y"], panel["limit"]):
        ax.plot(*zip(*points), marker="o", ms=2, lw=0.9, **styles.of(first, ", ".join(rest)))
    styles.explain(ax)
    ax.axhline(0, color="black", lw=0.5)
    return True


def reductions(study: dict[str, Any], named: list[str], quantity: str, limit: float,
               reference: str = "DCFP") -> Iterator[tuple[tuple[str, ...], list[tuple[float, float]]]]:
    """For each set of systems that differ in their device only: what they are, and (number of the device, reduction in %), 0 of the reference."""
    sets: dict[tuple[str, ...], dict[str, float]] = {}
    fixed = {text.split("=")[0] for text in named if "|" not in text} | {"device"}
    for system in systems_of(study, named):
        told = tuple(_told(key, value) for key, value in system["of"].items() if key not in fixed)
        sets.setdefault(told, {})[system["of"]["device"]] = probability(study, system, quantity, limit)
    for told, of_device in sets.items():
        own = of_device.pop(reference)
        points = [(float(re.findall(r"\d+", device)[0]), 100 * (1 - value / own)) for device, value in of_device.items()]
        yield told, [(0.0, 0.0), *sorted(points)]
