"""A triple pendulum before any rim, against OpenSees' TripleFrictionPendulum: three made motions, and three recorded ones where they are at hand.

The element is Fenz and Constantinou's for small turns, with friction as loops give it. It has no rise, so that its normal force is the dead load, no mass
of the sliders, and an elastic displacement uy before each slip. With sliders of a hundredth of their masses, and uy = 0.03 mm, histories differ by up to
0.7 % of the largest displacement (uy = 0.1 mm: 1.1 %; its steps halved: below 0.02 %). With the catalogue's masses: 3.4 % (Sylmar), largest ones 1.4 % (El Centro). A
slide plate that begins to turn swings about where it would ride, and takes the inner face beside it off the limit of its friction, at which the element has
it always. Slow loops, light sliders and friction by body instead of by face are without that. Rims are beyond reach."""
import csv
import json
import math
import os
import pathlib
import tempfile
import unittest

import openseespy.opensees as ops
from command import rimpact

WEIGHT, G = 13345.0e3, 9.81  # tfp-kim-2023
LENGTHS, LIMITS, FRICTION = (0.3937, 3.7465, 3.7465), (0.0716, 0.5043, 0.5043), (0.01, 0.04, 0.08)  # inner, bottom, top
SLIDERS = {"slider_mass_kg": 320.0, "inner.mass_kg": 350.0}  # of the catalogue
RECORDS = pathlib.Path(os.environ.get("RIMPACT_RECORDS") or pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "records")


def ricker(amplitude: float, period: float, step: float = 5e-3, end: float = 12.0) -> tuple[float, list[float]]:
    squares = ((math.pi * (i * step - 2 * period) / period) ** 2 for i in range(round(end / step) + 1))
    return step, [amplitude * G * (1 - 2 * q) * math.exp(-q) for q in squares]


def swelling(amplitude: float, period: float, step: float = 5e-3, end: float = 12.0) -> tuple[float, list[float]]:
    return step, [amplitude * G * math.sin(2 * math.pi * i * step / period) * math.sin(math.pi * min(i * step, 8.0) / 8.0)
                  for i in range(round(end / step) + 1)]


def chirp(amplitude: float, step: float = 5e-3, end: float = 12.0) -> tuple[float, list[float]]:
    """From 0.25 to 2 Hz in eight seconds."""
    return step, [amplitude * G * math.sin(2 * math.pi * (0.25 * t + 1.75 * t * t / 16)) if (t := i * step) < 8.0 else 0.0
                  for i in range(round(end / step) + 1)]


def recorded(name: str, scale: float, end: float = 25.0) -> tuple[float, list[float]]:
    lines = (RECORDS / name).read_text().splitlines()
    words = lines[3].replace(",", " ").replace("=", " ").split()
    step = float(words[words.index("DT") + 1])
    values = [scale * G * float(word) for line in lines[4:] for word in line.split()]
    return step, values[:round(end / step) + 1]


def opensees(step: float, ground: list[float], per_step: int) -> list[float]:
    """Displacement [m] at every instant of the motion."""
    mass = WEIGHT / G
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0), ops.node(2, 0.0, 0.0, 0.0)
    ops.fix(1, 1, 1, 1, 1, 1, 1), ops.fix(2, 0, 1, 0, 1, 1, 1)
    ops.mass(2, mass, mass, mass, 1.0, 1.0, 1.0)
    for tag, mu in enumerate(FRICTION, 1):
        ops.frictionModel("Coulomb", tag, mu)
    ops.uniaxialMaterial("Elastic", 1, 8e9), ops.uniaxialMaterial("Elastic", 2, 10.0)
    ops.element("TripleFrictionPendulum", 1, 1, 2, 1, 2, 3, 1, 2, 2, 2, *LENGTHS, *LIMITS, WEIGHT, 3e-5, 1.0, 0.1, 1e-6)
    ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1), ops.load(2, 0.0, 0.0, -WEIGHT, 0.0, 0.0, 0.0)
    solve("Static", "LoadControl", 0.1)
    if ops.analyze(10) != 0:
        raise RuntimeError("OpenSees found no equilibrium under the weight")
    ops.loadConst("-time", 0.0), ops.wipeAnalysis()
    ops.timeSeries("Path", 2, "-dt", step, "-values", *ground), ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
    solve("Transient", "Newmark", 0.5, 0.25)
    travel = [0.0]
    for i in range(len(ground) - 1):
        for _ in range(per_step):
            if ops.analyze(1, step / per_step) != 0:
                raise RuntimeError(f"OpenSees stopped at {i * step} s")
        travel.append(ops.nodeDisp(2, 1))
    return travel


def solve(kind: str, *integrator: object) -> None:
    ops.constraints("Transformation"), ops.numberer("RCM"), ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-9, 100), ops.algorithm("Newton")
    ops.integrator(*integrator), ops.analysis(kind)


def ours(folder: str, step: float, ground: list[float], share: float = 1.0) -> tuple[list[float], dict]:
    """Displacement [m] at every instant of the motion, and the summary; with sliders of this share of their masses."""
    record = pathlib.Path(folder) / "ground.csv"
    record.write_text("time_s,acceleration_m/s2\n" + "".join(f"{i * step:.6f},{a:.9f}\n" for i, a in enumerate(ground)))
    settings = ['excitation.kind="record"', f'excitation.x="{record}"', f"excitation.duration_s={(len(ground) - 1) * step}",
                f"reduced.output_step_ms={1e3 * step}"]
    settings += [f"isolator.{key}={share * kg}" for key, kg in SLIDERS.items()]
    run = rimpact("reduced", "tfp-pulse", "-o", folder + "/run", "--quiet", "--force", *[word for setting in settings for word in ("--set", setting)])
    assert run.returncode == 0, run.stderr
    with open(folder + "/run/response.csv", newline="") as file:
        travel = [float(row["ux_m"]) for row in csv.DictReader(file)]
    return travel, json.loads((pathlib.Path(folder) / "run" / "summary.json").read_text())


class BeforeAnyRim(unittest.TestCase):
    def compared(self, step: float, ground: list[float], per_step: int = 5) -> None:
        theirs = opensees(step, ground, per_step)
        peak = max(abs(u) for u in theirs)
        self.assertGreater(peak, 0.05)
        for share, history, largest in ((0.01, 0.01, 0.008), (1.0, 0.04, 0.02)):
            with tempfile.TemporaryDirectory() as folder:
                mine, summary = ours(folder, step, ground, share)
            self.assertEqual([face["rim_touched_s"] for face in summary["isolator"]["faces"]], [None] * 4)
            self.assertEqual(len(mine), len(theirs))
            apart = max(abs(a - b) for a, b in zip(mine, theirs))
            print(f"{self.id().split('.')[-1]}, masses times {share}: peak {1e3 * max(map(abs, mine)):.2f} mm, OpenSees {1e3 * peak:.2f} mm; farthest apart "
                  f"{1e3 * apart:.2f} mm, {100 * apart / peak:.2f} %")
            self.assertLess(abs(max(map(abs, mine)) / peak - 1), largest)
            self.assertLess(apart, history * peak)

    def test_pulse(self):
        self.compared(*ricker(0.30, 2.0))

    def test_swelling_shaking(self):
        self.compared(*swelling(0.35, 1.6))

    def test_chirp(self):
        self.compared(*chirp(0.12))

    def test_records(self):
        for name, scale in (("RSN1086_NORTHR_SYL360.AT2", 0.7), ("RSN1044_NORTHR_NWH360.AT2", 0.7), ("RSN6_IMPVALL.I_I-ELC180.AT2", 1.5)):
            with self.subTest(name):
                if not (RECORDS / name).is_file():
                    self.skipTest(f"{RECORDS / name} is not at hand (RIMPACT_RECORDS names the folder of PEER's records)")
                self.compared(*recorded(name, scale), per_step=10)


if __name__ == "__main__":
    unittest.main()
