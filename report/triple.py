"""Geometry of a triple friction pendulum from its resolved [isolator] table, in SI: its four faces from the ground up (scene/triple_pendulum.h)."""
import math
from dataclasses import dataclass
from typing import Any

from .numbers import is_number


@dataclass
class Face:
    radius: float
    height: float  # from the pivot to the face on the axis
    half: float    # half the diameter of the slider on it
    travel: float  # along the face to its rim
    rim_height: float

    @property
    def effective_radius(self) -> float:
        return self.radius - self.height

    @property
    def edge_angle(self) -> float:
        return math.asin(self.half / self.radius)

    @property
    def tilt(self) -> float:
        """Turn of the slider at which the rim is touched."""
        return math.asin(self.travel / self.radius)

    @property
    def rim_radius(self) -> float:
        return self.radius * math.sin(self.tilt + self.edge_angle)


def faces(isolator: dict[str, Any]) -> list[Face] | None:
    """None where a dimension is not given."""
    inner = isolator.get("inner", {})

    def face(table: dict[str, Any], side: str, diameter: str) -> Face | None:
        def either(key: str) -> Any:
            own = table.get(f"top_{key}") if side == "top" else None
            return own if is_number(own) else table.get(key)

        numbers = [either("radius_m"), *(table.get(key) for key in (f"{side}_height_mm", diameter)), either("travel_mm"), table.get("rim_height_mm")]
        if not all(is_number(number) for number in numbers):
            return None
        radius, height, wide, travel, rim = numbers
        return Face(radius, height / 1e3, wide / 2e3, travel / 1e3, rim / 1e3)

    found = [face(isolator, "bottom", "slider_diameter_mm"), face(inner, "bottom", "diameter_mm"), face(inner, "top", "diameter_mm"),
             face(isolator, "top", "slider_diameter_mm")]
    known = [one for one in found if one is not None]
    return known if len(known) == 4 else None


def turns(known: list[Face]) -> tuple[float, float, float]:
    """Of slide plate, inner slider and slide plate where the last rim is touched."""
    inner = min(known[0].tilt + known[1].tilt, known[2].tilt + known[3].tilt)
    return min(known[0].tilt, inner + known[1].tilt), inner, min(known[3].tilt, inner + known[2].tilt)


def lengths(known: list[Face]) -> tuple[float, float, float]:
    """Between the centres of the spheres that each of the three holds."""
    R = [face.effective_radius for face in known]
    return R[0] - R[1], R[1] + R[2], R[3] - R[2]


def lateral_capacity(isolator: dict[str, Any]) -> float | None:
    """Where the last rim is touched; None where a dimension is not given."""
    known = faces(isolator)
    return sum(length * math.sin(turn) for length, turn in zip(lengths(known), turns(known))) if known else None
