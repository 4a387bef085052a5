#!/usr/bin/env python3
"""What tetrahedra cost on our rim: `rim-push`, 4 mm in, by the built-in meshes and by a drawing of the same rim and slider, its lower edge
rounded, that gmsh fills with tetrahedra (each divided into four hexahedra).

The force over the travel is held against the built-in meshes' extrapolated with the observed order. Gates: with the finest tetrahedra the force
at the deepest point is within 2 %, its mean over the way in within 2 %.
Runs kept in FOLDER are not repeated. Prints the table, writes it to FOLDER/baseline.txt, fails when a gate is missed.
usage: tetrahedra.py RIMPACT FOLDER [contact sizes in mm]"""
import csv
import math
import pathlib
import sys

import numpy as np
from extrapolation import extrapolated
from kept_run import finish, gate, kept_run

TRAVEL = 4.0  # mm
WAY_IN = np.arange(0.5, TRAVEL + 0.01, 0.5)
# shfps-225 [mm]: half-width and vertex radius of the ellipse, dish's edge, rim, plate; slider
A, R0, EDGE, RIM_HEIGHT, OUTER, BASE, CUT = 562.5, 2250.0, 520.0, 60.0, 560.0, -50.0, 440.0
RADIUS, BOTTOM, TOP, ROUNDING, CAP = 120.0, 58.25, 158.25, 2.0, 90.0
MESHES, SIZES = (0, 1, 2), (10.0, 4.0)
HEAD = "mesh               dofs  steps newton  force_kN  over_%  mean_kN  over_%  imbalance  seconds"


def dish(r):
    """Height of the dish (eq. 2-2)."""
    b = A * A / R0
    return b * (1 - math.sqrt(1 - (r / A) ** 2))


def profile(name, points, curves, axis, angle):
    """A plane surface of points (r, z) about an upright axis, turned by `angle`: gmsh's text. `curves`: their points' numbers, two of a line, three of an arc, more of a spline."""
    kinds = {2: "Line", 3: "Circle"}
    lines = [f"{name}[] = {{}};"] + [f"p{name}{i} = newp; Point(p{name}{i}) = {{{axis + r:.15g}, 0, {z:.15g}}};" for i, (r, z) in enumerate(points)]
    for i, curve in enumerate(curves):
        lines.append(f"c{name}{i} = newc; {kinds.get(len(curve), 'Spline')}(c{name}{i}) = {{{', '.join(f'p{name}{k}' for k in curve)}}};")
    loop = ", ".join(f"c{name}{i}" for i in range(len(curves)))
    return lines + [f"l{name} = newll; Curve Loop(l{name}) = {{{loop}}};", f"s{name} = news; Plane Surface(s{name}) = {{l{name}}};",
                    f"{name}[] = Extrude {{{{0, 0, 1}}, {{{axis:.15g}, 0, 0}}, {angle}}} {{ Surface{{s{name}}}; }};"]


def drawing():
    """Rim and slider at first touch: surfaces follow the profile's curves in order, name[2 + i]."""
    travel, z0 = EDGE - RADIUS, dish(EDGE)
    up = dish(travel)
    along = [(r, dish(r)) for r in np.linspace(EDGE, CUT, 6)]
    plate = profile("plate", [(CUT, BASE), (OUTER, BASE), (OUTER, z0 + RIM_HEIGHT), (EDGE, z0 + RIM_HEIGHT), *along],
                    [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5, 6, 7, 8, 9), (9, 0)], 0, 1)
    opening, bottom = math.sqrt(CAP**2 - BOTTOM**2), BOTTOM + up
    slider = profile("slider", [(opening, bottom), (RADIUS - ROUNDING, bottom), (RADIUS - ROUNDING, bottom + ROUNDING), (RADIUS, bottom + ROUNDING),
                                (RADIUS, TOP + up), (0, TOP + up), (0, up + CAP), (0, up)],
                     [(0, 1), (1, 2, 3), (3, 4), (4, 5), (5, 6), (6, 7, 0)], travel, "Pi")
    groups = {"Volume": {"plate": "plate[1]", "upper_slider": "slider[1]"},
              "Surface": {"fixed": "plate[2]", "rim_wall": "plate[5]", "sector_end": "plate[7], plate[0]", "symmetry": "splate, sslider, slider[0]",
                          "slider_side": "slider[3], slider[4]", "top": "slider[5]"}}
    named = [f'Physical {kind}("{name}") = {{{what}}};' for kind, names in groups.items() for name, what in names.items()]
    return "\n".join(['SetFactory("OpenCASCADE");', *plate, *slider, *named]) + "\n"


class Push:
    """Force at the deepest point and its mean over the way in [kN]."""

    def __init__(self, summary, folder):
        rows = list(csv.DictReader((folder / "response.csv").read_text().splitlines()))
        travel, force = (np.array([float(row[key]) for row in rows]) for key in ("gap_m", "Fx_N"))
        travel, force = -1e3 * travel, 1e-3 * np.abs(force)
        deepest = int(np.argmax(travel)) + 1
        on_the_way = np.interp(WAY_IN, travel[:deepest], force[:deepest])
        self.summary, self.deepest, self.mean = summary, on_the_way[-1], on_the_way.mean()

    def line(self, name, exact):
        s = self.summary
        over = [100 * (value / of - 1) for value, of in zip((self.deepest, self.mean), exact)]
        return (f"{name:15s} {s['n_dofs']:7d} {s['n_steps']:6d} {s['n_newton_iterations']:6d} {self.deepest:9.1f} {over[0]:+7.2f} {self.mean:8.1f} "
                f"{over[1]:+7.2f} {s['energy']['imbalance_relative']:10.1e} {s['processor_time_s']:8.0f}")


def push(program, folder, *settings, options=()):
    scene = [f"excitation.travel_mm={TRAVEL}", "excitation.return=false", *settings]
    return Push(kept_run(program, "run", "rim-push", folder, scene, ["--no-fields", *options]), folder)


def limit(values):
    """What three meshes tend to; the finest one's where they do not converge."""
    coarse, middle, fine = values
    return extrapolated(values) if (coarse - middle) / (middle - fine) > 1.5 else fine


def main(program, folder, sizes=SIZES):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    drawn = folder / "drawn.geo"
    drawn.write_text(drawing())
    ours = {mesh: push(program, folder / f"mesh{mesh}", options=["--mesh", str(mesh)]) for mesh in MESHES}
    exact = [limit([getattr(run, what) for run in ours.values()]) for what in ("deepest", "mean")]
    theirs = {size: push(program, folder / f"tetrahedra{size:g}", f'model.own_mesh.file="{drawn}"', 'model.own_mesh.unit="mm"', f"model.own_mesh.contact_size_mm={size}",
                         options=["--allow-script"]) for size in sizes}
    lines = [HEAD, *(run.line(f"built-in {mesh}", exact) for mesh, run in ours.items()), *(run.line(f"contact {size:g} mm", exact) for size, run in theirs.items())]
    failures, finest = [], theirs[min(sizes)]
    gate(failures, "force at the deepest point", finest.deepest / exact[0] - 1, 0.02)
    gate(failures, "mean force over the way in", finest.mean / exact[1] - 1, 0.02)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], tuple(float(size) for size in sys.argv[3].split(",")) if len(sys.argv) > 3 else SIZES))
