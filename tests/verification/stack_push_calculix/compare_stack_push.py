#!/usr/bin/env python3
"""A push of the whole bearing (rung full) against CalculiX on the same mesh: 20 mm of slide under the weight, then 4 mm into the
rim; frictionless by default (with friction CalculiX does not get past setting the pad down, docs/decisions/0017-peers-on-the-same-mesh.md).

Gates: force of the rim within 3 % of its largest, lateral force of the dish and lift within 1 %. The soft springs that keep
CalculiX's foot from tumbling carry 1 % of the lateral force; the contacts' own forces are compared, which hold none of it.
Exit codes: 0 gates met, 1 missed, 77 ccx is absent (CTest: skipped)."""
import argparse
import csv
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "benchmarks" / "peers" / "rim_calculix")]
from compare_rim_push import SKIPPED, timed  # noqa: E402
from kept_run import finish, is_kept  # noqa: E402

BEFORE, TRAVEL = 20.0, 4.0  # [mm]
SMOOTH = ["bearing.contact.steel_ertalyte=0", "bearing.contact.steel_steel=0"]
NUMBER = r"\s+([-+0-9.E]+)"


def settings(mesh):
    chosen = [f"model.mesh={mesh}", f"excitation.travel_mm={TRAVEL:g}", *SMOOTH]
    return [word for setting in chosen for word in ("--set", setting)]


def ours(options):
    """Travel past the touch [mm]; forces of rim and dish against the push, lift [kN, kN, mm]."""
    folder = options.folder / "ours"
    seconds = 0
    if not is_kept(folder / "response.csv", options.rimpact):
        seconds = timed([options.rimpact, "run", "rim-push", "--rung", "full", *settings(options.mesh),
                         "--set", "excitation.return=false", "-o", str(folder), "--quiet"], options.folder, options.folder / "ours.log", 1)
    with open(folder / "response.csv") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    table = np.array([[-1e3 * r["gap_m"], -1e-3 * r["Ix_N"], -1e-3 * (r["Fx_N"] - r["Ix_N"]), 1e3 * r["uz_m"]] for r in rows])
    return table, seconds


def ccx(options):
    deck, results = options.folder / "ccx.inp", options.folder / "ccx.dat"
    seconds = 0
    if not results.exists():
        subprocess.run([options.writer, str(deck), *settings(options.mesh)], check=True)
        seconds = timed(["ccx", "ccx"], options.folder, options.folder / "ccx.log", 1)
    text = results.read_text()
    moves = np.array(re.findall(r"for set TOP_ONE and time" + NUMBER + r"\s+\d+" + 3 * NUMBER, text), float)
    force = {}
    for name in ("PAD_FACE, master set DISH", "SLIDER_SIDE, master set RIM_WALL"):
        blocks = re.findall(rf"slave set {name} and time" + NUMBER + r"\s+total surface force[^\n]*\n" + 3 * NUMBER, text)
        force[name.split(",")[0]] = np.array(blocks, float)
    sliding = moves[:, 0] > 2
    if not sliding.any() or moves[-1, 0] < 3.999:
        results.unlink()  # or the next run would read it again
        raise SystemExit("ccx did not finish; see ccx.log and ccx.sta")
    rim, dish = (np.interp(moves[:, 0], f[:, 0], -2e-3 * f[:, 1]) for f in (force["SLIDER_SIDE"], force["PAD_FACE"]))
    return np.column_stack([moves[:, 1] - BEFORE, rim, dish, moves[:, 3]])[sliding], seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--writer", required=True, help="the program write_stack_push_deck")
    parser.add_argument("--rimpact", required=True)
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    parser.add_argument("--mesh", type=int, default=0)
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        print("skipped: CalculiX (ccx) is not installed, so the push of the whole bearing has nothing to be compared with")
        return SKIPPED
    options.folder = options.folder.resolve()
    options.folder.mkdir(parents=True, exist_ok=True)
    (mine, my_seconds), (theirs, their_seconds) = ours(options), ccx(options)
    lines = [f"push of the whole bearing, mesh {options.mesh}, no friction: rimpact against CalculiX (C3D20R), one core each",
             "travel_mm  rim_ccx rim_ours diff_%_of_peak  dish_ccx dish_ours diff_%  lift_ccx lift_ours (from -10 mm) [kN, mm]"]
    peak, failures = theirs[-1, 1], []
    at = lambda table, x, column: np.interp(x, table[:, 0], table[:, column])  # noqa: E731
    for x in (-10, -5, -1, 0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4):
        (r, d, z), (R, D, Z) = ([at(table, x, c) for c in (1, 2, 3)] for table in (theirs, mine))
        z, Z = z - at(theirs, -10, 3), Z - at(mine, -10, 3)
        lines.append(f"{x:9.2f} {r:8.1f} {R:8.1f} {100 * (R - r) / peak:14.2f} {d:9.1f} {D:9.1f} {100 * (D / d - 1):6.2f} {z:9.3f} {Z:9.3f}")
        if not abs(R - r) < 0.03 * peak:
            failures.append(f"MISSED force of the rim at {x} mm: {100 * (R - r) / peak:.2f} % of its largest")
        if x <= 0 and not abs(D / d - 1) < 0.01:
            failures.append(f"MISSED force of the dish at {x} mm: {100 * (D / d - 1):.2f} %")
        if not abs(Z - z) < 0.01 * 14:
            failures.append(f"MISSED lift at {x} mm: {Z - z:.3f} mm")
    if my_seconds and their_seconds:
        lines.append(f"seconds: CalculiX {their_seconds:.0f} from 20 mm before the rim, ours {my_seconds:.0f} from the dish's middle")
    return finish(options.folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main())
