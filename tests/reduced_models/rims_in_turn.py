"""rims_in_turn.py RIMPACT FOLDER [BASELINE]: one rim of a DCFP touched after the other, by rigid bodies.

Bearing dcfp-155, both rims with the law that rung rim finds of them; the mass is thrown at them from 285 mm. The top rim stands so many
millimetres of the bearing's way behind the bottom one. Beside it: both rims where their mean is, which is what solids with two like dishes
have. Force, rebound and speed of approach are of the top rim, which is touched second and pushes the mass. Compares with BASELINE to 0.1 %."""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from stored_table import differ  # noqa: E402

# The law is that of data/thesis/refitted.json: `rimpact main dcfp-155 --windows-only`, windows of 0.1 to 0.4 m/s on mesh 1, one rim of the two.
CAPACITY = 0.3  # of both rims, or of the bottom one [m]
SETTINGS = {"reduced.model": '"dcfp"', "excitation.kind": '"free"', "excitation.displacement_m": "[0.285, 0]", "excitation.duration_s": 0.5,
            "load.vertical_kN": 1964.9, "load.mass_kg": 200300, "reduced.mu_fast": 0.05, "isolator.top_wall_mm": 50.0,
            "reduced.impact_law": '"elastoplastic"', "reduced.k_i_kN_per_m": 300122, "reduced.yield_force_kN": 342.694, "reduced.hardening": 0.41441,
            "reduced.unloading_gain": 4.8282, "reduced.hardening_exponent": 0.75, "reduced.unloading_exponent": 0.5}


def run(program: str, folder: str, speed: float, bottom: float, top: float) -> dict[str, float]:
    settings = SETTINGS | {"excitation.velocity_m_per_s": f"[{speed}, 0]", "isolator.capacity_m": bottom, "isolator.top_capacity_m": top}
    words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([program, "reduced", "lir-dcfp-stages", "-o", f"{folder}/run", "--force", "--quiet", *words], check=True, capture_output=True)
    with open(f"{folder}/run/summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    first, = summary["impacts"][:1] or [{"approach_speed_m_s": 0.0, "peak_force_N": 0.0, "restitution": 0.0}]
    return {"force": first["peak_force_N"] / 1e3, "speed": first["approach_speed_m_s"], "e": first["restitution"]}


def table(program: str, folder: str) -> list[str]:
    lines = ["thrown at  apart | in turn: approach  peak_kN rebound | at once, in the middle: peak_kN rebound   force"]
    for speed in (0.3, 0.6, 1.0):
        for apart in (0.0, 0.001, 0.003, 0.010):
            turn = run(program, folder, speed, CAPACITY, CAPACITY + apart)
            once = run(program, folder, speed, CAPACITY + apart / 2, CAPACITY + apart / 2)
            lines.append(f"{speed:5.1f} m/s {1e3 * apart:4.0f} mm | {turn['speed']:13.3f} m/s {turn['force']:8.1f} {turn['e']:7.3f} | "
                         f"{once['force']:31.1f} {once['e']:7.3f} {100 * (once['force'] / turn['force'] - 1):+6.2f} %")
    return lines


def main(program: str, folder: str, baseline: str | None = None) -> int:
    os.makedirs(folder, exist_ok=True)
    lines = table(program, folder)
    print("\n".join(lines))
    if baseline is None:
        return 0
    with open(baseline, encoding="utf-8") as file:
        stored = file.read().splitlines()
    bad = [f"now: {a}\nbaseline: {b}" for a, b in zip(lines, stored, strict=True) if differ(a, b, 1e-3, 1.5e-3)]
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
