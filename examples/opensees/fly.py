"""Flies what `rimpact export --opensees` wrote in OpenSeesPy, and holds it against the self-check in the file's head.

One mass is thrown at the rim's springs at each speed of the self-check; the whole bearing goes through its pulses.
usage: fly.py [FOLDER]   FOLDER holds impact.py, for-opensees by default. Exit code 1: something is off by more than 5 %.
"""
import math
import re
import runpy
import sys
from pathlib import Path

try:
    import openseespy.opensees as ops
except ImportError:
    raise SystemExit("OpenSeesPy is not installed; the numbers in the file's head are the export's own check") from None

FILE = Path(sys.argv[1] if len(sys.argv) > 1 else "for-opensees") / "impact.py"
BEARING = runpy.run_path(str(FILE))
HEAD = "".join(line.lstrip("#").rstrip() + " " for line in FILE.read_text().splitlines() if line.startswith("#"))
PLATE, SLIDER, ANCHOR = 1, 2, 100
RIM = (1002, 1003)  # elements of the whole bearing's rim: one that is round, or both sides
SPRINGS = re.compile(r" ([\d.e-]+) m/s: peak ([\d.]+) kN \(law ([\d.]+)\), penetration ([\d.]+) mm .*?, rebound ([\d.]+)")
PULSES = re.compile(r"ricker-([\d.]+)g-([\d.]+)s x ([\d.]+): ([\d.]+) m/s, (\d+) kN \(model ([\d.]+) m/s, (\d+) kN\)\.")


def begin(*fixed: int) -> None:
    ops.wipe(), ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(PLATE, 0.0, 0.0, 0.0), ops.node(SLIDER, 0.0, 0.0, 0.0)
    ops.fix(PLATE, 1, 1, 1, 1, 1, 1), ops.fix(SLIDER, *fixed)
    ops.mass(SLIDER, *[BEARING["m1"]] * 3, 0.0, 0.0, 0.0)


def solve(kind: str, *integrator: str | float) -> None:
    ops.constraints("Transformation"), ops.numberer("RCM"), ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-9, 50), ops.algorithm("Newton"), ops.integrator(*integrator), ops.analysis(kind)


def window(speed: float) -> tuple[float, float]:
    """Peak force [kN] and rebound over the approach of one mass on the springs along x."""
    begin(0, 1, 1, 1, 1, 1)
    BEARING["rim_springs"](ops, 7, 20, PLATE, SLIDER, *([50] if "joint" in BEARING["rim_springs"].__code__.co_varnames else []))
    step, capacity = 1e-5, BEARING["lateral_capacity"]
    ops.setNodeDisp(SLIDER, 1, capacity - speed * step, "-commit"), ops.setNodeVel(SLIDER, 1, speed, "-commit")
    solve("Transient", "Newmark", 0.5, 0.25)
    force = 0.0
    while ops.getTime() < 0.2 and (ops.getTime() < 3 * step or ops.nodeAccel(SLIDER, 1) != 0):
        ops.analyze(1, step)
        force = max(force, -BEARING["m1"] * ops.nodeAccel(SLIDER, 1))
    return force / 1e3, -ops.nodeVel(SLIDER, 1) / speed


def pulse(g: float, period: float, scale: float) -> tuple[float, float]:
    """Speed of the first touch [m/s] and largest rim force [kN] of the whole bearing under a Ricker pulse; zero: no touch."""
    begin(0, 0, 0, 1, 1, 1)
    BEARING["rimpact_bearing"](ops, 1000, PLATE, SLIDER, ANCHOR)
    ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1)
    ops.load(SLIDER, 0.0, 0.0, -BEARING["dead_load"], 0.0, 0.0, 0.0)
    solve("Static", "LoadControl", 0.1)
    ops.analyze(10), ops.loadConst("-time", 0.0), ops.wipeAnalysis()
    step, duration = 5e-4, 2 * period + 3
    squares = [(math.pi * (i * step - 2 * period) / period) ** 2 for i in range(round(duration / step) + 2)]
    ops.timeSeries("Path", 2, "-dt", step, "-values", *[g * 9.81 * scale * (1 - 2 * q) * math.exp(-q) for q in squares])
    ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
    solve("Transient", "Newmark", 0.5, 0.25)
    touch = force = speed = 0.0
    for _ in range(round(duration / step)):
        if ops.analyze(1, step) != 0:
            raise SystemExit("OpenSees found no equilibrium; take a smaller step")
        before, speed = speed, abs(ops.nodeVel(SLIDER, 1))
        if abs(ops.nodeDisp(SLIDER, 1)) > BEARING["lateral_capacity"]:
            touch, force = touch or before, max(force, sum(math.hypot(*ops.eleForce(tag)[:2]) for tag in RIM if tag in ops.getEleTags()) / 1e3)
    return touch, force


worst = 0.0
for speed, own, law, _, back in [tuple(map(float, found)) for found in SPRINGS.findall(HEAD)]:
    peak, rebound = window(speed)
    worst = max(worst, abs(peak / own - 1))
    print(f"springs at {speed:.3g} m/s: {peak:.0f} kN, rebound {rebound:.3f} (self-check {own:.0f} and {back:.3f}, law {law:.0f} kN)")
for g, period, scale, touch, own, model_touch, model in [tuple(map(float, found)) for found in PULSES.findall(HEAD)] if "rimpact_bearing" in BEARING else []:
    if model_touch > 0.3:  # a slower touch moves with anything
        there, force = pulse(g, period, scale)
        worst = max(worst, abs(there / touch - 1), abs(force / own - 1))
        print(f"pulse {g:g} g, {period:g} s x {scale:g}: {there:.3f} m/s, {force:.0f} kN (self-check {touch:.3f} and {own:.0f}, model {model_touch:.3f} and {model:.0f})")
print(f"Largest difference from the self-check: {100 * worst:.1f} %")
sys.exit(worst > 0.05)
