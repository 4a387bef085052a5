#!/usr/bin/env python3
"""What a user waits for: commands as they are typed, alone on the machine, elapsed beside processor time.

    waits.py RIMPACT [--rows NAME,...] [--work FOLDER] [--write FILE] [--list]

The main job, its fits and its report, then rows of runs.py with the ranks that the program chooses. Counts are the same on every machine, seconds are this one's.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import tempfile
import time
from typing import Any

import runs

HEAD = f"{'row':32s} elapsed s    cpu s  steps  Newton   GMRES factor  force kN rebound  imbalance"


def timed(command: list[str]) -> tuple[float, float]:
    """Elapsed seconds of a command and those of its processors."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    result = subprocess.run(command, capture_output=True, text=True)
    elapsed, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: {(result.stderr.strip() or str(result.returncode)).splitlines()[-1]}")
    return elapsed, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def figures(summary: dict[str, Any]) -> str:
    """Counts and answer of a run."""
    work = summary["solver_work"]
    return (f" {summary['n_steps']:6d} {summary['n_newton_iterations']:7d} {work['linear_iterations']:7d} {work['factorisations']:6d} "
            f"{1e-3 * (summary['peak_impact_force_N'] or 0.0):9.1f} {runs.rebound(summary):7.4f} {summary['energy']['imbalance_relative']:10.1e}")


def commands(program: str, work: pathlib.Path) -> dict[str, list[str]]:
    """The commands by name; fits and report read what the main job left."""
    jobs = {"main": [program, "main", "--force", "-o", str(work / "main")],
            "calibrate": [program, "calibrate", *map(str, sorted((work / "main" / "runs").glob("window-*"))), "-o", str(work / "calibration")],
            "report": [program, "report", str(work / "main")]}
    for name, arguments in runs.ROWS.items():
        jobs[name] = [program, "run", *arguments, "--quiet", "--no-fields", "--force", "-o", str(work / name)]
    return jobs


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rows", default="main,calibrate,report,window-rim-mesh-1")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or pathlib.Path(temporary)
        jobs = commands(options.program, work)
        if options.list:
            print("\n".join(jobs))
            return
        names = options.rows.split(",")
        if unknown := [name for name in names if name not in jobs]:
            parser.error(f"no row is called {unknown[0]}; --list names them")
        text = [HEAD]
        print(HEAD, flush=True)
        for name in names:
            elapsed, cpu = timed(commands(options.program, work)[name])  # now, when the main job's runs are there
            summary = work / name / "summary.json"
            text.append(f"{name:32s} {elapsed:9.1f} {cpu:8.1f}{figures(json.loads(summary.read_text())) if name in runs.ROWS else ''}")
            print(text[-1], flush=True)
            if options.write:
                options.write.write_text("\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
