"""The exported bearing flown by OpenSees: it arrives at its rim as the export says, and as the reduced model does."""
import json
import math
import re
import tempfile
import unittest
from typing import Any

import openseespy.opensees as ops
from command import rimpact
from exported import Exported, calibration, write

PLATE, SLIDER, TAG, ANCHOR = 1, 2, 1000, 100


class Bearing(Exported):
    def place(self, values: dict[str, Any], load: float = 1.0) -> None:
        """Plate, slider and bearing, at rest under `load` times the dead load."""
        ops.wipe()
        ops.model("basic", "-ndm", 3, "-ndf", 6)
        ops.node(PLATE, 0.0, 0.0, 0.0), ops.node(SLIDER, 0.0, 0.0, 0.0)
        ops.fix(PLATE, 1, 1, 1, 1, 1, 1), ops.fix(SLIDER, 0, 0, 0, 1, 1, 1)
        ops.mass(SLIDER, *[values["m1"]] * 3, 0.0, 0.0, 0.0)
        values["rimpact_bearing"](ops, TAG, PLATE, SLIDER, ANCHOR)
        ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1)
        ops.load(SLIDER, 0.0, 0.0, -load * values["dead_load"], 0.0, 0.0, 0.0)
        self.solve("Static", "LoadControl", 0.1)
        self.assertEqual(ops.analyze(10), 0)
        ops.loadConst("-time", 0.0), ops.wipeAnalysis()

    def solve(self, kind: str, *integrator: Any) -> None:
        ops.constraints("Transformation"), ops.numberer("RCM"), ops.system("UmfPack")
        ops.test("NormDispIncr", 1e-8, 50), ops.algorithm("Newton")
        ops.integrator(*integrator), ops.analysis(kind)

    def fly(self, values: dict[str, Any], pulse: str, scale: float) -> tuple[float, float, float]:
        """Speed at the first touch, the largest rim force [kN] and the rise at the largest travel less that of the dish."""
        found = re.match(r"ricker-([0-9.]+)g-([0-9.]+)s", pulse)
        assert found
        amplitude, period = 9.81 * scale * float(found.group(1)), float(found.group(2))
        self.place(values)
        step, n = 5e-4, round((2 * period + 3) / 5e-4)
        squares = [(math.pi * (i * step - 2 * period) / period) ** 2 for i in range(n + 2)]
        ops.timeSeries("Path", 2, "-dt", step, "-values", *[amplitude * (1 - 2 * q) * math.exp(-q) for q in squares])
        ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
        self.solve("Transient", "Newmark", 0.5, 0.25)
        speed = touch = force = furthest = rise = 0.0
        down = ops.nodeDisp(SLIDER, 3)
        for _ in range(n):
            self.assertEqual(ops.analyze(1, step), 0)
            u, before = abs(ops.nodeDisp(SLIDER, 1)), speed
            speed = abs(ops.nodeVel(SLIDER, 1))
            if u > values["lateral_capacity"] and not touch:
                touch = before
            force = max(force, abs(ops.basicForce(TAG + 2)[0]) / 1e3)
            if u > furthest:
                furthest, rise = u, ops.nodeDisp(SLIDER, 3) - down
        a, b = values["dish_half_width"], values["dish_ratio"] * values["dish_half_width"]
        return touch, force, rise - (b - b * math.sqrt(1 - (furthest / a) ** 2))

    def arrives(self, bearing: str, identity: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            write(folder, calibration(identity=identity))
            run = rimpact("export", folder, "--opensees", "--json", "--scene", bearing)
            self.assertEqual(run.returncode, 0, run.stderr)
            rows = [row for row in json.loads(run.stdout)["self_checks"][0]["pulses"]["rows"] if (row["model"]["touch_speed_m_s"] or 0) > 0.3]
            self.assertGreater(len(rows), 1)
            values = self.python(folder)
            for row in rows:
                with self.subTest(bearing=bearing, pulse=row["pulse"], scale=row["scale"]):
                    touch, force, off = self.fly(values, row["pulse"], row["scale"])
                    self.assertAlmostEqual(touch / row["exported"]["touch_speed_m_s"], 1, delta=0.04)
                    self.assertAlmostEqual(force / row["exported"]["peak_force_kN"], 1, delta=0.04)
                    self.assertAlmostEqual(touch / row["model"]["touch_speed_m_s"], 1, delta=0.06)
                    self.assertLess(abs(off), 1e-3)  # the pad gives way under the rim's push

    def test_a_bearing_under_pulses_arrives_as_the_model(self):
        self.arrives("shfps-225", self.rim)

    def test_a_sphere_too(self):
        found = re.search(r"its rim is ([0-9a-f]{16})", rimpact_refusal("fps-225"))
        assert found
        self.arrives("fps-225", found.group(1))

    def test_restoring_force_and_friction_follow_the_load(self):
        with tempfile.TemporaryDirectory() as folder:
            self.exported(folder, "--opensees", "--quiet")
            values = self.python(folder)
            forces = []
            for load in (1.0, 2.0):
                self.place(values, load)
                ops.timeSeries("Linear", 3), ops.pattern("Plain", 3, 3), ops.sp(SLIDER, 1, 1.0)
                self.solve("Static", "LoadControl", 0.01)
                self.assertEqual(ops.analyze(30), 0)
                ops.reactions()
                forces.append(ops.nodeReaction(SLIDER, 1))
            self.assertAlmostEqual(forces[1] / forces[0], 2, delta=0.02)


def rimpact_refusal(bearing: str) -> str:
    """What export says of a calibration that is of another rim than this bearing's: it names the bearing's."""
    with tempfile.TemporaryDirectory() as folder:
        write(folder, calibration())
        return rimpact("export", folder, "--csv", "--scene", bearing).stderr


if __name__ == "__main__":
    unittest.main()
