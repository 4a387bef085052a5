"""A model of one's own: a mass on the bearing's dish, and a rim that yields by a power law and unloads along a straight line.

It knows nothing of rimpact but the scene of the impact it is to compute. Units are SI."""
import math

import numpy as np
import pandas as pd
import rimpact

STIFFNESS = 8.9e6   # of the loading F = STIFFNESS d^HARDENING [N/m^HARDENING], by hand to the windows at 0.2 and 0.7 m/s
HARDENING = 0.37
UNLOADING = 1.7e9  # slope of the way back [N/m], by hand to the rebound at 0.35 m/s


def height_slope(u: float) -> tuple[float, float]:
    """z' and z'' of the dish, an ellipse of radius R0 at its vertex and half-width a (shfps-225)."""
    R0, a = 2.25, 0.5625
    b, root = a * a / R0, math.sqrt(1 - (u / a) ** 2)
    return b * u / (a * a * root), b / (a * a * root**3)


def impact(scene: rimpact.Scene, touch: float, speed: float, end: float) -> pd.DataFrame:
    """The mass that touches the rim at `touch` [m] with `speed` [m/s], until `end` [s]: displacement and forces over time."""
    step, friction = 2e-6, 0.07
    u, v, deepest = touch, speed, 0.0
    rows = []
    for i in range(round(end / step) + 1):
        d = u - scene.lateral_capacity
        deepest = max(deepest, d)
        loading = STIFFNESS * max(deepest, 0.0) ** HARDENING
        rim = max(0.0, loading - UNLOADING * (deepest - d)) if d > 0 else 0.0
        slope, curvature = height_slope(u)
        normal = scene.weight + scene.mass * curvature * v * v
        dish = normal * (slope + friction * math.copysign(1.0, v))
        rows.append((i * step, u, -dish - rim, -rim))
        v -= step * (dish + rim) / (scene.mass * (1 + slope * slope))  # the mass moves along the dish
        u += step * v
    table = pd.DataFrame(rows, columns=["time", "displacement_x", "force_x", "impact_x"])
    return table.iloc[np.unique(np.append(np.arange(0, len(table), 10), len(table) - 1))].set_index("time")
