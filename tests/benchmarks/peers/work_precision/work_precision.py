"""work_precision.py BENCH [RECORDS]: processor time beside error of the reduced model, plain CVODE, SciPy and Octave.

BENCH is the program bench_work_precision. A peer that is not installed is left out with a word."""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PEERS = [
    ("SciPy Radau, Park-Wen", ["/usr/bin/python3", f"{HERE}/peer_scipy.py"], [1e-4, 1e-6, 1e-8]),
    ("Octave ode15s, Park-Wen", ["octave", "--no-gui", "--quiet", f"{HERE}/peer_octave.m"], [1e-4, 1e-6, 1e-8]),
]


def error(run, reference):
    """Largest distance over the largest displacement; instants without a reference are null."""
    off = peak = 0.0
    for x, y, rx, ry in zip(run["x"], run["y"], reference["x"], reference["y"]):
        if rx is not None:
            off, peak = max(off, math.hypot(x - rx, y - ry)), max(peak, math.hypot(rx, ry))
    return off / peak


def peer_rows(folder, name, reference):
    for program, command, tolerances in PEERS:
        if not shutil.which(command[0]):
            print(f"# {program}: {command[0]} is not installed, left out")
            continue
        run = subprocess.run(command + [f"{folder}/{name}.json"] + [repr(t) for t in tolerances], capture_output=True, text=True)
        if run.returncode != 0:
            print(f"# {program}: left out: {(run.stderr.strip() or run.stdout.strip()).splitlines()[-1][:150]}")
        for line in run.stdout.splitlines() if run.returncode == 0 else []:
            result = json.loads(line)
            yield {"program": program, "tolerance": result["tolerance"], "seconds": result["seconds"],
                   "error": error(result, reference)}


def main():
    with tempfile.TemporaryDirectory() as folder:
        print(subprocess.run([sys.argv[1], folder] + sys.argv[2:3], check=True, capture_output=True, text=True).stdout, end="")
        for name in ("pulse", "record"):
            if not os.path.exists(f"{folder}/{name}.json"):
                continue
            print(f"\n{name}: {'0.78 g pulse x 1.05, 12 s' if name == 'pulse' else 'Sylmar x 0.86, two directions, 40 s'}")
            with open(f"{folder}/{name}-rows.json") as file, open(f"{folder}/{name}-reference.json") as other:
                rows, reference = json.load(file), json.load(other)
            rows += peer_rows(folder, name, reference)
            # Times are held against ours on the same equations, at 1e-6 or better.
            ours = min(r["seconds"] for r in rows if r["program"] == "rimpact, Park-Wen" and r["error"] <= 1e-6)
            print(f"{'program':<26} {'tolerance':>9} {'ms':>10} {'error':>9} {'times ours':>11}")
            for r in rows:
                print(f"{r['program']:<26} {r['tolerance']:>9.0e} {1e3 * r['seconds']:>10.3f} {r['error']:>9.1e} {r['seconds'] / ours:>11.2f}")


main()
