#!/usr/bin/env python3
"""What the steel's strain rate changes in a window, by the explicit program and by ours: pairs with and without Cowper and Symonds' D = 40 1/s, q = 5.

Mesh 0, each of its cells in eight for the explicit program. Gate: the changes of peak force and depth are within 4 points of each other.
Runs kept in FOLDER are not repeated. Prints the table, writes it to FOLDER/baseline.txt, fails when a gate is missed.
usage: rate_pairs.py RIMPACT PROGRAM FOLDER"""
import argparse
import pathlib
import sys

import explicit_rim

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from kept_run import finish, gate, kept_run  # noqa: E402

D, SPEEDS = 40.0, {0.2: 0.024, 1.0: 0.046}  # m/s: past the peak [s]
POINTS = 4.0
HEAD = "speed program       D 1/s   peak_kN depth_mm   change of: peak_%  depth_%"


def explicit(rimpact, program, folder, speed, rate):
    """Peak force [kN] and depth [mm]."""
    options = argparse.Namespace(rimpact=rimpact, program=program, folder=folder / f"v{speed}-D{rate:g}", mesh=0, divided=True, push=False, speed=speed, friction=0.0, rate_D=rate,
                                 step=3e-7, duration=SPEEDS[speed])
    options.folder.mkdir(parents=True, exist_ok=True)
    run = explicit_rim.kept(options, "impact-window")
    return run.force.max(), run.travel.max()


def ours(rimpact, folder, speed, rate):
    steel = ['bearing.material.steel.rate="cowper-symonds"', f"bearing.material.steel.rate_D_per_s={rate}"] if rate else []
    run = kept_run(rimpact, "run", "impact-window", folder / f"ours-v{speed}-D{rate:g}", [f"excitation.speed_m_per_s={speed}", f"excitation.duration_s={SPEEDS[speed]}", *steel],
                   ["--mesh", "0", "--no-fields"])
    impact = run["impacts"][0]
    return 1e-3 * impact["peak_force_N"], 1e3 * impact["peak_penetration_m"]


def main(rimpact, program, folder):
    folder = pathlib.Path(folder)
    lines, failures = [HEAD], []
    for speed in SPEEDS:
        changes = {}
        for name, made in (("explicit", lambda rate, v=speed: explicit(rimpact, program, folder, v, rate)), ("ours", lambda rate, v=speed: ours(rimpact, folder, v, rate))):
            static, fast = made(0.0), made(D)
            changes[name] = [100 * (b / a - 1) for a, b in zip(static, fast)]
            lines.append(f"{speed:5.2f} {name:12s} {'-':>6} {static[0]:9.1f} {static[1]:8.3f}")
            lines.append(f"{speed:5.2f} {name:12s} {D:6.0f} {fast[0]:9.1f} {fast[1]:8.3f}            {changes[name][0]:+6.1f}   {changes[name][1]:+6.1f}")
        for what, theirs, own in zip(("peak", "depth"), *changes.values()):
            gate(failures, f"change of the {what} at {speed} m/s, points", own - theirs, POINTS)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
