#!/usr/bin/env python3
"""Refinement of rung rigid-dish: the window at 0.5 m/s (weight and friction) and the static cycle at 0.39 m, on the draft mesh
and finer ones, and on the draft mesh with another step, penalty and spectral radius. What each does to peak force, rebound, plastic
strain and the pad's largest pressure.

Gates, against the draft mesh as it is: half the step, a third of and three times the penalty, rho_inf 0 and 1 change the force by less than
1 %; against the finest mesh: mesh 1 within 4 %; imbalance below 1e-3. Runs kept in FOLDER are not repeated. Prints the table, writes it to
FOLDER/baseline.txt, fails when a gate is missed.
usage: stack_refinement.py RIMPACT FOLDER [meshes, e.g. 0,1,2]"""
import pathlib
import sys

import h5py
from kept_run import WINDOW_ON_THE_DISH, finish, gate, kept_run

SCENES = {"window": ("impact-window", [*WINDOW_ON_THE_DISH, "excitation.speed_m_per_s=0.5"]), "cycle": ("static-unidirectional", ["excitation.amplitude_m=0.39"])}
CHANGES = {"window": ["model.step_ms=0.5", "model.penalty_scale=0.3", "model.penalty_scale=3", "model.rho_inf=0", "model.rho_inf=1"],
           "cycle": ["model.penalty_scale=0.3", "model.penalty_scale=3"]}


def run_of(program, folder, name, mesh, change):
    scene, settings = SCENES[name]
    slug = f"{name}_mesh{mesh}" + ("_" + change.removeprefix("model.").replace("=", "_") if change else "")
    summary = kept_run(program, "run", scene, folder / slug, [*settings, *([change] if change else [])],
                       ["--rung", "rigid-dish", "--mesh", str(mesh), "--no-fields"])
    with h5py.File(folder / slug / "response.h5") as file:
        pad = file["response/pad_pressure_max"][:].max()
    force = summary["peak_impact_force_N"] if name == "window" else summary["peak_lateral_force_N"]
    return summary, force, pad


def line(name, mesh, change, run, reference):
    summary, force, pad = run
    rebound = f"{summary['impacts'][0]['restitution']:8.4f}" if summary["impacts"] else f"{'-':>8s}"
    return (f"{name:7s} {mesh:4d} {change.replace('model.', '') or '-':18s} {summary['n_dofs']:6d} {summary['n_steps']:6d} "
            f"{summary['n_newton_iterations']:6d} {summary['wall_time_s']:8.0f} {force / 1e3:8.1f} {100 * (force / reference - 1):8.2f} {rebound} "
            f"{summary.get('max_plastic_strain') or 0:8.4f} {pad / 1e6:8.1f} {summary['energy']['imbalance_relative']:9.1e}")


def main(program, folder, meshes=(0, 1, 2)):
    folder = pathlib.Path(folder)
    lines = ["scene   mesh change               dofs  steps newton  seconds force_kN  error_%  rebound   strain  pad_MPa imbalance"]
    failures = []

    for name in SCENES:
        runs = {(mesh, ""): run_of(program, folder, name, mesh, "") for mesh in meshes}
        runs |= {(meshes[0], change): run_of(program, folder, name, meshes[0], change) for change in CHANGES[name]}
        finest, base = runs[(meshes[-1], "")][1], runs[(meshes[0], "")][1]
        for (mesh, change), run in runs.items():
            lines.append(line(name, mesh, change, run, base if change else finest))
            gate(failures, f"imbalance of {name}, mesh {mesh} {change}", run[0]["energy"]["imbalance_relative"], 1e-3)
            if change:
                gate(failures, f"force of {name} with {change}", run[1] / base - 1, 0.01)
            elif mesh == 1:
                gate(failures, f"force of {name} on mesh 1", run[1] / finest - 1, 0.04)
    lines.append("# error: over the finest mesh; of a changed setting, over the same mesh without the change")
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], tuple(int(m) for m in sys.argv[3].split(",")) if len(sys.argv) > 3 else (0, 1, 2)))
