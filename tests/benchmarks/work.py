#!/usr/bin/env python3
"""What one Newton iteration costs by mesh and by ranks, counted by bench_work, with the growth fitted.

    work.py BENCH_WORK [--meshes 0,1,2,3] [--ranks 1,2,3,4] [--shared-meshes 0,1,2] [--write FILE]

Counts are the same on every machine; the seconds beside them are this one's, and mean nothing where ranks share a core.
Meshes of --meshes are counted on one rank, those of --shared-meshes on each number of --ranks.
"""
import argparse
import math
import os
import pathlib
import shutil
import statistics
import subprocess

ENVIRONMENT = {"RIMPACT_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_mpi_yield_when_idle": "1"}
GROWING = {"cells": "cells", "entries of the matrix": "matrix", "entries of the factor": "factor", "its operations": "Gflop"}


def counted(program: str, meshes: str, n: int) -> list[str]:
    """The lines of bench_work on n ranks, its head first."""
    launcher = [] if n == 1 else [str(shutil.which("mpirun")), "--oversubscribe", "-np", str(n)]
    result = subprocess.run([*launcher, program, *meshes.split(",")], capture_output=True, text=True, env={**os.environ, **ENVIRONMENT})
    if result.returncode != 0:
        raise SystemExit(f"{program} on {n} ranks: {result.stderr.strip() or result.returncode}")
    return result.stdout.splitlines()


def row(line: str) -> dict[str, float | str]:
    word = line.split()
    names = ("rung", "mesh", "ranks", "unknowns", "cells", "matrix", "busiest matrix", "factor", "busiest factor", "Gflop", "busiest Gflop")
    return {name: value if name == "rung" else float(value) for name, value in zip(names, word, strict=False)}


def exponent(rows: list[dict[str, float]], name: str) -> float:
    """Of the unknowns, fitted over meshes."""
    return statistics.linear_regression([math.log(one["unknowns"]) for one in rows], [math.log(one[name]) for one in rows]).slope


def growth(rows: list[dict[str, float]], rung: str) -> str:
    of = [one for one in rows if one["rung"] == rung and one["ranks"] == 1]
    if len(of) < 3:
        return ""
    grown = ", ".join(f"{what} ^{exponent(of, name):.2f}" for what, name in GROWING.items())
    return f"{rung}: as powers of the unknowns over {len(of)} meshes: {grown}"


def shares(rows: list[dict[str, float]], rung: str) -> list[str]:
    """How many times less than one rank the busiest of several has to do."""
    alone = {one["mesh"]: one for one in rows if one["rung"] == rung and one["ranks"] == 1}
    lines = []
    for one in rows:
        if one["rung"] == rung and one["ranks"] > 1 and one["mesh"] in alone:
            times = ", ".join(f"{what} {alone[one['mesh']][name] / one[f'busiest {name}']:.2f}" for what, name in list(GROWING.items())[1:])
            lines.append(f"{rung}, mesh {one['mesh']:.0f}, {one['ranks']:.0f} ranks: one rank's work over the busiest's: {times}")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--meshes", default="0,1")
    parser.add_argument("--shared-meshes", default="0,1")
    parser.add_argument("--ranks", default="1,2")
    parser.add_argument("--write")
    options = parser.parse_args()
    text: list[str] = []
    for n in map(int, options.ranks.split(",")):
        lines = counted(options.program, options.meshes if n == 1 else options.shared_meshes, n)
        text += lines if not text else lines[1:]
        print("\n".join(lines if n == 1 else lines[1:]), flush=True)
    rows = [row(line) for line in text[1:]]
    rungs = list(dict.fromkeys(str(one["rung"]) for one in rows))
    text += ["", *filter(None, (growth(rows, rung) for rung in rungs)), "", *(line for rung in rungs for line in shares(rows, rung))]
    print("\n".join(text[len(rows) + 1:]))
    if options.write:
        pathlib.Path(options.write).write_text("\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
