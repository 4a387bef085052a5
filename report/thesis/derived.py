"""Numbers of a run that no summary holds, by name: the catalogue writes them as "run:name"."""
import math
from typing import Any

import numpy as np

from ..errors import DataError
from ..run_folder import Run
from .pair import equal_stiffness


def pad_pressure_MPa(run: Run) -> float:
    """Dead load over the pad's ring."""
    pad = run.get("bearing", "pad")
    area = math.pi * (pad["outer_radius_mm"] ** 2 - pad["inner_radius_mm"] ** 2)
    return 1e3 * run.get("load", "vertical_kN") / area


def yield_over_W(run: Run) -> float:
    """Yield force of the frame over the weight of all: k_s u_y / W, k_s = m_s (2 pi / T_s)^2."""
    frame = run.scene["superstructure"]
    stiffness = frame["mass_ratio"] * run.get("load", "mass_kg") * (2 * math.pi / frame["period_s"]) ** 2
    return stiffness * frame["yield_mm"] * 1e-3 / (1e3 * run.get("load", "vertical_kN"))


def _hits(run: Run) -> np.ndarray:
    """Displacements [m] at which the rims are touched, one an impact."""
    pressed = run.norm("impact") > 0
    return np.abs(run.signals["displacement_x"][np.flatnonzero(pressed[1:] & ~pressed[:-1]) + 1])


def first_hit_m(run: Run) -> float:
    return float(_hits(run)[0])


def second_hit_m(run: Run) -> float:
    return float(_hits(run)[1])


def largest_slip_m(run: Run) -> float:
    """Of the interface, at any time."""
    return float(np.hypot(run.signals["interface_slip_x"], run.signals["interface_slip_y"]).max())


def effective_radius_m(run: Run) -> float:
    """R_eff of a bearing whose plates are alike."""
    i = run.scene["isolator"]
    return 2 * i["radius_m"] - 1e-3 * (i["top_height_mm"] + i["bottom_height_mm"])


def equal_stiffness_kN_per_m(run: Run) -> float:
    """k_i of the constant pair that equals the run's first impact."""
    return equal_stiffness(run.impacts[0], run.get("load", "mass_kg"))


def hardening_ratio(run: Run) -> float:
    """Slope of the loading branch over its last tenth of displacement, over that about half of it: above 1 hardens."""
    u, f = run.signals["displacement_x"], -run.signals["force_x"]
    top = int(np.argmax(u))

    def slope(low: float, high: float) -> float:
        part = (u[:top + 1] > low * u[top]) & (u[:top + 1] < high * u[top])
        return float(np.polyfit(u[:top + 1][part], f[:top + 1][part], 1)[0])

    return slope(0.9, 1.0) / slope(0.45, 0.55)


CATALOGUE = {f.__name__: f for f in (pad_pressure_MPa, yield_over_W, first_hit_m, second_hit_m, largest_slip_m,
                                    effective_radius_m, equal_stiffness_kN_per_m, hardening_ratio)}


def largest_at_hit(run: Run, signal: str) -> float:
    """Largest size of a signal from the first touch to the last release of what touches within half a second of it."""
    first = run.impacts[0]["touch_time_s"]
    ends = [impact["release_time_s"] or first for impact in run.impacts if impact["touch_time_s"] < first + 0.5]
    time = run.signals["time"]
    return float(np.abs(run.signals[signal][(time >= first - 1e-9) & (time <= max(ends) + 1e-9)]).max())


def of(run: Run, path: str) -> Any:
    """A name of the catalogue, "peak SIGNAL", "hit SIGNAL" (largest in the first impact), "at SECONDS SIGNAL" (its size
    then), "scene KEY.KEY"; None where `path` is none of them."""
    try:
        if path in CATALOGUE:
            return CATALOGUE[path](run)
        kind, _, rest = path.partition(" ")
        if kind == "peak":
            return float(np.abs(run.signals[rest]).max())
        if kind == "hit":
            return largest_at_hit(run, rest)
        if kind == "at":
            seconds, signal = rest.split(" ")
            return float(abs(np.interp(float(seconds), run.signals["time"], run.signals[signal])))
        if kind == "scene":
            return run.get(*rest.split("."))
    except (KeyError, IndexError, TypeError) as error:
        raise DataError(f"{run.folder} holds no {path} ({error})") from None
    return None


def reduction(study: dict[str, Any], path: str) -> float:
    """"reduction STATISTIC QUANTITY LIMIT VALUE" of a kept reliability study: by how much the probability of exceeding the limit falls
    (mean, least, largest over its pairs of systems) where the key that tells them apart has that value."""
    _, statistic, quantity, limit, value = path.split(" ", 4)
    for row in study["differences"]:
        if row["quantity"] == quantity and row["limit"] == float(limit) and str(row["value"]) == value:
            return float(row[f"{statistic}_reduction"])
    raise DataError(f"the study {study['study']} has no {path}")


def is_derived(path: str) -> bool:
    return path in CATALOGUE or path.startswith(("peak ", "hit ", "at ", "scene "))
