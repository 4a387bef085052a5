"""OpenSees' own friction pendulums and ours under the same motions, short of the rim: a table, and why they differ.

usage: their_bearings.py [--write]   with RIMPACT and PYTHONPATH (tests/app) set; --write: into their_bearings.txt"""
import csv
import math
import pathlib
import sys
import tempfile
from collections.abc import Callable, Sequence

import openseespy.opensees as ops
from command import rimpact
from flights import PLATE, SLIDER, advance, begin, solve
from opensees_rows import SAMPLE, ricker
from stored_table import differ

TABLE = pathlib.Path(__file__).with_suffix(".txt")
WEIGHT, MASS, MU, PAD = 853e3, 86952.0, 0.07, 1.14e9  # N, kg, -, N/m
SLIP = 1e-4  # elastic, of friction in both programs [m]
RADIUS = 2.25
PULSES = (("ricker-0.38g-1.5s", 0.8), ("ricker-0.78g-1.0s", 0.8))
VERTICAL = (0.3, 3.0)  # g, Hz


def materials() -> None:
    ops.uniaxialMaterial("Elastic", 1, PAD), ops.uniaxialMaterial("Elastic", 2, 1.0)


def orient() -> Sequence[float]:
    return (0.0, 0.0, 1.0, 1.0, 0.0, 0.0)


def single(slow: float, rate: float) -> None:
    materials()
    ops.frictionModel("VelDependent", 1, slow, MU, rate)
    ops.element("singleFPBearing", 1, PLATE, SLIDER, 1, RADIUS, MU * WEIGHT / SLIP, "-P", 1, "-T", 2, "-My", 2, "-Mz", 2, "-orient", *orient())


def ptv(by_speed: int, rate: float) -> None:
    """Friction by pressure and temperature off; by speed 1 - exp(-rate v) / 2."""
    materials()
    ops.element("FPBearingPTV", 1, PLATE, SLIDER, MU, 0, 50e6, 0, 0.444e-5, 18.0, by_speed, rate, RADIUS, 0.07, MU * WEIGHT / SLIP, 1, 2, 2, 2, *orient(),
                0.0, 0, 0.0, 100, 1e-8, 1)


def triple(mu: float) -> None:
    """A double concave bearing: two outer surfaces of 1.5 m effective radius; the inner one moves 0.1 mm."""
    materials()
    for tag, own in enumerate((0.999 * mu, mu, mu), 1):
        ops.frictionModel("Coulomb", tag, own)
    ops.element("TripleFrictionPendulum", 1, PLATE, SLIDER, 1, 2, 3, 1, 2, 2, 2, 0.3, 1.5, 1.5, 1e-4, 0.25, 0.25, WEIGHT, SLIP, PAD, 1.0, 1e-6)


def theirs(make: Callable[[], None], pulse: str, scale: float, vertical: bool) -> tuple[float, float, float]:
    """Largest travel, largest force, travel where it stays."""
    begin()
    ops.fix(SLIDER, 0, 0, 0, 1, 1, 1)
    ops.mass(SLIDER, MASS, MASS, MASS, 0.0, 0.0, 0.0)
    make()
    ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1), ops.load(SLIDER, 0.0, 0.0, -WEIGHT, 0.0, 0.0, 0.0)
    solve("Static", "LoadControl", 0.1, constraints="Plain", tolerance=1e-8)
    assert ops.analyze(10) == 0
    ops.loadConst("-time", 0.0), ops.wipeAnalysis()
    x, duration = ricker(pulse, scale)
    motions = [x] + ([[VERTICAL[0] * 9.81 * math.sin(2 * math.pi * VERTICAL[1] * i * SAMPLE) for i in range(len(x))]] if vertical else [])
    for direction, values in zip((1, 3), motions):
        ops.timeSeries("Path", 10 + direction, "-dt", SAMPLE, "-values", *values)
        ops.pattern("UniformExcitation", 10 + direction, direction, "-accel", 10 + direction)
    solve("Transient", "Newmark", 0.5, 0.25, constraints="Plain", tolerance=1e-8)
    travel = force = 0.0
    for i in range(round(duration / SAMPLE)):
        advance(SAMPLE)
        travel = max(travel, abs(ops.nodeDisp(SLIDER, 1)))
        force = max(force, MASS * abs(ops.nodeAccel(SLIDER, 1) + x[i + 1]))
    return travel, force, ops.nodeDisp(SLIDER, 1)


def ours(settings: Sequence[str], pulse: str, scale: float, vertical: bool) -> tuple[float, float, float]:
    with tempfile.TemporaryDirectory() as folder:
        x, duration = ricker(pulse, scale)
        for name, values in (("x", x), ("z", [VERTICAL[0] * 9.81 * math.sin(2 * math.pi * VERTICAL[1] * i * SAMPLE) for i in range(len(x))])):
            rows = "".join(f"{i * SAMPLE:.4f},{value / 9.81:.9g}\n" for i, value in enumerate(values))
            pathlib.Path(folder, f"{name}.csv").write_text("time_s,acceleration_g\n" + rows)
        record = ['excitation.kind="record"', f'excitation.x="{folder}/x.csv"', *([f'excitation.z="{folder}/z.csv"'] if vertical else []), "excitation.scale=1",
                  f"excitation.duration_s={duration}"]
        run = rimpact("reduced", pulse, "-o", f"{folder}/run", "--quiet", *(word for setting in (*record, *settings) for word in ("--set", setting)))
        assert run.returncode == 0, run.stderr
        with open(f"{folder}/run/response.csv") as file:
            rows_of = [(float(row["ux_m"]), float(row["Fx_N"])) for row in csv.DictReader(file)]
    return max(abs(u) for u, _ in rows_of), max(abs(f) for _, f in rows_of), rows_of[-1][0]


SPHERE = ("bearing.name=fps-225", "reduced.k_i_kN_per_m=0", 'reduced.friction="park-wen"', f"reduced.elastic_slip_mm={1e3 * SLIP / 2.5}")
FLAT = ('reduced.normal_force="static"',)
BY_SPEED = (f"reduced.mu_slow={MU / 2}", "reduced.rate_s_per_m=20")
DOUBLE = ('reduced.model="dcfp"', "isolator.capacity_m=0.45", "reduced.k_i_kN_per_m=0", f"reduced.mu_fast={MU}", f"reduced.mu_slow={MU}")
OF_DOUBLE = MU * 2 * 1.55 / 3.0  # friction of a rigid slider's faces about their centres, over the effective radius
PAIRS: tuple[tuple[str, Callable[[], None], str, Sequence[str]], ...] = (
    ("singleFPBearing", lambda: single(MU, 1), "fps-225", SPHERE),
    ("singleFPBearing", lambda: single(MU, 1), "fps-225, static", (*SPHERE, *FLAT)),
    ("singleFPBearing, by speed", lambda: single(MU / 2, 20), "fps-225, by speed", (*SPHERE, *BY_SPEED)),
    ("FPBearingPTV", lambda: ptv(0, 20), "fps-225", SPHERE),
    ("FPBearingPTV, by speed", lambda: ptv(1, 20), "fps-225, by speed", (*SPHERE, *BY_SPEED)),
    ("TripleFrictionPendulum", lambda: triple(MU), "dcfp", DOUBLE),
    ("TripleFrictionPendulum, mu_e", lambda: triple(OF_DOUBLE), "dcfp", DOUBLE))


def table() -> list[str]:
    lines = [f"{'theirs':<30} {'ours':<20} {'pulse':<20} load   travel_mm  ours  diff_%   force_kN   ours  diff_%   stays_mm   ours"]
    for name, make, own, settings in PAIRS:
        for pulse, scale in PULSES:
            for vertical in (False, True):
                (u, f, r), (u0, f0, r0) = theirs(make, pulse, scale, vertical), ours(settings, pulse, scale, vertical)
                lines.append(f"{name:<30} {own:<20} {pulse:<20} {'varies' if vertical else 'W':<6} {1e3 * u:9.1f} {1e3 * u0:5.1f} {100 * (u / u0 - 1):+7.2f}"
                             f"  {f / 1e3:9.1f} {f0 / 1e3:6.1f} {100 * (f / f0 - 1):+7.2f}  {1e3 * r:9.1f} {1e3 * r0:6.1f}")
    return lines


def main(*options: str) -> int:
    lines = table()
    print("\n".join(lines))
    if "--write" in options:
        TABLE.write_text("\n".join(lines) + "\n")
        return 0
    stored = TABLE.read_text().splitlines()
    moved = [f"  stored: {old}\n  now:    {new}" for old, new in zip(stored, lines) if differ(new, old, 0.01, 0.5)]
    print("\n".join(moved))
    return 1 if moved or len(stored) != len(lines) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
