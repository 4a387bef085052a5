#!/usr/bin/env python3
"""The pad's frictional seat beside the tied one: quasi-static loops to 0.39 m, windows of 0.2 m/s with weight and friction, and
the 0.78 g pulse x 1.05, all from the same mesh. The frictional pad fits its recess without clearance.

Gates: the energy's imbalance below 1e-3 everywhere; the force of the loops within 3 % of the tied pad's force on the way out at
the same place; a window's peak force within 3 %; the pulse touches. Runs kept in FOLDER are not repeated. Prints the table,
writes it to FOLDER/baseline.txt, fails when a gate is missed.
usage: pad_seat.py RIMPACT FOLDER [mesh of loops and pulses, 0] [parts, e.g. loop,window,pulse]"""
import pathlib
import sys

from kept_run import finish, gate, kept_run
from static_loops import at, branch, loop

FRICTIONAL = 'bearing.contact.pad_foot="frictional"'
SEATS = {"tied": [], "frictional": [FRICTIONAL]}
WINDOW = ['excitation.with=["weight","friction"]', "excitation.duration_s=0.05", "excitation.speed_m_per_s=0.2"]
PULSE = ["excitation.scale=1.05", "excitation.duration_s=3"]


def ends(run):
    seat = run.get("seat")
    worked = f"{seat['friction_J']:8.1f} {1e-6 * seat['largest_pressure_on_wall_Pa']:8.1f}" if seat else f"{'-':>8s} {'-':>8s}"
    return f"{worked} {run['n_dofs']:6d} {run['n_steps']:6d} {run['n_newton_iterations']:6d} {run['energy']['imbalance_relative']:9.1e}"


ENDS = "  seat_J wall_MPa   dofs  steps newton imbalance"


def loops(program, folder, mesh, failures):
    lines = [f"# loops to 0.39 m, mesh {mesh}: force [kN] out at 0.10, 0.31, 0.39 m and back at 0.31, 0.10 m; dissipated by friction [kJ]",
             f"{'seat':10s} {'out 0.10':>8s} {'out 0.31':>8s} {'out 0.39':>8s} {'back 0.31':>9s} {'back 0.10':>9s} {'lost_kJ':>8s} {ENDS}"]
    forces = {}
    for seat, settings in SEATS.items():
        rows, run = loop(program, "run", folder / f"loop_{seat}_mesh{mesh}", [*settings, 'model.rung="rigid-dish"', f"model.mesh={mesh}"])
        forces[seat] = [at(branch(rows, back), travel, 1) for back, travel in ((0, 0.10), (0, 0.31), (0, 0.39), (1, 0.31), (1, 0.10))]
        lines.append(f"{seat:10s} " + " ".join(f"{-force / 1e3:{width}.1f}" for force, width in zip(forces[seat], (8, 8, 8, 9, 9)))
                     + f" {run['energy']['friction_J'] / 1e3:8.2f} {ends(run)}")
        gate(failures, f"imbalance of the loop, {seat}", run["energy"]["imbalance_relative"], 1e-3)
        for force, tied, out in zip(forces[seat], forces["tied"], [*forces["tied"][:3], forces["tied"][1], forces["tied"][0]]):
            gate(failures, f"force of the loop over the tied one, {seat}", (force - tied) / out, 0.03)
    return lines


def impacts(program, folder, mesh, failures, windows):
    what = "windows of 0.2 m/s, mesh 0" if windows else f"the 0.78 g pulse x 1.05 by rung rigid-dish, mesh {mesh}"
    lines = [f"# {what}: speed at touch [m/s], peak force [kN], against tied, deepest [mm], rebound over approach",
             f"{'seat':10s} {'rung':10s} {'touch':>7s} {'peak_kN':>8s} {'tied_%':>7s} {'press_mm':>8s} {'rebound':>8s} {ENDS}"]
    for rung in ("rigid-dish", "full") if windows else ("rigid-dish",):
        tied = None
        for seat, settings in SEATS.items():
            scene, own = ("impact-window", WINDOW) if windows else ("ricker-0.78g-1.0s", PULSE)
            name = f"{'window' if windows else 'pulse'}_{rung}_{seat}_mesh{mesh}"
            run = kept_run(program, "run", scene, folder / name, [*own, *settings], ["--rung", rung, "--mesh", str(mesh), "--no-fields"])
            first, force = run["impacts"][0], run["peak_impact_force_N"]
            tied = tied or force
            lines.append(f"{seat:10s} {rung:10s} {first['approach_speed_m_s']:7.4f} {force / 1e3:8.1f} {100 * (force / tied - 1):7.2f} "
                         f"{1e3 * first['peak_penetration_m']:8.3f} {first['restitution']:8.4f} {ends(run)}")
            gate(failures, f"imbalance of {name}", run["energy"]["imbalance_relative"], 1e-3)
            if windows:
                gate(failures, f"peak force over the tied one, {name}", force / tied - 1, 0.03)
    return lines


def main(program, folder, mesh=0, parts="loop,window,pulse"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lines, failures = [], []
    if "loop" in parts:
        lines += loops(program, folder, int(mesh), failures)
    if "window" in parts:
        lines += impacts(program, folder, 0, failures, True)
    if "pulse" in parts:
        lines += impacts(program, folder, int(mesh), failures, False)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
