"""Flies the exported bearing in OpenSeesPy under the pulse of 0.78 g and 1.0 s, and prints how it meets its rim.

usage: fly.py [FOLDER [SCALE]]   FOLDER holds impact.py, for-opensees by default
"""
import math
import runpy
import sys
from pathlib import Path

try:
    import openseespy.opensees as ops
except ImportError:
    raise SystemExit("OpenSeesPy is not installed; the numbers in the file's head are the export's own check") from None

folder, scale = (sys.argv[1:] + ["for-opensees", "1.05"][len(sys.argv) - 1:])[:2]
bearing = runpy.run_path(str(Path(folder) / "impact.py"))
plate, slider, step, period = 1, 2, 5e-4, 1.0

ops.wipe()
ops.model("basic", "-ndm", 3, "-ndf", 6)
ops.node(plate, 0.0, 0.0, 0.0), ops.node(slider, 0.0, 0.0, 0.0)
ops.fix(plate, 1, 1, 1, 1, 1, 1), ops.fix(slider, 0, 0, 0, 1, 1, 1)
ops.mass(slider, *[bearing["m1"]] * 3, 0.0, 0.0, 0.0)
bearing["rimpact_bearing"](ops, 1000, plate, slider, 100)


def solve(kind: str, *integrator: str | float) -> None:
    ops.constraints("Transformation"), ops.numberer("RCM"), ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-8, 50), ops.algorithm("Newton"), ops.integrator(*integrator), ops.analysis(kind)


ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1)
ops.load(slider, 0.0, 0.0, -bearing["dead_load"], 0.0, 0.0, 0.0)
solve("Static", "LoadControl", 0.1)
ops.analyze(10)
ops.loadConst("-time", 0.0), ops.wipeAnalysis()

steps = round(5 / step)
squares = [(math.pi * (i * step - 2 * period) / period) ** 2 for i in range(steps + 2)]
ground = [0.78 * 9.81 * float(scale) * (1 - 2 * q) * math.exp(-q) for q in squares]
ops.timeSeries("Path", 2, "-dt", step, "-values", *ground)
ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
solve("Transient", "Newmark", 0.5, 0.25)
touch = force = speed = 0.0
for _ in range(steps):
    if ops.analyze(1, step) != 0:
        raise SystemExit("OpenSees found no equilibrium; take a smaller step")
    before, speed = speed, abs(ops.nodeVel(slider, 1))
    if abs(ops.nodeDisp(slider, 1)) > bearing["lateral_capacity"]:
        touch, force = touch or before, max(force, abs(ops.basicForce(1002)[0]) / 1e3)
print(f"Pulse x {scale}: meets the rim at {touch:.3f} m/s, {force:.0f} kN" if touch else f"Pulse x {scale}: does not reach the rim")
