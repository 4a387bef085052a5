#!/usr/bin/env python3
"""`rim-push` against CalculiX on the same mesh, material and boundary conditions.

Gates: force within 3 % over the loading, unloading stiffness within 3 %. The stiffness is the secant of the unloading
branch between 90 % and 50 % of the force at the deepest point. Both programs get the same cores. With --study the
neighbours of CalculiX's run (contact stiffness, element, increments) are run too and their distance reported; with --meshes
0,1,2 both programs on each of them, and ours on a finer one: error of the deepest force against time, and how long 1 % takes.
Exit codes: 0 gates met, 1 missed, 77 ccx is absent (CTest: skipped)."""
import argparse
import csv
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

import numpy as np

GATE = 0.03
TRAVELS = np.arange(0.5, 8.01, 0.5)  # mm, loading
SKIPPED = 77
NUMBER = r"\s+([-+0-9.E]+)"


class Run:
    """Travel [mm], force against the push and upward force of the rim on the slider [kN], whole bearing."""

    def __init__(self, name, travel, force, lift, seconds, note):
        self.name, self.seconds, self.note = name, seconds, note
        self.travel, self.force, self.lift = (np.asarray(v, float) for v in (travel, force, lift))
        self.deepest = int(np.argmax(self.travel))

    def loading(self, of="force"):
        part = slice(0, self.deepest + 1)
        return np.interp(TRAVELS, self.travel[part], getattr(self, of)[part])

    def unloading_stiffness(self):
        force, travel = self.force[self.deepest:], self.travel[self.deepest:]
        ends = np.array([0.5, 0.9]) * force[0]
        if force.min() > ends[0]:
            raise SystemExit(f"{self.name}: unloading ended at {force.min():.0f} kN, above half of the peak")
        past = int(np.argmax(force <= ends[0])) + 1  # np.interp wants the force ascending
        at = np.interp(ends, force[:past][::-1], travel[:past][::-1])
        return (ends[1] - ends[0]) / (at[1] - at[0])


def timed(command, folder, log, cores):
    """Runs on the first `cores` cores; returns seconds of processor time."""
    allowed = sorted(os.sched_getaffinity(0))[:cores]
    environment = dict(os.environ, OMP_NUM_THREADS=str(cores), OPENBLAS_NUM_THREADS=str(cores))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(log, "w") as output:
        done = subprocess.run(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT, env=environment,
                              preexec_fn=lambda: os.sched_setaffinity(0, allowed))
    if done.returncode != 0:
        raise SystemExit(f"{command[0]} ended with exit code {done.returncode}; see {log}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def bearing_of(options):
    return ["--set", f"bearing.name={options.bearing}"] if options.bearing else []


def in_bearing(deck, vectors):
    """Turns rows (x, y, z) of the model, and gives the factors that make forces and displacements those of what is carried
    (fe_contact/rungs/rim_frame.h)."""
    ratio, reach, turn = (float(word) for word in re.search(r"FRAME (\S+) (\S+) (\S+)", deck.read_text()).groups())
    c, s = np.cos(turn), np.sin(turn)
    return vectors @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T, reach, ratio


def run_ours(options, name, mesh):
    folder = options.folder / name
    seconds = timed([options.rimpact, "run", "rim-push", "-o", str(folder), "--mesh", str(mesh), "--quiet", *bearing_of(options)],
                    options.folder, options.folder / f"{name}.log", options.cores)
    with open(folder / "response.csv") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    summary = json.loads((folder / "summary.json").read_text())
    return Run(name, [-1e3 * row["gap_m"] for row in rows], [-1e-3 * row["Fx_N"] for row in rows],
               [1e-3 * row["Fz_N"] for row in rows], seconds,
               f"{summary['n_dofs']} unknowns, {summary['n_steps']} steps, {summary['n_newton_iterations']} iterations")


def unknowns(folder, name):
    found = re.findall(r"number of equations\s+(\d+)", (folder / f"{name}.log").read_text())
    return found[0] if found else "?"


def increments(folder, name):
    """What CalculiX's automatic control did: every attempt is a line, an increment given up has a U."""
    attempts = [line.split() for line in (folder / f"{name}.sta").read_text().splitlines()[2:]]
    cut = [words for words in attempts if words[2].endswith("U")]
    return (f"{len(attempts) - len(cut)} increments, {sum(int(words[3]) for words in attempts)} iterations, "
            f"{sum(int(words[3]) for words in cut)} of them in increments cut")


def reporter(baseline):
    """Says a line as it comes (a study takes an hour), and keeps it."""
    if baseline:
        baseline.write_text("")

    def say(line):
        print(line, flush=True)
        if baseline:
            with open(baseline, "a") as file:
                file.write(line + "\n")
    return say


def run_ccx(options, name, mesh, *settings):
    deck = options.folder / f"{name}.inp"
    subprocess.run([options.writer, str(deck), "--set", f"model.mesh={mesh}", *bearing_of(options), *settings], check=True)
    seconds = timed(["ccx", name], options.folder, options.folder / f"{name}.log", options.cores)
    text = (options.folder / f"{name}.dat").read_text()
    forces = re.findall(r"total force .* TOP and time" + NUMBER + r"\s*" + 3 * NUMBER, text)
    moves = re.findall(r"displacements .* TOP_ONE and time" + NUMBER + r"\s+\d+" + 3 * NUMBER, text)
    forces, moves = np.array(forces, float), np.array(moves, float)
    if len(forces) == 0 or forces[-1, 0] < 2 or not np.array_equal(forces[:, 0], moves[:, 0]):
        raise SystemExit(f"ccx did not finish {deck}; see {name}.log and {name}.sta")
    zero = np.zeros(1)
    pushed, reach, _ = in_bearing(deck, forces[:, 1:])
    moved, _, ratio = in_bearing(deck, moves[:, 1:])
    return Run(name, np.append(zero, ratio * moved[:, 0]), np.append(zero, 2e-3 * reach * pushed[:, 0]),
               np.append(zero, -2e-3 * reach * pushed[:, 2]), seconds, f"{unknowns(options.folder, name)} unknowns, {increments(options.folder, name)}")


def table(ours, other):
    lines = [f"{'travel_mm':>9} {f'F_{other.name}_kN':>9} {'F_ours_kN':>9} {'diff_%':>7} {f'Fz_{other.name}_kN':>9} {'Fz_ours_kN':>10}"]
    for row in zip(TRAVELS, other.loading(), ours.loading(), other.loading("lift"), ours.loading("lift")):
        travel, theirs, mine, theirs_z, mine_z = row
        lines.append(f"{travel:9.2f} {theirs:9.1f} {mine:9.1f} {100 * (mine / theirs - 1):7.2f} "
                     f"{theirs_z:9.1f} {mine_z:10.1f}")
    return lines


def gates(ours, other):
    """(name, signed relative difference)"""
    differences = ours.loading() / other.loading() - 1
    worst = int(np.argmax(np.abs(differences)))
    stiffness = ours.unloading_stiffness() / other.unloading_stiffness() - 1
    return [(f"largest difference of force, at {TRAVELS[worst]:.2f} mm", differences[worst]),
            ("difference of unloading stiffness", stiffness)]


def summary_of(run, reference):
    distance = run.loading() / reference.loading() - 1
    return (f"{run.name:<22} worst {100 * distance[np.argmax(np.abs(distance))]:6.2f} %  mean {100 * distance.mean():6.2f} %"
            f"  peak {run.force.max():7.1f} kN, upward {run.lift[run.deepest]:5.1f} kN  unloading {run.unloading_stiffness():7.1f} kN/mm"
            f"  {run.seconds:6.0f} s  {run.note}")


def study(options, ccx, say):
    variants = [("ccx-stiffness-tenth", 1, "--contact-stiffness", "1e6"), ("ccx-increments-halved", 1, "--longest", "0.03125"),
                ("ccx-full-integration", 1, "--element", "C3D20")]
    say(f"\nneighbours, against {ccx.name}:")
    for name, *settings in variants:
        say(summary_of(run_ccx(options, name, *settings), ccx))


def refinement(options, say):
    """Error of the deepest force on each mesh, against ours on one mesh finer than the finest of both, and time."""
    meshes = [int(word) for word in options.meshes.split(",")]
    ours = [run_ours(options, f"ours-mesh-{mesh}", mesh) for mesh in [*meshes, max(meshes) + 1]]
    ccx = [run_ccx(options, f"ccx-mesh-{mesh}", mesh) for mesh in meshes]
    fine = ours[-1].force.max()
    say(f"\nforce at the deepest point, against ours on mesh {max(meshes) + 1} ({fine:.1f} kN):")
    for run in [*ours, *ccx]:
        say(f"{run.name:<12} {run.force.max():8.1f} kN {100 * (run.force.max() / fine - 1):6.2f} % {run.seconds:7.1f} s  {run.note}")
    times = [min((run.seconds for run in runs if abs(run.force.max() / fine - 1) < 0.01), default=np.nan) for runs in (ours[:-1], ccx)]
    say(f"1 % of the fine-mesh force: ours {times[0]:.0f} s, ccx {times[1]:.0f} s: {times[1] / times[0]:.1f} times sooner")


def arguments(description):
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--writer", required=True, help="the program write_rim_deck")
    parser.add_argument("--rimpact", required=True, help="the program rimpact or rimpact-fe")
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, help="keep the table here (the baseline)")
    parser.add_argument("--bearing", help="a built-in bearing in place of the scene's")
    parser.add_argument("--cores", type=int, default=1)
    parser.add_argument("--meshes", help="meshes of both programs, e.g. 0,1,2")
    return parser


def is_ready(options):
    """Makes the folder; False, with a word, where there is nothing to compare with."""
    if shutil.which("ccx") is None:
        print("skipped: CalculiX (ccx) is not installed, so there is nothing to compare with")
        return False
    options.folder = options.folder.resolve()
    options.folder.mkdir(parents=True, exist_ok=True)
    return True


def missed(differences, bound):
    """Says which of (name, relative difference) is not within its bound(name); whether any is."""
    late = [f"gate missed: {name}: {100 * value:.2f} %, the gate is {100 * bound(name):.0f} %"
            for name, value in differences if not abs(value) <= bound(name)]
    for sentence in late:
        print(sentence, file=sys.stderr)
    return bool(late)


def main():
    parser = arguments(__doc__)
    parser.add_argument("--mesh", type=int, default=1)
    parser.add_argument("--study", action="store_true")
    options = parser.parse_args()
    if not is_ready(options):
        return SKIPPED
    say = reporter(options.write)

    ours, ccx = run_ours(options, "ours", options.mesh), run_ccx(options, "ccx", options.mesh)
    say(f"rim-push, mesh {options.mesh}: rimpact against CalculiX (C3D20R), {options.cores} core(s)")
    say("\n".join(table(ours, ccx)) + "\n")
    for run in (ccx, ours):
        say(f"{run.name:<4} unloading stiffness {run.unloading_stiffness():8.1f} kN/mm, {run.seconds:6.1f} s, {run.note}")
    for name, value in gates(ours, ccx):
        say(f"{name}: {100 * value:.2f} %")
    if options.study:
        study(options, ccx, say)
    if options.meshes:
        refinement(options, say)
    return 1 if missed(gates(ours, ccx), lambda name: GATE) else 0


if __name__ == "__main__":
    sys.exit(main())
