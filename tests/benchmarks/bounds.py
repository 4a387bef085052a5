#!/usr/bin/env python3
"""The least time that a run's counts leave, beside what was asked of it: bounds.py [--write FILE].

Counts of the runs are those of runs_alone.txt, what one of each costs that of work.txt. A factor's operations go at this machine's rate of
single-precision products, a solution reads the factor once forwards and once backwards, a cell's forces and tangent take 56 us (decision 24).
Rates are of one core, the best of several tries; two cores at most halve the sum. Nothing else is counted: not the contacts, GMRES's own
vectors, steps not taken; a cell whose tangent is kept costs less. So hardly a build with these counts is below the bound. Of pulse-bidirectional, a
whole model with several sectors, what one of each costs is scaled by its unknowns: an estimate.
"""
import argparse
import os
import pathlib
import time
from collections.abc import Callable

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(name, "1")
import numpy as np  # noqa: E402 (reads the number of threads when it is loaded)

HERE = pathlib.Path(__file__).resolve().parent
CELL = 56e-6  # [s]
TRIES = 7
# row of runs_alone.txt: rung and mesh whose iteration it takes, and what was asked for on two cores [s]
ASKED = {"window-rim-mesh-1": ("rim", 1, 15), "pulse-rim": ("rim", 1, 30), "pulse-rigid-dish": ("rigid-dish", 1, 120),
         "pulse-full": ("full", 1, 240), "pulse-bidirectional": ("rigid-dish", 1, 360)}
WHOLE = {"pulse-bidirectional": 71970 / 23658}  # unknowns of a whole model with several sectors over the half's


def best(work: Callable[[], object]) -> float:
    """Seconds of the quickest try."""
    def once() -> float:
        start = time.perf_counter()
        work()
        return time.perf_counter() - start
    return min(once() for _ in range(TRIES))


def rates() -> tuple[float, float]:
    """Single-precision operations a second, and bytes read a second, on one core."""
    n, reading = 1200, np.ones(60_000_000, dtype=np.float32)
    a = np.ones((n, n), dtype=np.float32)
    return 2 * n**3 / best(lambda: a @ a), reading.nbytes / best(lambda: reading.sum())


def table(file: str, key: Callable[[list[str]], object]) -> dict[object, list[str]]:
    lines = (line.split() for line in (HERE / file).read_text(encoding="utf-8").splitlines())
    return {key(words): words for words in lines if len(words) > 8}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", type=pathlib.Path)
    options = parser.parse_args()
    flops, memory = rates()
    runs, costs = table("runs_alone.txt", lambda w: w[0]), table("work.txt", lambda w: (w[0], w[1], w[2]))
    text = [f"one core: {1e-9 * flops:.0f} Gflop/s in single precision, {1e-9 * memory:.1f} GB/s read, {1e6 * CELL:.0f} us a cell",
            f"{'row':24s} Newton factor   GMRES   cells s factors s solutions s  bound s: 1 core  2 cores   asked"]
    for name, (rung, mesh, asked) in ASKED.items():
        _, _, newton, gmres, factors = (float(word) for word in runs[name][1:6])
        cost = costs[rung, str(mesh), "1"]
        cells, entries, gflop = float(cost[4]), 1e6 * float(cost[7]), float(cost[9])
        reads = 2 if rung == "rim" else 1  # a symmetric factor is kept once, and read forwards and backwards
        wider = WHOLE.get(name, 1.0)  # of cells; operations and entries grow by the powers of work.txt
        times = (newton * cells * wider * CELL, factors * 1e9 * gflop * wider**1.96 / flops, gmres * 4 * reads * entries * wider**1.39 / memory)
        text.append(f"{name:24s} {newton:6.0f} {factors:6.0f} {gmres:7.0f} {times[0]:9.1f} {times[1]:9.1f} {times[2]:11.1f} {sum(times):16.1f} "
                    f"{sum(times) / 2:8.1f} {asked:7d}")
    print("\n".join(text))
    if options.write:
        options.write.write_text("\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
