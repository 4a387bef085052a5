#!/usr/bin/env python3
"""A millimetre of `rim-push` on mesh 0 with friction between the walls, against GetFEM's augmented Lagrangian of contact and Coulomb's law.

The slider rises as it presses: friction holds it down at first, and lets go as the rim leans out. Gates from 0.7 mm on: force within 3 %, the
upward force within 1 % of that force. Below, the contact is as narrow as a cell, and tractions that are quadratic in it differ from points.
Exit codes: 0 gates met, 1 missed, 77 GetFEM (Debian's python3-getfem) is absent (CTest: skipped)."""
import csv
import pathlib
import subprocess
import sys

import numpy as np

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "rim_calculix"))
from compare_rim_push import SKIPPED, arguments, missed, reporter, timed  # noqa: E402
from getfem_here import is_ready  # noqa: E402

FRICTION, TRAVEL, MESH = 0.2, 1.0, 0
DEPTHS = np.arange(0.1, TRAVEL + 1e-9, 0.1)  # mm
FROM = 0.65  # of what is judged [mm]
GATES = {"force": 0.03, "upward force, of the force": 0.01}


def at_depths(rows, travel, force, lift):
    """Force and upward force [kN] over depth on the way in."""
    values = np.array([[float(row[key]) for key in (travel, force, lift)] for row in rows])
    deepest = int(np.argmax(np.abs(values[:, 0]))) + 1
    return [np.interp(DEPTHS, np.abs(values[:deepest, 0]), values[:deepest, column]) for column in (1, 2)]


def main():
    options = arguments(__doc__).parse_args()
    if not is_ready(options):
        return SKIPPED
    folder, say = options.folder, reporter(options.write)
    settings = [word for setting in (f"model.mesh={MESH}", f"bearing.contact.rim={FRICTION}", f"excitation.travel_mm={TRAVEL}") for word in ("--set", setting)]
    timed([options.rimpact, "run", "rim-push", "-o", str(folder / "ours"), *settings, "--quiet", "--no-fields", "--force"], folder, folder / "ours.log", options.cores)
    subprocess.run([options.rimpact, "mesh", "--scene", "rim-push", "--curved", "-o", str(folder / "mesh.msh"), "--quiet", *settings], check=True)
    timed([sys.executable, str(HERE / "push_getfem.py"), str(folder / "mesh.msh"), str(folder / "ours/scene.toml"), str(folder / "getfem.csv"), "--steps", "4", "--multipliers", "2"],
          folder, folder / "getfem.log", options.cores)
    with open(folder / "ours/response.csv") as file:
        ours, up = at_depths([{"gap_m": 1e3 * float(row["gap_m"]), "Fx_N": -1e-3 * float(row["Fx_N"]), "Fz_N": 1e-3 * float(row["Fz_N"])} for row in csv.DictReader(file)],
                             "gap_m", "Fx_N", "Fz_N")
    with open(folder / "getfem.csv") as file:
        theirs, their_up = at_depths(list(csv.DictReader(file)), "travel_mm", "force_kN", "lift_kN")
    say(f"rim-push, mesh {MESH}, friction {FRICTION:g} of the walls: rimpact against GetFEM, tractions quadratic on the slider's side\n"
        f"{'depth_mm':>8} {'GetFEM_kN':>9} {'ours_kN':>8} diff_% {'up, GetFEM':>10} {'ours':>6}")
    for depth, a, b, c, d in zip(DEPTHS, theirs, ours, their_up, up):
        say(f"{depth:8.2f} {a:9.1f} {b:8.1f} {100 * (b / a - 1):+6.2f} {c:10.2f} {d:6.2f}")
    say((folder / "getfem.log").read_text().strip())
    judged = DEPTHS > FROM
    off = [(ours / theirs - 1)[judged], ((up - their_up) / theirs)[judged]]
    return 1 if missed([(name, float(values[np.argmax(np.abs(values))])) for name, values in zip(GATES, off)], GATES.__getitem__) else 0


if __name__ == "__main__":
    sys.exit(main())
