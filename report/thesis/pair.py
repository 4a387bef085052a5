"""Which constant pair (k_i, e) an impact of finite elements equals: the spring and dashpot of (2-19) that return the same rebound
and the same peak force at the same speed."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes

from ..figures.geometry import region
from ..style import FE, FITTED

if TYPE_CHECKING:
    from .runs import Runs

PUBLISHED = (4.5e5, 0.65)  #: kN/m, [-]: thesis 2.3.2


def peak_share(e: float) -> float:
    """Largest force of the pair over v sqrt(k m): of k d + c d' from touch on, c by (2-20) with the rim fixed."""
    xi = -np.log(e) / np.hypot(np.pi, np.log(e))
    wd, t = np.sqrt(1 - xi * xi), np.linspace(0, np.pi, 20001)
    depth = np.exp(-xi * t) * np.sin(wd * t) / wd
    rate = np.exp(-xi * t) * (np.cos(wd * t) - xi * np.sin(wd * t) / wd)
    return float(np.max(depth + 2 * xi * rate))


def equal_stiffness(impact: dict[str, Any], mass: float) -> float:
    """k_i [kN/m] of the pair that equals an impact of a summary; e is its restitution."""
    share = peak_share(impact["restitution"])
    return 1e-3 * (impact["peak_force_N"] / (impact["approach_speed_m_s"] * share)) ** 2 / mass


def draw_pair(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """Over the speed of approach, `y` = k or e of the kept windows, the published value dashed."""
    points = []
    for curve in panel["curves"]:
        run = runs.response(curve["run"])
        if run is not None and run.impacts:
            impact = run.impacts[0]
            value = equal_stiffness(impact, run.get("load", "mass_kg")) if panel["y"] == "k" else impact["restitution"]
            points.append((impact["approach_speed_m_s"], value))
    if not points:
        return False
    ax.plot(*zip(*sorted(points)), "o-", color=FE, ms=3, label="finite elements, default rim")
    ax.axhline(PUBLISHED[0 if panel["y"] == "k" else 1], color=FITTED, ls=(0, (4, 1.6)), label="published pair")
    ax.set_ylim(bottom=0)
    return True


def draw_region(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    """Of a geometry study with --pair: where its rims return the published pair."""
    study = runs.summary(panel["of"])
    return bool(study) and region(ax, study.get("pair"), panel["colour"], panel["unit"], "published pair")
