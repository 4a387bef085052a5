#!/usr/bin/env python3
"""`rim-push` against GetFEM on the same mesh, steel and supports: another program's contact, assembly and solver.

Gates on mesh 1: force within 2 % from 0.5 mm on, and within 0.5 % in the mean; unloading stiffness within 3 %, the secant between 90 %
and 50 % of the force at the deepest point. With --speed ours, CalculiX and GetFEM are timed: error of the deepest force, against ours
extrapolated, over processor time. --keep: a GetFEM run that ended in the folder is not made again (mesh 1 takes minutes).
Exit codes: 0 gates met, 1 missed, 77 GetFEM (Debian's python3-getfem) is absent (CTest: skipped)."""
import argparse
import csv
import itertools
import math
import pathlib
import subprocess
import sys
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "rim_calculix"))
from compare_rim_push import SKIPPED, Run, arguments, missed, reporter, run_ccx, run_ours, table, timed  # noqa: E402
from getfem_here import is_ready  # noqa: E402

sys.path.insert(0, str(HERE.parents[2] / "verification"))
from extrapolation import extrapolated  # noqa: E402

GATES = {"largest difference of force": 0.02, "mean difference of force": 0.005, "difference of unloading stiffness": 0.03}
WANTED = 0.01  # of the speed table


def run_getfem(options, mesh: int, *settings: str) -> Run:
    """On our mesh, with the steel, dish and travel of the scene.toml that our run of this mesh wrote."""
    name = "-".join(["getfem-mesh", str(mesh), *(word.strip("-") for word in settings)])
    msh, out, log = (options.folder / f"{name}.{suffix}" for suffix in ("msh", "csv", "log"))
    if not (options.keep and log.is_file() and "unknowns" in log.read_text()):
        subprocess.run([options.rimpact, "mesh", "--scene", "rim-push", "--curved", "-o", str(msh), "--quiet", "--set", f"model.mesh={mesh}"], check=True)
        timed([sys.executable, str(HERE / "push_getfem.py"), str(msh), str(options.folder / f"ours-mesh-{mesh}/scene.toml"), str(out), *settings], options.folder, log, options.cores)
    rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(out.read_text().splitlines())]
    return Run("getfem", *([row[key] for row in rows] for key in ("travel_mm", "force_kN", "lift_kN")), rows[-1]["processor_s"], log.read_text().strip())


def differences(ours: Run, other: Run) -> list[tuple[str, float]]:
    """Ours over theirs, less one."""
    of = ours.loading() / other.loading() - 1
    return list(zip(GATES, (float(of[np.argmax(np.abs(of))]), float(np.mean(of)), ours.unloading_stiffness() / other.unloading_stiffness() - 1)))


def time_to(runs: Sequence[tuple[float, float]], wanted: float) -> tuple[float, bool]:
    """Of (error, seconds) by mesh: where the wanted error lies on a straight line of logarithms [s], between the first two meshes that are
    about it, else through the last two; whether it is between."""
    about = [pair for pair in itertools.pairwise(runs) if pair[1][0] <= wanted <= pair[0][0]]
    (e0, t0), (e1, t1) = about[0] if about else runs[-2:]
    seconds = math.exp(math.log(t0) + (math.log(wanted) - math.log(e0)) / (math.log(e1) - math.log(e0)) * (math.log(t1) - math.log(t0)))
    return seconds, bool(about)


class Timed(NamedTuple):
    """One run of the speed table."""
    force: float  #: [kN]
    seconds: float
    note: str


def speed(say, what: str, sides: dict[str, list[Timed]]) -> None:
    """A line a run, by mesh; then the seconds in which each program has the wanted error of ours extrapolated."""
    end = extrapolated([run.force for run in sides["ours"]])
    say(f"\n{what}, against {end:.1f} kN, ours extrapolated from its three meshes; processor seconds, one core each:")
    for name, runs in sides.items():
        for mesh, run in enumerate(runs):
            say(f"{name:<8} mesh {mesh}  {run.force:8.1f} kN {100 * (run.force / end - 1):+6.2f} %  {run.seconds:7.1f} s  {run.note}")
    for name, runs in sides.items():
        seconds, between = time_to([(abs(run.force / end - 1), run.seconds) for run in runs], WANTED)
        say(f"{100 * WANTED:g} % of it: {name:<8} {seconds:6.0f} s, {'between' if between else 'beyond'} its meshes")


def of_push(run: Run) -> Timed:
    return Timed(float(run.force.max()), run.seconds, f"unloading {run.unloading_stiffness():7.1f} kN/mm  {run.note}")


def asked(description: str, mesh: int) -> argparse.Namespace:
    """The command line, with the meshes of both programs; `mesh`: the one without --speed."""
    parser = arguments(description)
    parser.add_argument("--mesh", type=int, default=mesh), parser.add_argument("--speed", action="store_true"), parser.add_argument("--keep", action="store_true")
    options = parser.parse_args()
    options.ours, options.theirs = ((0, 1, 2), (0, 1)) if options.speed else ((options.mesh,), (options.mesh,))
    return options


def main() -> int:
    options = asked(__doc__, mesh=1)
    if not is_ready(options):
        return SKIPPED
    say = reporter(options.write)
    ours = {mesh: run_ours(options, f"ours-mesh-{mesh}", mesh) for mesh in options.ours}
    theirs = {mesh: run_getfem(options, mesh) for mesh in options.theirs}
    for mesh, run in theirs.items():
        say(f"rim-push, mesh {mesh}: rimpact against GetFEM, contact at Gauss points found by its ray tracing")
        say("\n".join(table(ours[mesh], run)))
        for name, value in differences(ours[mesh], run):
            say(f"{name}: {100 * value:.2f} %")
        say(f"getfem: {run.note}\n")
    if options.speed:
        ccx = [run_ccx(options, f"ccx-mesh-{mesh}", mesh) for mesh in (0, 1)]
        runs = {"ours": ours.values(), "CalculiX": ccx, "GetFEM": theirs.values()}
        speed(say, "force at the deepest point", {name: list(map(of_push, of)) for name, of in runs.items()})
    judged = options.mesh if options.mesh in theirs else max(theirs)
    return 1 if missed(differences(ours[judged], theirs[judged]), GATES.__getitem__) else 0


if __name__ == "__main__":
    sys.exit(main())
