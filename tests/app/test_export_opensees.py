"""`rimpact export --opensees`: Python compiled and run on a recorder, Tcl run on stubs. tests/peers flies it in OpenSees."""
import math
import os
import tempfile
import unittest

from command import rimpact
from exported import Exported, Recorder, calibration, write


class OpenSees(Exported):
    def test_python_makes_the_calls_of_the_bearing(self):
        with tempfile.TemporaryDirectory() as folder:
            self.exported(folder, "--opensees")
            values, ops = self.python(folder), Recorder()
            values["rim_springs"](ops, 7, 100, 1, 2)
            gaps = [call for call in ops.calls if call[1] == "ElasticPPGap"]
            self.assertEqual([call[2] for call in gaps], [8, 9, 10, 11])
            numbers = zip(gaps, values["rim_stiffness"], values["rim_yield_force"], values["rim_hardening"], values["rim_begins"])
            for call, E, Fy, eta, begin in numbers:
                self.assertEqual(call[3:], (E, -Fy, -begin, eta, "damage"))
            self.assertAlmostEqual(min(values["rim_begins"]), 0.4, places=9)
            self.assertGreater(max(values["rim_begins"]), 0.4)
            self.assertEqual(ops.calls[4], ("uniaxialMaterial", "Parallel", 7, 8, 9, 10, 11))
            self.assertEqual([call[2] for call in ops.calls[5:]], [100, 101])
            self.assertEqual([call[10] for call in ops.calls[5:]], [-1.0, 1.0])  # local x: shortened by motion along +x, -x
            ops = Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            nodes = {call[1]: call[2:] for call in ops.calls if call[0] == "node"}
            self.assertEqual(sorted(nodes), list(range(99, 106)))
            self.assertEqual(nodes[99][2], 2.999)  # the anchor, below the seat
            self.assertEqual(nodes[100], nodes[101])  # seat and foot slide on one another
            self.assertEqual(nodes[102], (1.0, 2.0, 3.0))  # the slider's hinge is at the slider
            self.assertAlmostEqual((nodes[102][0] - nodes[101][0]) / (nodes[103][0] - nodes[101][0]), values["dish_ratio"])
            self.assertAlmostEqual(nodes[104][2] - nodes[103][2], values["dish_half_width"])
            elements = [call for call in ops.calls if call[0] == "element"]
            self.assertEqual([call[1] for call in elements], ["flatSliderBearing", "corotTruss", "zeroLength", "zeroLength", "zeroLength", "elasticBeamColumn",
                                                             "elasticBeamColumn", "corotTruss", "corotTruss"])
            self.assertEqual(len({call[2] for call in elements}), 9)
            tags = [call[2] for call in ops.calls if call[0] == "uniaxialMaterial"]
            self.assertEqual(len(tags), len(set(tags)))
            # the round rim closes where the truss has the length of the capacity, and is as stiff as the springs along x
            gap = next(call for call in ops.calls if call[1] == "ElasticPPGap")
            self.assertAlmostEqual((1 + gap[5]) * 0.001, math.hypot(values["rim_begins"][0], 0.001))
            self.assertAlmostEqual(gap[3] / 0.001 / values["rim_stiffness"][0], 1)
            # ellipsoid and table together restore W h'(r), and what friction along the slope adds: 853 kN, R0 = 2.25, a = 0.5625
            self.assertAlmostEqual(values["dish_half_width"], 0.5625, places=4)
            self.assertAlmostEqual(values["dish_ratio"], 0.25, places=4)
            table = next(call for call in ops.calls if call[1] == "ElasticMultiLinear")
            half = table.index("-stress")
            strain, force = table[4:half], table[half + 1:]
            for e, f in list(zip(strain, force))[2:]:
                r = math.sqrt(((1 + e) * 0.001) ** 2 - 1e-6)
                if r < 0.45:
                    slope = r / 2.25 / math.sqrt(1 - (r / 0.5625) ** 2)
                    rides = values["dish_ratio"] * r / math.sqrt(values["dish_half_width"] ** 2 - r ** 2)
                    self.assertAlmostEqual((f * r / ((1 + e) * 0.001) / 853e3 + rides) / (slope * (1 + 0.07 ** 2 * (1 + slope ** 2))), 1, places=4)

    def test_tcl_and_python_make_the_same_bearing(self):
        with tempfile.TemporaryDirectory() as folder:
            self.exported(folder, "--opensees")
            values, ops = self.python(folder), Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            values["rim_springs"](ops, 70, 100, 1, 2)
            lines = self.tcl(folder, "rimpact_bearing 1000 1 2 99\nrim_springs 70 100 1 2")
            expected = [call for call in ops.calls if call[0] != "nodeCoord"]
            self.assertEqual(len(lines), len(expected))
            for line, call in zip(lines, expected):
                words = line.split()
                self.assertEqual(len(words), len(call), line)
                for word, value in zip(words, call):
                    if isinstance(value, (int, float)):
                        self.assertAlmostEqual(float(word), value, delta=1e-6 * abs(value) + 1e-12)
                    else:
                        self.assertEqual(word, value)

    def test_without_the_dish_only_the_rim(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder, calibration("acme"))
            run = rimpact("export", folder, "--opensees", "--sap2000")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("--scene", run.stderr)
            self.assertNotIn("rimpact_bearing", self.python(folder))
            with open(os.path.join(folder, "bearing.s2k")) as file:
                self.assertNotIn("Link=DISH", file.read())


if __name__ == "__main__":
    unittest.main()
