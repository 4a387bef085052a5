#!/usr/bin/env python3
"""Indentation by a rigid sphere through our contact and through CalculiX: error of the force against time.

Both programs get the same block, mesh, material and travel, the same cores and automatic increments. A side's error is
against its own finest mesh; its time to 1 % lies where the error, mesh by mesh, falls below 1 % for good. Processor
time stands beside wall time, for it bears a machine shared with other work. The gate is that the two finest forces
agree. Exit codes: 0 gate met, 1 missed, 77 ccx is absent (CTest: skipped)."""
import argparse
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

SKIPPED = 77
GATE = 0.02     # difference of the two finest forces
TARGET = 0.01   # error whose time is asked for
SIDES = {       # name: (element, contact, cells of the cap)
    "ours": None,
    "ccx-C3D20R": ("C3D20R", "SURFACE TO SURFACE", "8"),
    "ccx-C3D8I": ("C3D8I", "NODE TO SURFACE", "32"),
}
CELLS = {       # a direction, coarse to fine
    "elastic": {"ours": (4, 5, 6, 8), "ccx-C3D20R": (4, 5, 6, 8), "ccx-C3D8I": (6, 9, 12)},
    "steel": {"ours": (4, 5, 6, 8, 10), "ccx-C3D20R": (4, 5, 6, 8, 10), "ccx-C3D8I": (4, 6, 9)},
}


def timed(command, options, log):
    """Runs on the first cores, at most `limit` s of processor time; (exit code, wall and processor seconds)."""
    allowed = sorted(os.sched_getaffinity(0))[:options.cores]
    threads = str(options.cores)
    environment = dict(os.environ, OMP_NUM_THREADS=threads, OPENBLAS_NUM_THREADS=threads, RIMPACT_THREADS=threads)

    def confine():
        os.sched_setaffinity(0, allowed)
        resource.setrlimit(resource.RLIMIT_CPU, (options.limit, options.limit))

    start = time.perf_counter()
    with open(log, "w") as output:
        process = subprocess.Popen(command, cwd=options.folder, stdout=output, stderr=subprocess.STDOUT, env=environment,
                                   preexec_fn=confine)
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, time.perf_counter() - start, usage.ru_utime + usage.ru_stime


def run_ours(options, name, problem, cells):
    log = options.folder / f"{name}.log"
    code, wall, processor = timed([options.ours, problem, str(cells)], options, log)
    run = {"wall_s": wall, "processor_s": processor, "force_N": None}
    if code != 0:
        return run | {"status": f"stopped at {options.limit} s" if code < 0 else f"exit code {code}"}
    result = json.loads(log.read_text().splitlines()[-1])
    run |= {key: result[key] for key in ("unknowns", "steps", "cuts", "iterations")}
    if not result["finished"]:
        return run | {"status": f"failed: {result['reason']}"}
    capped = result["capped_steps"]
    return run | {"force_N": result["force_N"], "status": f"ok, augmentation capped in {capped} steps" if capped else "ok"}


def run_ccx(options, name, problem, cells, side):
    element, contact, cap = SIDES[side]
    subprocess.run([options.writer, problem, str(cells), str(options.folder / f"{name}.inp"), "--element", element,
                    "--contact", contact, "--cap-cells", cap], check=True)
    code, wall, processor = timed(["ccx", name], options, options.folder / f"{name}.log")
    log = (options.folder / f"{name}.log").read_text()
    attempts = [line.split() for line in (options.folder / f"{name}.sta").read_text().splitlines()[2:]]
    reached = max((float(words[4]) for words in attempts), default=0.0)
    unknowns = re.findall(r"number of equations\s+(\d+)", log)
    forces = re.findall(r"total force .* CAP and time\s+([-+0-9.E]+)" + 3 * r"\s+([-+0-9.E]+)",
                        (options.folder / f"{name}.dat").read_text())
    run = {"wall_s": wall, "processor_s": processor, "force_N": None, "unknowns": int(unknowns[0]) if unknowns else 0,
           "steps": len(forces), "cuts": len(attempts) - len(forces),
           "iterations": sum(int(words[3]) for words in attempts)}
    if code < 0:
        return run | {"status": f"stopped at {options.limit} s, {100 * reached:.0f} % of the depth"}
    if code != 0 or not forces or float(forces[-1][0]) < 1:
        return run | {"status": f"did not converge beyond {100 * reached:.0f} % of the depth (exit code {code})"}
    return run | {"force_N": -4 * float(forces[-1][3]), "status": "ok"}


def run_one(options, problem, side, cells):
    """A run's outcome; kept in the folder, from where --resume takes it."""
    name = f"{problem}-{side}-{cells}"
    kept = options.folder / f"{name}.json"
    if options.resume and kept.exists():
        return json.loads(kept.read_text())
    run = {"cells": cells}
    run |= run_ours(options, name, problem, cells) if side == "ours" else run_ccx(options, name, problem, cells, side)
    kept.write_text(json.dumps(run))
    return run


def add_errors(runs):
    """Error against the finest finished run; that one has none."""
    finished = [run for run in runs if run["force_N"] is not None]
    for run in finished:
        run["error"] = run["force_N"] / finished[-1]["force_N"] - 1
    return finished


def time_to_target(finished, key):
    """(seconds, whether it is only an upper bound): log-log between the meshes about the target; the finest mesh, the
    reference itself, is no candidate. None when no coarser mesh is within the target."""
    candidates = finished[:-1]
    within = len(candidates)
    while within > 0 and abs(candidates[within - 1]["error"]) <= TARGET:
        within -= 1
    if within == len(candidates):
        return None
    if within == 0:
        return candidates[0][key], True
    before, after = candidates[within - 1], candidates[within]
    e0, e1 = (math.log(max(abs(run["error"]), 1e-6)) for run in (before, after))
    share = (e0 - math.log(TARGET)) / (e0 - e1)
    return math.exp(math.log(before[key]) * (1 - share) + math.log(after[key]) * share), False


def row(side, run):
    force = f"{run['force_N']:10.1f}" if run["force_N"] is not None else f"{'-':>10}"
    error = f"{100 * run['error']:8.2f}" if "error" in run else f"{'-':>8}"
    counts = "".join(f"{run.get(key, '-'):>{width}}" for key, width in (("unknowns", 9), ("steps", 6), ("cuts", 5), ("iterations", 7)))
    return (f"{side:<11}{run['cells']:>5}{counts} {force} {error} {run['wall_s']:9.1f} {run['processor_s']:12.1f}"
            f"  {run['status']}")


def say_time(side, finished):
    texts = []
    for key, unit in (("wall_s", "s of wall time"), ("processor_s", "s of processor time")):
        found = time_to_target(finished, key)
        if found is None:
            return f"{side}: no mesh but the finest is within {100 * TARGET:.0f} %"
        texts.append(f"{'at most ' if found[1] else ''}{found[0]:.1f} {unit}")
    return f"{side}: {100 * TARGET:.0f} % of its fine-mesh force in {', '.join(texts)}"


def picture(results, file):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, len(results), figsize=(10, 4), sharey=True, squeeze=False)
    for axis, (problem, sides) in zip(axes[0], results.items()):
        for side, finished in sides.items():
            coarse = finished[:-1]
            axis.loglog([run["processor_s"] for run in coarse], [100 * abs(run["error"]) for run in coarse], "o-", label=side)
        axis.axhline(100 * TARGET, color="0.6", linewidth=1)
        axis.set(title=problem, xlabel="processor time [s]")
        axis.legend()
    axes[0, 0].set_ylabel("error of the force, own finest mesh [%]")
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--writer", required=True, help="the program write_indentation_deck")
    parser.add_argument("--ours", required=True, help="the program run_indentation")
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, help="keep the table here (the baseline)")
    parser.add_argument("--plot", type=pathlib.Path, help="draw error against time here (asks for matplotlib)")
    parser.add_argument("--problem", choices=CELLS, action="append", help="only this one")
    parser.add_argument("--cores", type=int, default=2)
    parser.add_argument("--limit", type=int, default=240, help="processor seconds a run may take")
    parser.add_argument("--resume", action="store_true", help="take the runs that the folder holds already")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        print("skipped: CalculiX (ccx) is not installed, so the indentation has nothing to be compared with")
        return SKIPPED
    options.folder = options.folder.resolve()
    options.writer, options.ours = (str(pathlib.Path(program).resolve()) for program in (options.writer, options.ours))
    options.folder.mkdir(parents=True, exist_ok=True)
    lines, results, missed = [], {}, []

    def say(line):
        print(line, flush=True)
        lines.append(line)

    say(f"indentation by a rigid sphere, {options.cores} cores; error: against the side's own finest mesh")
    for problem in options.problem or CELLS:
        sides = CELLS[problem]
        say(f"\n{problem}\n{'side':<11}{'cells':>5}{'unknowns':>9}{'steps':>6}{'cuts':>5}{'newton':>7} {'force_N':>10} "
            f"{'error_%':>8} {'wall_s':>9} {'processor_s':>12}  status")
        results[problem] = {}
        for side, levels in sides.items():
            runs = [run_one(options, problem, side, cells) for cells in levels]
            results[problem][side] = add_errors(runs)
            for run in runs:
                say(row(side, run))
        for side, finished in results[problem].items():
            say(say_time(side, finished))
        finest = {side: finished[-1]["force_N"] for side, finished in results[problem].items() if finished}
        if not {"ours", "ccx-C3D20R"} <= finest.keys():
            missed.append(f"{problem}: a side finished no mesh, see {options.folder}")
            continue
        difference = finest["ours"] / finest["ccx-C3D20R"] - 1
        say(f"finest forces, ours against ccx-C3D20R: {100 * difference:.2f} %")
        if abs(difference) > GATE:
            missed.append(f"{problem}: finest forces differ by {100 * difference:.2f} %, the gate is {100 * GATE:.0f} %")
    if options.write:
        options.write.write_text("\n".join(lines) + "\n")
    if options.plot:
        picture(results, options.plot)
    for sentence in missed:
        print("gate missed: " + sentence, file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
