"""Impacts and motions in OpenSees on what an export makes: one mass on its springs, and its whole bearing."""
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import openseespy.opensees as ops
from exported_there import Export

PLATE, SLIDER, TAG, ANCHOR = 1, 2, 1000, 100


@dataclass
class Hit:
    """One press of the rim: N, m, s, J."""
    approach: float
    peak: float = 0.0
    depth: float = 0.0
    rebound: float = 0.0  # speed
    taken: float = 0.0    # work on the rim, less what came back

    @property
    def ratio(self) -> float:
        return self.rebound / self.approach


@dataclass
class Flight:
    hits: list[Hit] = field(default_factory=list)
    furthest: float = 0.0
    at_end: float = 0.0   # distance from the middle [m]
    rise_off: float = 0.0  # at the furthest, rise less the ellipsoid's

    @property
    def peak(self) -> float:
        return max((hit.peak for hit in self.hits), default=0.0)


def begin() -> None:
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(PLATE, 0.0, 0.0, 0.0), ops.node(SLIDER, 0.0, 0.0, 0.0)
    ops.fix(PLATE, 1, 1, 1, 1, 1, 1)


def solve(kind: str, *integrator: Any, constraints: str = "Transformation", tolerance: float = 1e-9) -> None:
    ops.constraints(constraints), ops.numberer("RCM"), ops.system("UmfPack")
    ops.test("NormDispIncr", tolerance, 50), ops.algorithm("Newton")
    ops.integrator(*integrator), ops.analysis(kind)


def advance(step: float, halvings: int = 6) -> None:
    """A step, in halves where Newton's method does not get through it."""
    if ops.analyze(1, step) == 0:
        return
    if halvings == 0:
        raise RuntimeError(f"OpenSees found no equilibrium at {ops.getTime():.4f} s")
    advance(step / 2, halvings - 1), advance(step / 2, halvings - 1)


def windows(file: Export, speed: float, contact_time: float, hits: int = 2, side: int = 1, turn: float = 0.0, procedure: str = "rim_springs",
            more: Sequence[int] = ()) -> list[Hit]:
    """One mass thrown at the rim alone again and again, each time on the dent of the last; `turn` [rad]: from x (rim_round)."""
    begin()
    ops.fix(SLIDER, 0, 0 if turn else 1, 1, 1, 1, 1)
    mass, capacity, step = file.number("m1"), file.number("lateral_capacity"), contact_time / 2000
    ops.mass(SLIDER, *[mass] * 6)
    if procedure == "rim_round":
        file.make("anchor_node", ANCHOR, PLATE)
    file.make(procedure, 7, 20, ANCHOR if procedure == "rim_round" else PLATE, SLIDER, *more)
    way = (side * math.cos(turn), side * math.sin(turn))
    along = lambda quantity: sum(w * quantity(SLIDER, i + 1) for i, w in enumerate(way))
    found = []

    def put(before: float, rate: float) -> None:
        for i, w in enumerate(way):
            ops.setNodeDisp(SLIDER, i + 1, w * (capacity - before), "-commit"), ops.setNodeVel(SLIDER, i + 1, w * rate, "-commit")
            ops.setNodeAccel(SLIDER, i + 1, 0.0, "-commit")
        ops.wipeAnalysis(), solve("Transient", "Newmark", 0.5, 0.25, tolerance=1e-12)  # it reads the nodes anew

    for _ in range(hits):
        put(0.01, 0.0)
        for _ in range(50):  # what lies behind a gap comes to rest
            advance(2e-3)
        put(speed * step, speed)
        hit, force, depth = Hit(speed), 0.0, 0.0
        for _ in range(6000):
            advance(step)
            d, f = along(ops.nodeDisp) - capacity, -mass * along(ops.nodeAccel)
            hit.taken += (force + f) / 2 * (max(d, 0) - max(depth, 0))
            hit.peak, hit.depth, force, depth = max(hit.peak, f), max(hit.depth, d), f, d
            if along(ops.nodeVel) < 0 and (d < 0 or f == 0):
                break
        hit.rebound = -along(ops.nodeVel)
        found.append(hit)
    return found


def place(file: Export, load: float = 1.0, rim: Sequence[str] = ()) -> None:
    """Plate, slider and bearing, at rest under `load` times the dead load."""
    begin()
    ops.fix(SLIDER, 0, 0, 0, 1, 1, 1)
    ops.mass(SLIDER, *[file.number("m1")] * 3, 0.0, 0.0, 0.0)
    file.make("rimpact_bearing", TAG, PLATE, SLIDER, ANCHOR, *rim)
    ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1)
    ops.load(SLIDER, 0.0, 0.0, -load * file.number("dead_load"), 0.0, 0.0, 0.0)
    solve("Static", "LoadControl", 0.1, tolerance=1e-8)
    if ops.analyze(10) != 0:
        raise RuntimeError("OpenSees found no equilibrium under the dead load")
    ops.loadConst("-time", 0.0), ops.wipeAnalysis()


def rim_force() -> float:
    """Of the round rim, or of the springs of both sides [N]."""
    return sum(math.hypot(*ops.eleForce(tag)[:2]) for tag in (TAG + 2, TAG + 3) if tag in ops.getEleTags())


def throw(file: Export, speed: float, contact_time: float = 0.05, before: float = 5e-5) -> Hit:
    """A window on the dish, as the kept finite-element ones: at rest `before` the rim [m], then thrown at it, with weight and friction."""
    place(file)
    mass, capacity, a, ratio = (file.number(name) for name in ("m1", "lateral_capacity", "dish_half_width", "dish_ratio"))
    start = capacity - before
    ops.timeSeries("Linear", 3), ops.pattern("Plain", 3, 3), ops.sp(SLIDER, 1, start)
    solve("Static", "LoadControl", 0.01, tolerance=1e-8)
    if ops.analyze(100) != 0:
        raise RuntimeError("OpenSees found no equilibrium on the way out")
    ops.remove("sp", SLIDER, 1, 3), ops.remove("loadPattern", 3), ops.loadConst("-time", 0.0), ops.wipeAnalysis()
    slope = ratio * start / math.sqrt(a * a - start * start)
    for node in (SLIDER, ANCHOR + 2, ANCHOR + 3, ANCHOR + 4):
        ops.setNodeVel(node, 1, speed, "-commit")
    ops.setNodeVel(SLIDER, 3, speed * slope, "-commit")
    solve("Transient", "Newmark", 0.5, 0.25, tolerance=1e-9)
    hit, force, depth, step = None, 0.0, 0.0, contact_time / 2000
    for _ in range(6000):
        before_step = ops.nodeVel(SLIDER, 1)
        advance(step)
        d, f = ops.nodeDisp(SLIDER, 1) - capacity, rim_force()
        if d > 0 and hit is None:
            hit = Hit(before_step)
        if hit is not None:
            hit.taken += (force + f) / 2 * (max(d, 0) - max(depth, 0))
            hit.peak, hit.depth = max(hit.peak, f), max(hit.depth, d)
            if hit.peak > 0 and f == 0 and ops.nodeVel(SLIDER, 1) < 0:
                hit.rebound = -ops.nodeVel(SLIDER, 1)
                return hit
        force, depth = f, d
    raise RuntimeError("the slider does not come back from its rim")


def fly(file: Export, ground: dict[int, Sequence[float]], dt: float, duration: float, step: float = 5e-4, rim: Sequence[str] = ()) -> Flight:
    """The bearing under ground accelerations [m/s^2] by direction (1 x, 2 y, 3 z), sampled at `dt`."""
    place(file, rim=rim)
    for direction, values in ground.items():
        ops.timeSeries("Path", 10 + direction, "-dt", dt, "-values", *values)
        ops.pattern("UniformExcitation", 10 + direction, direction, "-accel", 10 + direction)
    solve("Transient", "Newmark", 0.5, 0.25, tolerance=1e-8)
    capacity, down = file.number("lateral_capacity"), ops.nodeDisp(SLIDER, 3)
    a, ratio = file.number("dish_half_width"), file.number("dish_ratio")
    flight, hit, before, r_before, f_before = Flight(), None, 0.0, 0.0, 0.0
    for _ in range(round(duration / step)):
        advance(step)
        x, y = ops.nodeDisp(SLIDER, 1), ops.nodeDisp(SLIDER, 2)
        r = math.hypot(x, y)
        rate = (x * ops.nodeVel(SLIDER, 1) + y * ops.nodeVel(SLIDER, 2)) / r if r else 0.0
        force = rim_force()
        if r > flight.furthest:
            flight.furthest, flight.rise_off = r, ops.nodeDisp(SLIDER, 3) - down - ratio * (a - math.sqrt(a * a - r * r))
        if r > capacity and hit is None:
            hit = Hit(before)
            flight.hits.append(hit)
        if hit is not None:
            hit.peak, hit.depth = max(hit.peak, force), max(hit.depth, r - capacity)
            hit.taken += (force + f_before) / 2 * (r - r_before)
            hit.rebound = -rate if force > 0 or not hit.rebound else hit.rebound
            if r < capacity:
                hit = None
        before, r_before, f_before = rate, r, force
    flight.at_end = r_before
    return flight
