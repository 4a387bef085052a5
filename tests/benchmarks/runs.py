#!/usr/bin/env python3
"""Whole runs, each with its counts of work, its time and its error beside it.

    runs.py RIMPACT [--rows NAME,...] [--against RIMPACT_BEFORE] [--work FOLDER] [--list]

Counts (Newton's iterations, GMRES's, factorisations) are the same on every machine; seconds are of processor time and this machine's.
With --against each row is run by both programs, one after the other: ratios of one session, errors of the first against the second.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import tempfile
from typing import Any

PULSE = ["ricker-0.78g-1.0s", "--set", "excitation.scale=1.05"]
WINDOW = ["impact-window", "--set", 'excitation.with=["weight","friction"]', "--set"]
FAST, SLOWER = ([*WINDOW, f"excitation.speed_m_per_s={speed}"] for speed in (0.5, 0.4))
# name: (arguments of `rimpact run`, with what the row shares its folder)
ROWS = {
    "draft-window-rigid-dish": [*FAST, "--rung", "rigid-dish", "--mesh", "0"],
    "draft-second-window-rigid-dish": [*SLOWER, "--rung", "rigid-dish", "--mesh", "0"],
    "draft-pulse-rigid-dish": [*PULSE, "--rung", "rigid-dish", "--mesh", "0"],
    "pulse-rim": [*PULSE, "--rung", "rim"],
    "window-rigid-dish": [*FAST, "--rung", "rigid-dish"],
    "second-window-rigid-dish": [*SLOWER, "--rung", "rigid-dish"],
    "pulse-rigid-dish": [*PULSE, "--rung", "rigid-dish"],
    "pulse-full": [*PULSE, "--rung", "full"],
    "pulse-bidirectional": ["pulse-bidirectional", "--rung", "rigid-dish"],
    "rim-push": ["rim-push", "--rung", "rim"],
}


def run(program: str, arguments: list[str], folder: str) -> dict[str, Any]:
    """The summary of a run, with its seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([program, "run", *arguments, "-o", folder, "--ranks", "1", "--quiet", "--no-fields", "--force"], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(arguments)}: {result.stderr.strip().splitlines()[-1]}")
    summary: dict[str, Any] = json.loads(pathlib.Path(folder, "summary.json").read_text())
    summary["cpu_s"] = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return summary


def rebound(summary: dict[str, Any]) -> float:
    return summary["impacts"][0]["restitution"] if summary["impacts"] else 0.0


def counts(summary: dict[str, Any]) -> str:
    work = summary.get("solver_work", {})
    return (f"{summary['n_steps']:6d} {summary['n_newton_iterations']:7d} {work.get('linear_iterations', 0):7d} "
            f"{work.get('factorisations', 0):6d} {summary['cpu_s']:8.1f}")


def line(name: str, summary: dict[str, Any], other: dict[str, Any] | None = None) -> str:
    force = summary.get("peak_impact_force_N") or 0.0
    text = f"{name:32s} {counts(summary)} {1e-3 * force:9.1f} {rebound(summary):7.4f} {summary['energy']['imbalance_relative']:10.1e}"
    if other:
        there = other.get("peak_impact_force_N") or 0.0
        text += (f" | {counts(other)} | {summary['cpu_s'] / other['cpu_s']:6.3f} {100 * (force / there - 1) if there else 0:8.3f} "
                 f"{100 * (rebound(summary) / rebound(other) - 1) if rebound(other) else 0:8.3f}")
    return text


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rows", default=",".join(list(ROWS)[:3]))
    parser.add_argument("--against")
    parser.add_argument("--work")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if options.list:
        print("\n".join(ROWS))
        return
    names = options.rows.split(",")
    if unknown := [name for name in names if name not in ROWS]:
        parser.error(f"no row is called {unknown[0]}; --list names them")
    head = " steps  Newton   GMRES factor    cpu s"
    print(f"{'row':32s}{head}  force kN rebound  imbalance" + (f" |{head} | ratio  force %  rebound %" if options.against else ""))
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or temporary
        for name in names:
            own = run(options.program, ROWS[name], os.path.join(work, "own", name))
            other = run(options.against, ROWS[name], os.path.join(work, "other", name)) if options.against else None
            print(line(name, own, other), flush=True)


if __name__ == "__main__":
    main()
