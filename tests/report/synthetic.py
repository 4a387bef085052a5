"""Run folders for the tests of the report ONLY: a one-dimensional toy in the files of a real run. Nothing here is a
result."""
import json
import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import h5py
import numpy as np

Motion = Callable[[float], float]
MASS, WEIGHT, GRAVITY, CAPACITY = 86952.0, 853e3, 9.81, 0.400
SCENE = """name = "{name}"
[bearing]
name = "shfps-225"
[bearing.surface]
kind = "ellipse"
R0_m = 2.25
a_m = 0.5625
planar_radius_mm = 520.0
[bearing.slider]
diameter_mm = 240.0
bottom_mm = 58.25 # assumption
top_mm = 158.25
edge_radius_mm = 2.0 # assumption
[bearing.rim]
height_mm = 60.0 # assumption
thickness_mm = 40.0 # assumption
ledge_mm = 0.0 # assumption
[bearing.plate]
base_mm = 50.0
[bearing.pad] # assumption
outer_radius_mm = 70.19
thickness_mm = 40.0
[bearing.foot]
radius_mm = 86.0
bottom_mm = 20.0
shoulder_mm = 33.0
cap_radius_mm = 90.0
[bearing.material.steel]
E_MPa = 200000.0
yield_MPa = 360.0
tangent_modulus_MPa = 1450.0 # assumption
[load]
vertical_kN = 853.0
mass_kg = 86952.0
gravity_m_per_s2 = 9.81
[excitation]
{excitation}
direction_deg = 0.0
[model]
rung = "rim"
mesh = 1
[reduced]
model = "physical"
k_i_kN_per_m = {k:.6g}
restitution = {e:.4g}
impact_law = "{law}"
"""


class Rim:
    """k (d - dent), yielding above a force; with a dashpot when e < 1."""

    def __init__(self, k: float, e: float = 1.0, yield_force: float = math.inf, hardening: float = 0.05) -> None:
        self.k, self.yield_force, self.hardening, self.dent = k, yield_force, hardening, 0.0
        self.c = -2 * math.log(e) / math.hypot(math.pi, math.log(e)) * math.sqrt(k * MASS)

    def force(self, u: float, v: float) -> float:
        depth = abs(u) - CAPACITY - self.dent
        if depth <= 0:
            return 0.0
        limit = self.yield_force + self.hardening * self.k * self.dent
        if self.k * depth > limit:
            flow = (self.k * depth - limit) / (self.k * (1 + self.hardening))
            self.dent, depth = self.dent + flow, depth - flow
        return math.copysign(max(0.0, self.k * depth + self.c * v * math.copysign(1, u)), u)


def pendular(u: float) -> float:
    slope = u / 2.25 / math.sqrt(max(1e-3, 1 - (u / 0.5625) ** 2))
    return WEIGHT * slope


def height(u: np.ndarray) -> np.ndarray:
    return 0.140625 * (1 - np.sqrt(np.maximum(1e-6, 1 - (np.asarray(u) / 0.5625) ** 2)))


def ricker(amplitude_g: float, period: float) -> Motion:
    def motion(t: float) -> float:
        p = (math.pi * (t - 2 * period) / period) ** 2
        return amplitude_g * GRAVITY * (1 - 2 * p) * math.exp(-p)
    return motion


def integrate(rim: Rim, motion: Motion, u: float = 0.0, v: float = 0.0, end: float = 8.0, window: bool = False, step: float = 2.5e-4) -> np.ndarray:
    """Semi-implicit Euler; samples every 5 ms in flight and every step in contact."""
    rows, t, external, friction_work = list[tuple[float, ...]](), 0.0, 0.0, 0.0
    kept = 0
    while t <= end:
        f_rim, f_p = rim.force(u, v), 0.0 if window else pendular(u)
        f_f = 0.0 if window else 0.07 * WEIGHT * math.tanh(v / 2e-3)
        if f_rim or kept % 20 == 0 or (rows and rows[-1][5]):
            rows.append((t, u, v, f_p, f_f, f_rim, external, friction_work, rim.dent))
        a_g = motion(t)
        v += step * (-a_g - (f_p + f_f + f_rim) / MASS)
        u += step * v
        external += -MASS * a_g * v * step
        friction_work += f_f * v * step
        t, kept = t + step, kept + 1
    return np.array(rows).T


def run(folder: str, name: str, excitation: str, motion: Motion, rim: Rim, rung: str, window_speed: float | None = None, status: str = "done",
        truncate: float = 1.0, law: str = "signed", warnings: Sequence[str] = ()) -> dict[str, Any]:
    os.makedirs(folder, exist_ok=True)
    start: dict[str, Any] = dict(u=CAPACITY - 1e-6, v=window_speed, end=0.12, window=True) if window_speed else {}
    t, u, v, f_p, f_f, f_rim, external, spent, dent = integrate(rim, motion, **start)
    n = int(truncate * len(t))
    t, u, v, f_p, f_f, f_rim, external, spent, dent = (x[:n] for x in (t, u, v, f_p, f_f, f_rim, external, spent, dent))
    zero, z = np.zeros_like(t), 0 * t if window_speed else height(u)
    kinetic = 0.5 * MASS * v**2
    gravity = WEIGHT * z
    rest = external + kinetic[0] - kinetic - gravity - spent
    elastic = f_rim**2 / (2 * rim.k)
    signals = {"time": t, "displacement_x": u, "displacement_y": zero, "displacement_z": z, "velocity_x": v,
               "velocity_y": zero, "velocity_z": zero, "force_x": -(f_p + f_f + f_rim), "force_y": zero,
               "force_z": zero + WEIGHT, "pendular_x": -f_p, "pendular_y": zero, "friction_x": -f_f,
               "friction_y": zero, "impact_x": -f_rim, "impact_y": zero, "gap": CAPACITY - np.abs(u),
               "energy_external": external, "energy_kinetic": kinetic, "energy_gravity": gravity,
               "energy_friction": spent, "energy_elastic": elastic}
    fe = rung != "reduced"
    signals["energy_plastic" if fe else "energy_impact"] = np.maximum.accumulate(np.maximum(0, rest - elastic))
    if fe:
        signals["plastic_strain_max"] = 2 * dent
    write_signals(folder, signals)
    with open(os.path.join(folder, "scene.toml"), "w", encoding="utf-8") as file:
        file.write(SCENE.format(name=name, excitation=excitation, k=rim.k / 1e3, e=0.65, law=law))
    summary = summarise(signals, rung, status) | ({"warnings": list(warnings)} if warnings else {})
    with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
        json.dump(summary, file, indent=1)
    return summary


def write_signals(folder: str, signals: Mapping[str, np.ndarray]) -> None:
    with h5py.File(os.path.join(folder, "response.h5"), "w") as file:
        group = file.create_group("response")
        for name, values in signals.items():
            data = group.create_dataset(name, data=values)
            data.attrs["units"], data.attrs["description"] = "SI", "synthetic"
        file.create_group("meta").attrs["version"] = "0.1.0-synthetic"
    columns = ("time", "displacement_x", "displacement_y", "displacement_z", "force_x", "force_y", "force_z", "impact_x",
               "impact_y", "gap")
    np.savetxt(os.path.join(folder, "response.csv"), np.column_stack([signals[c] for c in columns]), delimiter=",",
               header="time_s,ux_m,uy_m,uz_m,Fx_N,Fy_N,Fz_N,Ix_N,Iy_N,gap_m", comments="")


def summarise(s: Mapping[str, np.ndarray], rung: str, status: str) -> dict[str, Any]:
    touching = np.concatenate([[0], (s["impact_x"] != 0).astype(int), [0]])
    impacts = list[dict[str, Any]]()
    for a, b in zip(np.flatnonzero(np.diff(touching) == 1), np.flatnonzero(np.diff(touching) == -1) - 1):
        side = math.copysign(1.0, s["displacement_x"][a])
        approach, rebound = side * s["velocity_x"][a], -side * s["velocity_x"][b]
        impacts.append({"touch_time_s": s["time"][a], "release_time_s": s["time"][b],
                        "direction_deg": 0.0 if side > 0 else 180.0, "approach_speed_m_s": approach,
                        "rebound_speed_m_s": rebound, "restitution": rebound / approach if approach else None,
                        "peak_force_N": float(np.max(np.abs(s["impact_x"][a:b + 1]))),
                        "peak_penetration_m": float(np.max(-s["gap"][a:b + 1]))})
    fe = rung != "reduced"
    energy = {f"{n}_J": float(s[f"energy_{n}"][-1]) if f"energy_{n}" in s else 0.0 for n in
              ("external", "gravity", "kinetic", "elastic", "plastic", "friction", "impact", "contact", "integrator")}
    energy |= {"initial_J": float(s["energy_kinetic"][0]), "imbalance_relative": 3.1e-4}
    return {"peak_displacement_m": float(np.max(np.abs(s["displacement_x"]))),
            "peak_lateral_force_N": float(np.max(np.abs(s["force_x"]))),
            "peak_impact_force_N": float(np.max(np.abs(s["impact_x"]))) if impacts else None,
            "n_impacts": len(impacts), "impacts": impacts, "residual_displacement_m": float(abs(s["displacement_x"][-1])),
            "peak_vertical_displacement_m": float(np.max(s["displacement_z"])), "min_normal_force_N": None,
            "max_plastic_strain": float(s["plastic_strain_max"][-1]) if fe else None, "energy": energy, "rung": rung,
            "mesh": 1 if fe else None, "n_dofs": 15822 if fe else 0, "n_steps": len(s["time"]),
            "n_newton_iterations": 3 * len(s["time"]) if fe else 0,
            "time_split_s": dict(search=1.2, assembly=14.0, factor=9.5, solve=2.1, output=0.8) if fe else {},
            "wall_time_s": 31.0 if fe else 8e-4, "peak_memory_bytes": 720_000_000 if fe else 9_000_000, "status": status,
            **({"reason": "step fell below 1e-7 s"} if status == "stopped" else {})}
