"""Geometry of a bearing from its resolved [bearing] table, in SI: the sliding surface, L_c, where the slider touches."""
from typing import Any

import numpy as np

from .numbers import is_number
from .scene_text import commented_keys


def value(bearing: dict[str, Any], part: str, key: str) -> float | None:
    """Of a key with its unit, in SI (m); None where it is not given."""
    found = bearing.get(part, {}).get(key)
    if not is_number(found):
        return None
    return found / 1e3 if key.endswith("_mm") else found


def lateral_capacity(bearing: dict[str, Any]) -> float | None:
    """L_c [m] of one dish by (2-5); None of two, or where the dimensions are not written out: a run's summary has it of any bearing."""
    if is_double_concave(bearing):
        return None
    reach, diameter = value(bearing, "surface", "planar_radius_mm"), value(bearing, "slider", "diameter_mm")
    return reach + (value(bearing, "rim", "ledge_mm") or 0.0) - diameter / 2 if reach and diameter else None


def is_double_concave(bearing: dict[str, Any]) -> bool:
    return bearing.get("surface", {}).get("concave") == "double"


class TwoDishes:
    """The outline of a slider between two like dishes, in SI."""

    KEYS = (("surface", "R0_m"), ("slider", "diameter_mm"), ("slider", "height_mm"))

    @classmethod
    def missing(cls, bearing: dict[str, Any]) -> list[str]:
        return [f"{part}.{key}" for part, key in cls.KEYS if not value(bearing, part, key)]

    def __init__(self, bearing: dict[str, Any]) -> None:
        self.R, diameter, self.height = (value(bearing, part, key) or 0.0 for part, key in self.KEYS)
        self.radius = diameter / 2
        self.halves = value(bearing, "slider", "mu_interface") is not None

    def tilt_at(self, travel: float) -> float:
        """At a travel of what is carried [rad], which rides a sphere of R_eff = 2 R - H (3-94)."""
        return float(np.arcsin(travel / (2 * self.R - self.height)))

    def middle(self, travel: float) -> np.ndarray:
        """Of the slider, (x, z); the upper plate is the lower one after half a turn about it."""
        arm, tilt = self.R - self.height / 2, self.tilt_at(travel)
        return np.array([arm * np.sin(tilt), self.R - arm * np.cos(tilt)])

    def slider(self, travel: float) -> list[np.ndarray]:
        """Outlines (n, 2) of what it is made of, tilted: of one piece, or of its two halves on one another."""
        x = np.linspace(-self.radius, self.radius, 81)
        face = self.R - np.sqrt(self.R ** 2 - x ** 2) - self.height / 2  # from the middle
        low, high, plane = np.column_stack([x, face]), np.column_stack([x, -face]), np.column_stack([x[::80], [0, 0]])
        pieces = [(low, plane), (plane, high)] if self.halves else [(low, high)]
        c, s = np.cos(self.tilt_at(travel)), np.sin(self.tilt_at(travel))
        return [np.vstack([below, above[::-1]]) @ np.array([[c, s], [-s, c]]) + self.middle(travel) for below, above in pieces]


def height(bearing: dict[str, Any], radius: float | list[float] | np.ndarray) -> np.ndarray:
    """Of the sliding surface above its vertex at a planar radius [m]. Throws ValueError for a surface not known here, or
    one that does not reach so far."""
    surface, r = bearing.get("surface", {}), np.abs(np.asarray(radius, float))
    kind = surface.get("kind", "ellipse")
    if kind not in HEIGHTS:
        raise ValueError(f"no drawing of surface.kind \"{kind}\"")
    try:
        z = HEIGHTS[kind](surface, r)
    except KeyError as error:
        raise ValueError(f"surface.{error.args[0]} is not given") from None
    if not np.all(np.isfinite(z)):
        raise ValueError("the surface does not reach to the dish's edge")
    return z


def _ellipse(surface: dict[str, Any], r: np.ndarray) -> np.ndarray:
    a, R0 = surface["a_m"], surface["R0_m"]
    with np.errstate(invalid="ignore"):
        return a * a / R0 * (1 - np.sqrt(1 - (r / a) ** 2))


def _sphere(surface: dict[str, Any], r: np.ndarray) -> np.ndarray:
    return _ellipse({"a_m": surface["R0_m"], "R0_m": surface["R0_m"]}, r)


def _cone(surface: dict[str, Any], r: np.ndarray) -> np.ndarray:
    rounding = surface["slope"] * surface["R0_m"]
    return surface["slope"] * (np.hypot(r, rounding) - rounding)


def _polynomial(surface: dict[str, Any], r: np.ndarray) -> np.ndarray:
    keys = ("c2_per_m", "c3_per_m2", "c4_per_m3", "c5_per_m4", "c6_per_m5")
    return sum(surface.get(key, 0.0) * r ** power for power, key in enumerate(keys, 2))


def _table(surface: dict[str, Any], r: np.ndarray) -> np.ndarray:
    return np.interp(r, np.array(surface["radius_mm"]) / 1e3, np.array(surface["height_mm"]) / 1e3)


HEIGHTS = {"ellipse": _ellipse, "sphere": _sphere, "cone": _cone, "polynomial": _polynomial, "table": _table}


def assumed_keys(scene_text: str, scene: dict[str, Any]) -> set[str]:
    """Dotted keys of the bearing ("rim.height_mm") that the file marks: by the comment "# assumption" on the key's line or
    its table's, or by the list `assumed`."""
    marked = {key.removeprefix("bearing.") for key in commented_keys(scene_text)}
    return marked | set(scene.get("bearing", {}).get("assumed", []))
