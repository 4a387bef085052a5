#!/usr/bin/env python3
"""Makes the curves kept in data/references, which a calibration to rung rigid-dish is fitted to, some hour and three quarters of one core: mesh 1, windows with weight and friction
from 0.07 to 1.2 m/s, Ricker pulses and the bidirectional one to half a second after release. Runs kept in FOLDER are not repeated. Of each run KEPT gets scene.toml,
summary.json and response.csv, nine digits, from the start on: a run folder `rimpact calibrate` and `compare` read.
Fails when a run's imbalance is 1e-3 or more, or it has no impact.
usage: reference_curves.py RIMPACT FOLDER KEPT [part of a run's name]"""
import json
import pathlib
import shutil
import sys

import h5py
import numpy as np
from kept_run import WINDOW_ON_THE_DISH, gate, kept_run

SPEEDS = (0.07, 0.1, 0.2, 0.35, 0.5, 0.7, 1.0, 1.2)  # [m/s]
PULSES = {"pulse-0.78g-1.05": ("ricker-0.78g-1.0s", 1.05, 3.1), "pulse-0.78g-1.10": ("ricker-0.78g-1.0s", 1.10, 3.1),
          "pulse-0.38g-1.05": ("ricker-0.38g-1.5s", 1.05, 4.3), "pulse-bidirectional": ("pulse-bidirectional", 1.0, 4.2)}  # scene, scale, end [s]
COLUMNS = {"time_s": "time", "ux_m": "displacement_x", "uy_m": "displacement_y", "uz_m": "displacement_z", "vx_m_per_s": "velocity_x",
           "vy_m_per_s": "velocity_y", "vz_m_per_s": "velocity_z", "Fx_N": "force_x", "Fy_N": "force_y", "Fz_N": "force_z",
           "Ix_N": "impact_x", "Iy_N": "impact_y", "gap_m": "gap"}
SHOWN_AFTER = 0.5  # [s], after the last release


def runs():
    for speed in SPEEDS:
        yield f"window-{speed:.2f}", "impact-window", [*WINDOW_ON_THE_DISH, f"excitation.speed_m_per_s={speed}"]
    for name, (scene, scale, end) in PULSES.items():
        yield name, scene, [f"excitation.scale={scale}", f"excitation.duration_s={end}"]


def keep(folder, kept, summary):
    kept.mkdir(parents=True, exist_ok=True)
    shutil.copy(folder / "scene.toml", kept / "scene.toml")
    end = summary["impacts"][-1]["release_time_s"] + SHOWN_AFTER
    with h5py.File(folder / "response.h5") as file:
        table = np.column_stack([file[f"response/{signal}"][:] for signal in COLUMNS.values()])
    table = table[table[:, 0] <= end]
    at_end = dict(zip(COLUMNS, table[-1].tolist(), strict=True))  # of what is kept, not of the run that was longer
    summary = {**summary, "residual_displacement_m": np.hypot(at_end["ux_m"], at_end["uy_m"]).item(),
               "final_speed_m_s": np.hypot(at_end["vx_m_per_s"], at_end["vy_m_per_s"]).item()}
    (kept / "summary.json").write_text(json.dumps(summary, indent=2, sort_keys=True) + "\n")
    np.savetxt(kept / "response.csv", table, fmt="%.9g", delimiter=",", header=",".join(COLUMNS), comments="")


def main(program, folder, kept, only=""):
    failures = []
    for name, scene, settings in runs():
        if only not in name:
            continue
        run = pathlib.Path(folder) / name
        summary = kept_run(program, "run", scene, run, settings, ["--rung", "rigid-dish", "--no-fields"])
        imbalance = summary["energy"]["imbalance_relative"]
        print(f"{name}: {1e-3 * summary['peak_impact_force_N']:.1f} kN, imbalance {imbalance:.1e}, {summary['wall_time_s']:.0f} s", flush=True)
        missed = len(failures)
        gate(failures, f"imbalance of {name}", imbalance, 1e-3)
        if not summary["impacts"]:
            failures.append(f"MISSED {name}: no impact")
        if len(failures) == missed:
            keep(run, pathlib.Path(kept) / name, summary)
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
