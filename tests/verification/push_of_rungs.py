#!/usr/bin/env python3
"""The quasi-static push into the rim by every solid rung, with the weight on and friction: force of the rim at the deepest point.

Gates: rigid-dish within 2 % of full, energy imbalance of both below 1e-2 (the ledger of a path is summed by trapezia).
Runs kept in FOLDER are not repeated. Prints the table, writes it to FOLDER/baseline.txt, fails when a gate is missed.
usage: push_of_rungs.py RIMPACT FOLDER [mesh]"""
import pathlib
import sys

from kept_run import finish, kept_run


def main(program, folder, mesh="0"):
    folder = pathlib.Path(folder)
    lines, failures, force = ["rung       mesh   dofs  steps newton  cuts  seconds    GB  rim_kN   strain imbalance"], [], {}
    for rung in ("rim", "rigid-dish", "full"):
        run = kept_run(program, "run", "rim-push", folder / f"{rung}_mesh{mesh}", [], ["--rung", rung, "--mesh", mesh])
        force[rung] = run["peak_impact_force_N"]
        imbalance = run["energy"]["imbalance_relative"]
        lines.append(f"{rung:10s} {mesh:>4s} {run['n_dofs']:6d} {run['n_steps']:6d} {run['n_newton_iterations']:6d} {run['cuts']:5d} "
                     f"{run['wall_time_s']:8.1f} {run['peak_memory_bytes'] / 1e9:5.2f} {force[rung] / 1e3:7.1f} "
                     f"{run['max_plastic_strain']:8.4f} {imbalance:9.1e}")
        if rung != "rim" and not abs(imbalance) < 1e-2:
            failures.append(f"MISSED imbalance of {rung}: {imbalance:.1e}")
    off = force["rigid-dish"] / force["full"] - 1
    if not abs(off) < 0.02:
        failures.append(f"MISSED force of rigid-dish over full: {100 * off:.2f} % is not below 2 %")
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
