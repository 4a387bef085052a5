"""Impacts on the exported springs, integrated by OpenSees, against the export's own check."""
import json
import tempfile
import unittest

import openseespy.opensees as ops
from exported import Exported


class Springs(Exported):
    def test_an_impact_is_what_the_export_says(self):
        with tempfile.TemporaryDirectory() as folder:
            checks = json.loads(self.exported(folder, "--opensees", "--json").stdout)["self_checks"][0]
            values = self.python(folder)
            for row in checks["rows"]:
                expected, speed = row["spring"], row["speed_m_s"]
                step = expected["contact_time_ms"] / 1e3 / 2000
                ops.wipe()
                ops.model("basic", "-ndm", 3, "-ndf", 6)
                ops.node(1, 0.0, 0.0, 0.0), ops.node(2, 0.0, 0.0, 0.0)
                ops.fix(1, 1, 1, 1, 1, 1, 1), ops.fix(2, 0, 1, 1, 1, 1, 1)
                ops.mass(2, *[values["m1"]] * 6)
                values["rim_springs"](ops, 7, 100, 1, 2)
                ops.setNodeDisp(2, 1, values["lateral_capacity"] - speed * step, "-commit"), ops.setNodeVel(2, 1, speed, "-commit")
                ops.constraints("Plain"), ops.numberer("Plain"), ops.system("BandGeneral"), ops.test("NormUnbalance", 1e-3, 50)
                ops.algorithm("Newton"), ops.integrator("Newmark", 0.5, 0.25), ops.analysis("Transient")
                force = depth = 0.0
                for _ in range(2100):
                    self.assertEqual(ops.analyze(1, step), 0)
                    force = max(force, -values["m1"] * ops.nodeAccel(2, 1))
                    depth = max(depth, ops.nodeDisp(2, 1) - values["lateral_capacity"])
                self.assertAlmostEqual(force / 1e3 / expected["peak_force_kN"], 1, delta=0.01)
                self.assertAlmostEqual(1e3 * depth / expected["penetration_mm"], 1, delta=0.01)
                self.assertAlmostEqual(-ops.nodeVel(2, 1) / speed, expected["rebound"], delta=0.01)


if __name__ == "__main__":
    unittest.main()
