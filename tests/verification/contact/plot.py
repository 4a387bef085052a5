#!/usr/bin/env python3
"""Error over cell size of the stored contact baselines, and the loop of rung rigid-dish over the closed form, as the
pictures of docs/verification.md: plot.py OUTPUT_FOLDER [FE_RUN CLOSED_RUN]."""
import csv
import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

BASELINES = pathlib.Path(__file__).parent / "baselines"
SHOWN = {"hertz-cylinder": ["half-width b [mm]", "peak pressure [MPa]"], "hertz-sphere": ["peak pressure [Pa]"],
         "mindlin-cylinder": ["stick ratio, by traction"], "thick-cylinder": ["first yield [MPa]"],
         "mindlin-sphere": ["stick ratio, by traction"],
         "hertz-two-bodies": ["plane: half-width b [mm]", "cylinder: peak pressure [MPa]"],
         "cook-membrane": ["Q1 tip, plane strain [mm]", "Q2 tip, plane strain [mm]"], "ironing": ["ripple / mean"]}


def rows(name):
    for line in (BASELINES / f"{name}.txt").read_text().splitlines():
        found = re.match(r"(.{34,}?)\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s+(\d+)\s+(\d+)\s+(\S+)$", line)
        if found and not line.startswith(("#", "gate")):
            yield found.group(1).strip(), float(found.group(2)), abs(float(found.group(5)))


def errors(output):
    figure, axis = plt.subplots(figsize=(9, 4.5))
    for name, quantities in SHOWN.items():
        table = list(rows(name))
        for quantity in quantities:
            points = [(size, error) for q, size, error in table if q == quantity]
            if points:
                coarsest = max(size for size, _ in points)
                axis.loglog([size / coarsest for size, _ in points], [error for _, error in points], "o-",
                            label=f"{name}: {quantity}")
    axis.set_xlabel("cell size over the coarsest mesh's")
    axis.set_ylabel("relative error")
    axis.grid(True, which="both", alpha=0.3)
    axis.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.tight_layout()
    figure.savefig(output / "contact_errors.svg")


def loop(output, fe, closed):
    figure, axis = plt.subplots(figsize=(7, 4.5))
    for folder, style, label in ((closed, "-", "closed form, finite pad and socket friction"), (fe, ".", "rung rigid-dish, mesh 1")):
        with open(pathlib.Path(folder) / "response.csv") as file:
            table = [(float(r["ux_m"]), -float(r["Fx_N"])) for r in csv.DictReader(file)]
        axis.plot([u for u, _ in table], [f / 1e3 for _, f in table], style, label=label, ms=4)
    axis.set_xlabel("displacement [m]")
    axis.set_ylabel("- lateral force [kN]")
    axis.grid(True, alpha=0.3)
    axis.legend()
    figure.tight_layout()
    figure.savefig(output / "static_loop.svg")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    errors(folder)
    if len(sys.argv) > 3:
        loop(folder, sys.argv[2], sys.argv[3])
