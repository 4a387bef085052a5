"""Exported bearings in OpenSees: of any direction, on a sphere, under other loads, on the dent of a first hit, under a building."""
import csv
import json
import math
import os
import pathlib
import runpy
import sys
import tempfile

import flights
import openseespy.opensees as ops
from command import rimpact
from exported import ELEMENT, Exported, calibration, identity, write
from exported_there import PythonFile, TclFile
from flights import PLATE, SLIDER
from opensees_rows import LAWS, export, of_law, pulses


class Bearing(Exported):
    def file(self, folder: str, law: str = "elastoplastic") -> PythonFile:
        self.table = export(folder, of_law(law, self.rim))
        return PythonFile(pathlib.Path(folder, "impact.py"))

    def test_the_round_rim_is_the_same_all_around_and_new_at_every_touch(self):
        with tempfile.TemporaryDirectory() as folder:
            file = self.file(folder)
            along = flights.windows(file, 0.4, 0.04)[0]
            for turn in (0.0, 0.7, 2.5):
                first, second = flights.windows(file, 0.4, 0.04, turn=turn, procedure="rim_round")
                for hit in (first, second):
                    self.assertAlmostEqual(hit.peak / along.peak, 1, delta=1e-3)
                    self.assertAlmostEqual(hit.rebound / along.rebound, 1, delta=2e-3)
            left = flights.windows(file, 0.4, 0.04, side=-1)[0]
            self.assertAlmostEqual(left.peak / along.peak, 1, places=9)

    def test_a_rim_along_x_keeps_its_dents_in_the_whole_bearing(self):
        with tempfile.TemporaryDirectory() as folder:
            file, tcl = self.file(folder), TclFile(pathlib.Path(folder, "impact.tcl"))
            # a pulse twice: the second finds the dent of the first, on the same side
            pulse = [0.78 * 9.81 * 1.1 * (1 - 2 * q) * math.exp(-q) for q in ((math.pi * (i * 1e-3 - 1.5)) ** 2 for i in range(4001))]
            runs = [flights.fly(one, {1: pulse + pulse}, 1e-3, 6.2, step=1e-3, rim=rim) for one, rim in ((file, ()), (file, ("along_x",)), (tcl, ("along_x",)))]
            tcl.close()
            renewed, dented, same = ([hit.peak for hit in run.hits] for run in runs)
            self.assertEqual(len(dented), 2)
            self.assertAlmostEqual(dented[0] / renewed[0], 1, delta=0.01)
            self.assertGreater(dented[1] / renewed[1], 1.1)
            for a, b in zip(dented, same):
                self.assertAlmostEqual(a / b, 1, delta=1e-4)

    def test_an_unknown_rim_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            file, tcl = self.file(folder), TclFile(pathlib.Path(folder, "impact.tcl"))
            for one in (file, tcl):
                flights.begin()
                with self.assertRaisesRegex((ValueError, RuntimeError), "square is neither"):
                    one.make("rimpact_bearing", flights.TAG, PLATE, SLIDER, flights.ANCHOR, "square")
            tcl.close()

    def test_on_a_sphere_it_arrives_as_the_model(self):
        with tempfile.TemporaryDirectory() as folder:
            table = export(folder, of_law("elastoplastic", identity("fps-225")), "fps-225")
            table["self_checks"][0]["pulses"]["rows"] = [row for row in table["self_checks"][0]["pulses"]["rows"] if (row["model"]["touch_speed_m_s"] or 0) > 0.3][:2]
            rows = list(pulses(folder, PythonFile(pathlib.Path(folder, "impact.py")), table, "fps-225"))
            self.assertEqual(len(rows), 2)
            for row in rows:
                for side in ("own", "model"):
                    self.assertLess(max(abs(value) for value in row.over(side)[:2] if value is not None), 0.06, (row.name, side))

    def test_restoring_force_and_friction_follow_the_load(self):
        with tempfile.TemporaryDirectory() as folder:
            content = of_law("elastoplastic", self.rim)
            content["answer"].pop("stack")  # the socket's friction is of the dead load
            export(folder, content)
            file, forces = PythonFile(pathlib.Path(folder, "impact.py")), []
            for load in (1.0, 2.0):
                flights.place(file, load)
                ops.timeSeries("Linear", 3), ops.pattern("Plain", 3, 3), ops.sp(SLIDER, 1, 1.0)
                flights.solve("Static", "LoadControl", 0.01, tolerance=1e-8)
                self.assertEqual(ops.analyze(30), 0)
                ops.reactions()
                forces.append(ops.nodeReaction(SLIDER, 1))
            self.assertAlmostEqual(forces[1] / forces[0], 2, delta=0.02)

    def test_every_law_of_the_catalogue_is_flown_here_or_refused(self):
        """No exported file is without a flight: opensees_table.py flies those of LAWS."""
        catalogue = json.loads(rimpact("list", "laws", "--json").stdout)["laws"]
        self.assertLessEqual(LAWS.keys(), catalogue.keys())
        for law in catalogue.keys() - LAWS.keys():
            with self.subTest(law=law), tempfile.TemporaryDirectory() as folder:
                everything = {"e": {"value": 0.5, "unit": "-"}, "exponent": {"value": 1.5, "unit": "-"}}
                content = calibration(identity=self.rim, name=law, element={**ELEMENT, **everything}, belongs_to="rim", mass_kg=86952.0)
                write(folder, content)
                run = rimpact("export", folder, "--opensees", "--quiet", "--scene", "shfps-225")
                self.assertEqual(run.returncode, 3, f"{law} is exported, or refused for a number that is missing here: add it to LAWS. {run.stderr}")
                self.assertRegex(run.stderr, "OpenSees has no material for the impact law|needs reduced.impact_curve")
                self.assertFalse(pathlib.Path(folder, "impact.py").exists())

    def test_the_whole_bearing_of_every_other_law_flies(self):
        pulse = [0.78 * 9.81 * 1.05 * (1 - 2 * q) * math.exp(-q) for q in ((math.pi * (i * 1e-3 - 2)) ** 2 for i in range(5003))]
        for law in LAWS.keys() - {"elastoplastic"}:
            with self.subTest(law=law), tempfile.TemporaryDirectory() as folder:
                file = self.file(folder, law)
                row = next(row for row in self.table["self_checks"][0]["pulses"]["rows"] if row["pulse"].startswith("ricker-0.78g") and row["scale"] == 1.05)
                hit = max(flights.fly(file, {1: pulse}, 1e-3, 3.0).hits, key=lambda hit: hit.peak)
                self.assertAlmostEqual(hit.approach / row["exported"]["touch_speed_m_s"], 1, delta=0.04)
                self.assertAlmostEqual(hit.peak / 1e3 / row["exported"]["peak_force_kN"], 1, delta=0.06)

    def test_the_bearings_of_a_building_fly_alike_in_tcl_and_python(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(rimpact("building", "ricker-0.78g-1.0s", "-o", folder, "--quiet", "--set", "excitation.duration_s=0.1").returncode, 0)
            self.assertEqual(rimpact("export", folder, "--opensees", "--quiet").returncode, 0)
            with open(os.path.join(folder, "nodes.csv")) as file:
                columns = [row for row in csv.DictReader(file) if row["bearing"] == "1"]
            pulse = [0.78 * 9.81 * 1.05 * (1 - 2 * q) * math.exp(-q) for q in ((math.pi * (i * 1e-3 - 2)) ** 2 for i in range(5003))]
            self.assertEqual(len(columns), 6)
            travels = []
            for language in ("py", "tcl"):
                ops.wipe(), ops.model("basic", "-ndm", 3, "-ndf", 6)
                ops.timeSeries("Linear", 1), ops.pattern("Plain", 1, 1)
                for row in columns:
                    node, own = int(row["node"]), runpy.run_path(os.path.join(folder, f"bearing_{row['node']}.py"))
                    ops.node(node, *(float(row[name]) for name in ("x_m", "y_m", "z_m"))), ops.fix(node, 0, 0, 0, 1, 1, 1)
                    ops.mass(node, *[own["m1"]] * 3, 0.0, 0.0, 0.0), ops.load(node, 0.0, 0.0, -own["dead_load"], 0.0, 0.0, 0.0)
                if language == "py":
                    sys.path.insert(0, folder)
                    runpy.run_path(os.path.join(folder, "bearings.py"))["place"](ops)
                    sys.path.remove(folder)
                else:
                    TclFile(pathlib.Path(folder, "bearings.tcl")).close()
                flights.solve("Static", "LoadControl", 0.1, tolerance=1e-8)
                self.assertEqual(ops.analyze(10), 0)
                ops.loadConst("-time", 0.0), ops.wipeAnalysis()
                ops.timeSeries("Path", 2, "-dt", 1e-3, "-values", *pulse), ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
                flights.solve("Transient", "Newmark", 0.5, 0.25, tolerance=1e-8)
                furthest = dict.fromkeys((int(row["node"]) for row in columns), 0.0)
                for _ in range(2700):
                    flights.advance(1e-3)
                    for node in furthest:
                        furthest[node] = max(furthest[node], abs(ops.nodeDisp(node, 1)))
                travels.append(list(furthest.values()))
            for one, other in zip(*travels):
                self.assertAlmostEqual(one, other, delta=1e-6)
                self.assertGreater(one, 0.4)  # to the rim, which is as stiff for each by its mass
                self.assertLess(one, 0.415)


if __name__ == "__main__":
    import unittest
    unittest.main()
