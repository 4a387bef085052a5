#!/usr/bin/env python3
"""What backstresses change of an opposite and of a second hit: a sine of two periods throws the slider at one side of the rim, at the other, and at
the first again, rung rim.

All three steels have one curve in tension, yield + Q (1 - exp(-b strain)): Q grows the yield surface, moves it (C = Q b, gamma = b), or each does a half.
Gates: the ledgers close within 2e-3, and first hits are alike within 5 % of peak and depth, for a first hit strains the steel mostly one way.

usage: second_hits.py RIMPACT FOLDER [MESH]
"""
import math
import pathlib
import sys

from kept_run import finish, gate, kept_run

Q, B = 200.0, 15.0
STEEL = "bearing.material.steel."
STEELS = {"isotropic": [f'{STEEL}hardening="voce"', f"{STEEL}hardening_Q_MPa={Q}", f"{STEEL}hardening_b={B}"],
          "half": [f'{STEEL}hardening="voce"', f"{STEEL}hardening_Q_MPa={Q / 2}", f"{STEEL}hardening_b={B}", f"{STEEL}chaboche=[[{Q / 2 * B}, {B}]]"],
          "kinematic": [f"{STEEL}tangent_modulus_MPa=0", f"{STEEL}chaboche=[[{Q * B}, {B}]]"]}
AMPLITUDE, PERIOD, PERIODS, REST, STEP = 0.19, 2.6, 2, 0.3, 0.01  # g, s
HEAD = "steel      hit side   speed  peak_kN  depth_mm  rebound   peak_%  depth_%"


def write_scene(folder):
    folder.mkdir(parents=True, exist_ok=True)
    n = round((PERIODS * PERIOD + REST) / STEP)
    rows = (f"{k * STEP:.2f},{AMPLITUDE * math.sin(2 * math.pi * k * STEP / PERIOD) if k * STEP < PERIODS * PERIOD else 0:.6f}" for k in range(n + 1))
    (folder / "sine.csv").write_text("\n".join(["time_s,acceleration_g", *rows]) + "\n")
    scene = folder / "sine.toml"
    scene.write_text('[bearing]\nname = "shfps-225"\n[load]\nvertical_kN = 853.0\nmass_kg = 86952.0\n[excitation]\nkind = "record"\nx = "sine.csv"\n')
    return str(scene)


def main(program, folder, mesh="0"):
    folder = pathlib.Path(folder)
    scene, lines, failures = write_scene(folder), [HEAD], []
    runs = {steel: kept_run(program, "run", scene, folder / steel, settings, ["--rung", "rim", "--mesh", mesh, "--no-fields"]) for steel, settings in STEELS.items()}
    first = runs["isotropic"]["impacts"]
    for steel, run in runs.items():
        gate(failures, f"imbalance of {steel} steel", run["energy"]["imbalance_relative"], 2e-3)
        for k, (hit, other) in enumerate(zip(run["impacts"], first)):
            peak, depth = (100 * (hit[key] / other[key] - 1) for key in ("peak_force_N", "peak_penetration_m"))
            lines.append(f"{steel:10s} {k + 1:3d} {hit['direction_deg']:4.0f} {hit['approach_speed_m_s']:7.3f} {hit['peak_force_N'] / 1e3:8.1f} "
                         f"{1e3 * hit['peak_penetration_m']:9.3f} {hit['restitution']:8.4f} {peak:8.1f} {depth:8.1f}")
            if k == 0:
                gate(failures, f"first peak of {steel} steel [%]", peak, 5)
                gate(failures, f"first depth of {steel} steel [%]", depth, 5)
        if len(run["impacts"]) < 3:
            failures.append(f"MISSED {steel} steel is hit {len(run['impacts'])} times")
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], *sys.argv[3:4]))
