#!/usr/bin/env python3
"""Refinement of the rim window at 0.1 and 0.5 m/s: meshes 1, 2, 3 and half the step. Prints (and writes as text baseline) peak force,
rebound, error against the finest mesh, unknowns, iterations, seconds; fails when a gate is missed:
mesh 1 within 4 %, mesh 2 within 1.5 % of mesh 3 in peak force; halving the step changes the rebound by less than 0.5 %;
integrator loss below 1 % of the impact's energy; imbalance below 1e-3."""
import pathlib
import sys

from kept_run import finish, gate, kept_run

SPEEDS = (0.1, 0.5)


def window(program, folder, speed, mesh, *settings):
    name = f"v{speed}_mesh{mesh}" + "".join("_" + s.split(".")[-1].replace("=", "") for s in settings)
    return kept_run(program, "run", "impact-window", folder / name, [f"excitation.speed_m_per_s={speed}", *settings],
                    ["--mesh", str(mesh), "--no-fields"])


def main(program, folder, meshes=(1, 2, 3)):
    folder = pathlib.Path(folder)
    lines = ["speed mesh step_ms   dofs  steps newton seconds  peak_kN  error_%  rebound  loss/energy imbalance"]
    failures = []
    for speed in SPEEDS:
        runs = {(mesh, 1.0): window(program, folder, speed, mesh) for mesh in meshes}
        runs[(1, 0.5)] = window(program, folder, speed, 1, "model.step_ms=0.5")
        finest = runs[(max(meshes), 1.0)]["peak_impact_force_N"]
        for (mesh, step), run in sorted(runs.items()):
            impact, energy = run["impacts"][0], run["energy"]
            error = run["peak_impact_force_N"] / finest - 1
            loss = energy["integrator_J"] / energy["initial_J"]
            lines.append(f"{speed:5.2f} {mesh:4d} {step:7.2f} {run['n_dofs']:6d} {run['n_steps']:6d} {run['n_newton_iterations']:6d} "
                         f"{run['wall_time_s']:7.0f} {run['peak_impact_force_N'] / 1e3:8.1f} {100 * error:8.2f} "
                         f"{impact['restitution']:8.4f} {loss:12.2e} {energy['imbalance_relative']:9.1e}")
            gate(failures, f"integrator loss at {speed}", loss, 0.01)
            gate(failures, f"imbalance at {speed}", energy["imbalance_relative"], 1e-3)
            if mesh < max(meshes):
                gate(failures, f"peak force of mesh {mesh} at {speed}", error, {1: 0.04, 2: 0.015}[mesh])
        rebound = [runs[(1, step)]["impacts"][0]["rebound_speed_m_s"] for step in (1.0, 0.5)]
        gate(failures, f"rebound over half the step at {speed}", rebound[0] / rebound[1] - 1, 0.005)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], tuple(int(m) for m in sys.argv[3].split(",")) if len(sys.argv) > 3 else (1, 2, 3)))
