#!/usr/bin/env python3
"""The tested LIR-DCFP specimen of the thesis's appendix B as solids, slowly driven to 185 mm and back: its rims are touched at 175 mm, its
slider's halves slide 10 mm on one another, so that the other side is touched at 165 mm.

Rung rigid-dish against the rigid bodies (scene lir-dcfp-specimen), whose loop is the closed form: the force while the dishes slide, the force
while the halves do, W tan(theta + atan mu_s), and where the rims are touched. The interface lies in the slider's middle here, and the rims and
plates, which the thesis does not draw, are assumed. Runs kept in FOLDER are not repeated. Prints the table, writes it to FOLDER/baseline.txt,
fails when a gate is missed.
usage: interface_loop.py RIMPACT FOLDER [meshes, e.g. 0,1: mesh 1 takes five times the work]"""
import itertools
import math
import pathlib
import sys

from kept_run import finish, gate, kept_run
from static_loops import at, branch, rows_of

R, HEIGHT, DIAMETER, EDGE, CAPACITY = 0.75, 0.085, 0.140, 0.002, 0.175  # [m]
WEIGHT, MU, MU_S, AMPLITUDE = 150e3, 0.066, 0.126, 0.185
FORCE_GATE, HIT_GATE = 0.005, 1e-3  # of the force there, [m]


def wall_radius():
    """At which the rounded edge touches at the capacity: out cos(theta) + down sin(theta) + e."""
    theta = math.asin(CAPACITY / (2 * R - HEIGHT))
    out = DIAMETER / 2 - EDGE
    return out * math.cos(theta) + math.sqrt((R - EDGE) ** 2 - out**2) * math.sin(theta) + EDGE


def solid_settings():
    bearing = {"surface.R0_m": R, "surface.planar_radius_mm": 1e3 * wall_radius(), "slider.diameter_mm": 1e3 * DIAMETER,
               "slider.height_mm": 1e3 * HEIGHT, "slider.edge_radius_mm": 1e3 * EDGE, "slider.mu_interface": MU_S,
               "slider.interface_gap_mm": 20, "rim.height_mm": 12, "rim.thickness_mm": 15, "plate.base_mm": 30, "contact.steel_ertalyte": MU}
    return ["bearing.name=lir-dcfp-155", "load.vertical_kN=150", *(f"bearing.{key}={value}" for key, value in bearing.items())]


def touch(rows, back):
    """Travel at which the rims are touched: the gap has come to nothing, on the way back after it has opened."""
    open_yet = not back
    for (u, _, gap), (next_u, _, next_gap) in itertools.pairwise(rows[::-1] if back else rows):
        open_yet = open_yet or next_gap > 0.01
        if open_yet and gap > 0 >= next_gap:
            return u + gap / (gap - next_gap) * (next_u - u)
    return math.nan


def compared(solid, rigid):
    """Figure, ours, theirs, error, its unit and its bound: forces on both ways of the loop, and where the rims are touched."""
    for back, name in ((False, "out"), (True, "back")):
        ways = [branch(rows, back) for rows in (solid, rigid)]
        for travel, what in ((0.10, "dishes slide"), (0.150, "dishes slide"), (0.182, "halves slide")):
            f, r = (abs(at(way, -travel if back else travel, 1)) for way in ways)
            yield f"{name} at {1e3 * travel:.0f} mm, {what} [kN]", f / 1e3, r / 1e3, 100 * (f / r - 1), "%", 100 * FORCE_GATE
        s, r = (abs(touch(way, back)) for way in ways)
        yield f"{name}, rims touched at [mm]", 1e3 * s, 1e3 * r, 1e3 * (s - r), "mm", 1e3 * HIT_GATE


def main(program, folder, meshes="0"):
    folder = pathlib.Path(folder)
    motion = [f"excitation.amplitude_m={AMPLITUDE}", "excitation.cycles=1"]
    kept_run(program, "reduced", "lir-dcfp-specimen", folder / "rigid", motion)
    lines, failures = [f"{'figure':34s}    solid    rigid   error"], []
    for mesh in meshes.split(","):
        summary = kept_run(program, "run", "static-unidirectional", folder / f"solid_{mesh}",
                           [*motion, *solid_settings(), f"model.mesh={mesh}", "model.rung=rigid-dish"])
        for name, ours, theirs, error, unit, bound in compared(*(rows_of(folder / run, ("ux_m", "Fx_N", "gap_m")) for run in (f"solid_{mesh}", "rigid"))):
            lines.append(f"{name:34s} {ours:8.2f} {theirs:8.2f} {error:7.2f} {unit}")
            gate(failures, f"{name}, mesh {mesh}", error, bound)
        imbalance = summary["energy"]["imbalance_relative"]
        lines.append(f"# mesh {mesh}: {summary['n_dofs']} unknowns, {summary['n_steps']} steps, {summary['n_newton_iterations']} Newton iterations, "
                     f"{summary['cuts']} cuts, imbalance {imbalance:.1e}")
        gate(failures, f"imbalance, mesh {mesh}", imbalance, 1e-3)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
