"""A driver for quoFEM, Dakota and their like: reads "name value" lines, writes one number a line.

    python3 driver.py params.in results.out

Names are keys of a scene, e.g. excitation.scale 1.05; the results are peak impact force [N] and peak displacement [m]."""
import sys

import rimpact

with open(sys.argv[1], encoding="utf-8") as file:
    words = [line.split() for line in file if len(line.split()) == 2]
summary = rimpact.summarise(rimpact.Scene("ricker-0.78g-1.0s", {name: float(value) for name, value in words}))
with open(sys.argv[2], "w", encoding="utf-8") as file:
    file.write(f"{summary['peak_impact_force_N'] or 0:.6e}\n{summary['peak_displacement_m']:.6e}\n")
