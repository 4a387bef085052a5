#!/usr/bin/env python3
"""Fleets of the shipped reliability studies: time a run with its error beside it, and what the whole study would take.

    fleets.py RIMPACT --table appendix_c.csv --records FOLDER [--study thesis-2.6|thesis-4-Tb3] [--stride N] [--tight N] [--against RIMPACT]

A sample of the study's runs (one Latin hypercube point a motion, every N-th system) is run on one thread; processor time a run times the
study's runs (30 motions a level, as the table lists them) is the estimate. `error`: largest relative change of a response (of a residual
displacement: over the peak), over runs of one system in N, when the integrator's tolerance is a thousand times tighter. --against: the
same sample by another program, ratio of times and largest change of any response.
"""
import argparse
import csv
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[3]
RESPONSES = ["peak_displacement_m", "peak_lateral_force_N", "peak_impact_force_N", "ductility", "peak_drift_m", "residual_displacement_m"]
SHORT = {"thesis-2.6": [("[2.25, 0.7875, 0.675, 0.5625]", "[2.25, 0.5625]"), ("[1.0, 1.2]", "[1.0]")],
         "thesis-4-Tb3": [("[-0.10, -0.05, 0.05, 0.10]", "[-0.05]"), ("[1.0, 1.25, 1.5, 2.0]", "[1.0]")]}
RUNS = {"thesis-2.6": 64 * 4500, "thesis-4-Tb3": 576 * 4500}


def sample(study, folder, tighter=1):
    """The study with one sample a motion and fewer systems, written to a file."""
    text = (SOURCE / "data" / "reliability" / f"{study}.toml").read_text(encoding="utf-8")
    for old, new in [("samples = 15", "samples = 1"), ("replicates = 500", "replicates = 2"), *SHORT[study]]:
        if old not in text:
            raise SystemExit(f"{study}.toml has no \"{old}\" any more")
        text = text.replace(old, new)
    if tighter > 1:
        text = re.sub(r"^(reduced\.tolerance|isolator\.step_tolerance) = (\S+)",
                      lambda found: f"{found[1]} = {float(found[2]) / tighter:g}", text, flags=re.MULTILINE)
    path = pathlib.Path(folder, "study.toml")
    path.write_text(text, encoding="utf-8")
    (pathlib.Path(folder) / "thesis-4-scene.toml").write_bytes((SOURCE / "data" / "reliability" / "thesis-4-scene.toml").read_bytes())
    return path


def run(program, options, shard, tighter=1):
    """Rows of the fleets by what they are a run of, and seconds of processor time."""
    with tempfile.TemporaryDirectory() as folder:
        study = sample(options.study, folder, tighter)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([program, "reliability", study, "--table", options.table, "--records", options.records, "-o", f"{folder}/out",
                               "--threads", "1", "--no-report", "--quiet", *shard], capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            raise SystemExit(done.stderr)
        rows = {}
        for table in sorted(pathlib.Path(folder, "out", "systems").glob("*/table*.csv")):
            with open(table, encoding="utf-8") as file:
                for row in csv.DictReader(line for line in file if not line.startswith("#")):
                    rows[table.parent.name, row["run"]] = row
        return rows, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, after.ru_maxrss / 1024


def largest_change(ours, theirs):
    largest, where = 0.0, ""
    for key in ours.keys() & theirs.keys():
        for name in RESPONSES:
            a, b = ours[key].get(name) or 0, theirs[key].get(name) or 0
            scale = ours[key]["peak_displacement_m"] if name == "residual_displacement_m" else a
            change = abs(float(a) - float(b)) / max(abs(float(scale)), abs(float(b)), 1e-9)
            if change > largest:
                largest, where = change, f"{name} of {ours[key]['record']} at {ours[key]['variable.level_g']} g"
    return largest, where


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--table", required=True)
    parser.add_argument("--records", required=True)
    parser.add_argument("--study", choices=sorted(RUNS), default="thesis-2.6")
    parser.add_argument("--stride", type=int, default=1, help="every N-th system of the sample")
    parser.add_argument("--tight", type=int, default=8, help="the error is that of one system in N; 0: none")
    parser.add_argument("--against")
    options = parser.parse_args()
    shard = ["--shard", f"1/{options.stride}"] if options.stride > 1 else []
    rows, seconds, megabytes = run(options.program, options, shard)
    each = seconds / len(rows)
    print(f"{options.study}: {len(rows)} runs, {1e3 * each:.2f} ms a run and core, {1 / each:.1f} runs a second and core, {megabytes:.0f} MB")
    print(f"the whole study, {RUNS[options.study]} runs: {RUNS[options.study] * each / 3600:.2f} core hours, "
          f"{RUNS[options.study] * each / 120:.0f} min on two cores")
    if options.tight:
        few = ["--shard", f"1/{options.stride * options.tight}"]
        error, where = largest_change(run(options.program, options, few)[0], run(options.program, options, few, tighter=1000)[0])
        print(f"error: {error:.1e} ({where})")
    if options.against:
        others, other, _ = run(options.against, options, shard)
        change, where = largest_change(rows, others)
        print(f"against: {seconds / other:.3f} of its time, largest change {change:.1e} {where}")


if __name__ == "__main__":
    sys.exit(main())
