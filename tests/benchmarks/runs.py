#!/usr/bin/env python3
"""Whole runs, each with its counts of work, its time and its error beside it.

    runs.py RIMPACT [--rows NAME,...] [--against RIMPACT_BEFORE] [--work FOLDER] [--write FILE] [--list]

Counts (Newton's iterations, GMRES's, factorisations) are the same on every machine; seconds are of processor time and this machine's.
Rows of Sylmar read the records of RIMPACT_RECORDS. With --against each row is run by both programs, one after the other: ratios of one session, errors of the first against the second.
--write keeps the table.
"""
import argparse
import functools
import json
import math
import os
import pathlib
import re
import resource
import statistics
import subprocess
import tempfile
import time
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
    "pulse-bidirectional-1.1": ["pulse-bidirectional", "--rung", "rigid-dish", "--set", "excitation.scale=1.1"],
    "sylmar-rigid-dish": ["sylmar-bidirectional", "--rung", "rigid-dish", "--set", "excitation.scale=0.9"],
    "rim-push": ["rim-push", "--rung", "rim"],
    "rim-push-mesh-2": ["rim-push", "--rung", "rim", "--mesh", "2"],
    **{f"window-rim-mesh-{mesh}": ["impact-window", "--rung", "rim", "--set", "excitation.speed_m_per_s=0.5", "--mesh", str(mesh)] for mesh in range(4)},
    "window-rigid-dish-mesh-2": [*FAST, "--rung", "rigid-dish", "--mesh", "2"],
}


@functools.cache
def one_rank(program: str) -> tuple[str, ...]:
    """The words that keep a run alone; builds before the option always do."""
    known = subprocess.run([program, "run", "--help"], capture_output=True, text=True).stdout
    return ("--ranks", "1") if "--ranks" in known else ()


def timed(command: list[str]) -> tuple[float, float]:
    """Elapsed seconds of a command and those of its processors."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    result = subprocess.run(command, capture_output=True, text=True)
    elapsed, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: {(result.stderr.strip() or str(result.returncode)).splitlines()[-1]}")
    return elapsed, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def command_of(program: str, arguments: list[str], folder: str) -> list[str]:
    """A run's, with nothing drawn and nothing said."""
    return [program, "run", *arguments, "-o", folder, "--quiet", "--no-fields", "--force"]


def run(program: str, arguments: list[str], folder: str) -> dict[str, Any]:
    """The summary of a run on one rank, with its seconds of processor time."""
    _, cpu_s = timed(command_of(program, [*arguments, *one_rank(program)], folder))
    summary: dict[str, Any] = json.loads(pathlib.Path(folder, "summary.json").read_text())
    summary["cpu_s"] = cpu_s
    return summary


def rebound(summary: dict[str, Any]) -> float:
    """Restitution of the first impact, 0 where there is none."""
    return (summary["impacts"][0]["restitution"] or 0.0) if summary["impacts"] else 0.0


def counts(summary: dict[str, Any]) -> str:
    work = summary.get("solver_work", {})
    return (f"{summary['n_steps']:6d} {summary['n_newton_iterations']:7d} {work.get('linear_iterations', 0):7d} "
            f"{work.get('factorisations', 0):6d}")


def answer(summary: dict[str, Any]) -> str:
    """Peak force [kN], rebound, imbalance."""
    force = summary.get("peak_impact_force_N") or 0.0
    return f"{1e-3 * force:9.1f} {rebound(summary):7.4f} {summary['energy']['imbalance_relative']:10.1e}"


def line(name: str, summary: dict[str, Any], other: dict[str, Any] | None = None) -> str:
    text = f"{name:32s} {summary['n_dofs']:8d} {counts(summary)} {summary['cpu_s']:8.1f} {answer(summary)}"
    if other:
        force, there = (one.get("peak_impact_force_N") or 0.0 for one in (summary, other))
        text += (f" | {counts(other)} {other['cpu_s']:8.1f} | {summary['cpu_s'] / other['cpu_s']:6.3f} {100 * (force / there - 1) if there else 0:8.3f} "
                 f"{100 * (rebound(summary) / rebound(other) - 1) if rebound(other) else 0:8.3f}")
    return text


def growth(done: dict[str, dict[str, Any]]) -> list[str]:
    """For rows of one run on several meshes: the exponent of the unknowns that an iteration's seconds follow."""
    families: dict[str, list[dict[str, Any]]] = {}
    for name, summary in done.items():
        if match := re.fullmatch(r"(.*)-mesh-\d", name):
            families.setdefault(match[1], []).append(summary)
    lines = []
    for family, runs in families.items():
        if len(runs) > 2:
            x = [math.log(one["n_dofs"]) for one in runs]
            y = [math.log(one["cpu_s"] / one["n_newton_iterations"]) for one in runs]
            lines.append(f"{family}: seconds an iteration grow as unknowns^{statistics.linear_regression(x, y).slope:.2f} over {len(runs)} meshes")
    return lines


def rows_asked(parser: argparse.ArgumentParser, known: list[str]) -> tuple[argparse.Namespace, list[str]]:
    """The options, and the names of --rows, which are known; ends the program after --list or an unknown name."""
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if options.list:
        print("\n".join(known))
        parser.exit()
    names = options.rows.split(",")
    if unknown := [name for name in names if name not in known]:
        parser.error(f"no row is called {unknown[0]}; --list names them")
    return options, names


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rows", default=",".join(list(ROWS)[:3]))
    parser.add_argument("--against")
    parser.add_argument("--work")
    parser.add_argument("--write")
    options, names = rows_asked(parser, list(ROWS))
    head = " steps  Newton   GMRES factor    cpu s"
    text = [f"{'row':32s} unknowns{head}  force kN rebound  imbalance" + (f" |{head} | ratio  force %  rebound %" if options.against else "")]
    print(text[0])
    done: dict[str, dict[str, Any]] = {}
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or temporary
        for name in names:
            done[name] = run(options.program, ROWS[name], os.path.join(work, "own", name))
            other = run(options.against, ROWS[name], os.path.join(work, "other", name)) if options.against else None
            text.append(line(name, done[name], other))
            print(text[-1], flush=True)
            if options.write:  # after every row, for a table takes hours
                pathlib.Path(options.write).write_text("\n".join([*text, *growth(done)]) + "\n", encoding="utf-8")
    print("\n".join(growth(done)))


if __name__ == "__main__":
    main()
