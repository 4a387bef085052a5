"""Buildings in the report and as tables: drift, storeys, roof. A toy response in the files of a real run."""
import csv
import json
import os
import unittest

import h5py
import numpy as np
import synthetic
from small_results import first_page
from support import InFolder, in_process, text_of, unpainted

from report import building_tables
from report.build import build
from report.figures import storeys
from report.first_page.run import residual_title
from report.run_folder import load_run
from report.sections import building_on_bearings


class Building(InFolder):
    def run_folder(self, signals, summary):
        synthetic.run(self.path("run"), "run", 'kind = "ricker"', synthetic.ricker(0.5, 1.0), synthetic.Rim(4.5e8, 0.65), "reduced")
        with h5py.File(self.path("run", "response.h5"), "a") as file:
            time = file["response/time"][()]
            for name, amplitude in signals.items():
                file[f"response/{name}"] = amplitude * np.sin(5 * time)
        with open(self.path("run", "summary.json"), encoding="utf-8") as file:
            said = json.load(file)
        self.write("run/summary.json", json.dumps(said | summary))
        return self.path("run")

    def rows(self, name):
        with open(self.path("run", name), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def frame(self):
        return self.run_folder({"drift_x": 0.01, "drift_y": 0.0, "roof_x": 0.05, "roof_y": 0.0, "roof_acceleration_x": 3.0, "storey_shear_x": 4e5},
                               {"peak_drift_m": 0.01, "superstructure": {"storeys": [
                                   {"peak_drift_m": d, "residual_drift_m": 0.0, "peak_shear_N": 4e5, "peak_acceleration_m_s2": 3.0} for d in (0.01, 0.008)]}})

    def test_columns_carry_their_units(self):
        run = load_run(self.frame())
        columns = building_tables.histories(run)
        self.assertEqual(set(columns), {"time_s", "drift_x_m", "drift_y_m", "roof_x_m", "roof_y_m", "roof_acceleration_x_m_per_s2", "storey_shear_x_N"})
        np.testing.assert_array_equal(columns["roof_x_m"], run.signals["roof_x"])

    @unpainted
    def test_the_report_writes_the_tables(self):
        path, problems = build(self.frame())
        self.assertEqual(problems, [])
        with open(path, encoding="utf-8") as file:
            self.assertIn("<code>building.csv</code> and <code>storeys.csv</code>", file.read())
        self.assertAlmostEqual(max(float(row["drift_x_m"]) for row in self.rows("building.csv")), 0.01, delta=1e-4)
        self.assertEqual([(row["storey"], float(row["peak_drift_m"])) for row in self.rows("storeys.csv")], [("1", 0.01), ("2", 0.008)])
        self.assertTrue(os.path.isfile(self.path("run", "figures", "storeys-run.png")))

    def test_floors_of_a_building_on_bearings(self):
        signals = {f"floor_{i}_{part}_x": 0.01 * i for i in (1, 2, 3) for part in ("displacement", "drift", "acceleration")}
        run = load_run(self.run_folder(signals, {"building": {"floors": [{"peak_drift_m": 0.01, "peak_shear_N": 1e5, "peak_acceleration_m_s2": 1.0}] * 3}}))
        columns = building_tables.histories(run)
        np.testing.assert_array_equal(columns["roof_x_m"], run.signals["floor_3_displacement_x"])
        panels = storeys.histories(run)
        self.assertEqual([len(panel.lines) for panel in panels], [3, 1, 1])
        self.assertIsNotNone(storeys.draw_histories(run, self.path("a.png")))
        self.assertIsNotNone(storeys.draw_profiles(run, self.path("b.png")))

    @unpainted
    def test_the_picture_of_a_run_writes_them_too(self):
        self.assertEqual(in_process("report.quick", "reduced", self.frame()).returncode, 0)
        self.assertEqual(len(self.rows("storeys.csv")), 2)

    def test_a_run_without_a_building_has_none(self):
        run = load_run(self.run_folder({}, {}))
        self.assertEqual((building_tables.write(run), storeys.draw_profiles(run, self.path("a.png")), storeys.histories(run)), ([], None, []))

    def test_what_a_dish_stands_on_is_said(self):
        said = building_on_bearings._springs({"dish_springs": {"stiffness_N_per_m": 4e9, "restitution": 0.65, "assumed": True}})
        self.assertIn("a vertical spring of 4\u202f000\u202f000 kN/m", said["text"])
        self.assertIn("an assumption of ours", said["text"])
        self.assertNotIn("assumption", building_on_bearings._springs({"dish_springs": {"stiffness_N_per_m": 1e9, "restitution": 0.65, "assumed": False}})["text"])
        self.assertIsNone(building_on_bearings._springs({}))

    def test_a_run_that_ends_in_motion_has_no_residual_displacement(self):
        self.assertEqual(residual_title({"final_speed_m_s": 0.8353}), "Displacement at the end, at 0.84\u00a0m/s")
        for rest in ({"final_speed_m_s": 0.0}, {"final_speed_m_s": None}, {}):
            self.assertEqual(residual_title(rest), "Residual displacement")

    def test_drift_roof_and_storeys_are_reported(self):
        synthetic.run(self.path("run"), "town-hall", 'kind = "ricker"\nscale = 1.0\namplitude_g = 0.78', synthetic.ricker(0.9, 1.0), synthetic.Rim(4e8, 0.6), "reduced")
        run = load_run(self.path("run"))
        for name in ("drift_x", "roof_x", "storey_shear_x", "roof_acceleration_x"):
            run.signals[name] = np.sin(run.time)
            run.signals[name[:-1] + "y"] = 0 * run.time
        synthetic.write_signals(self.path("run"), run.signals)
        storeys = [{"peak_drift_m": 0.0234, "residual_drift_m": 0.001, "peak_shear_N": 1.5e6, "peak_acceleration_m_s2": 4.9}]
        self.write("run/summary.json", json.dumps(run.summary | {"peak_drift_m": 0.0234, "peak_storey_shear_N": 1.5e6, "ductility": None,
                                                                 "peak_floor_acceleration_m_s2": 4.9, "superstructure": {"storeys": storeys}}))
        path, problems = build(self.path("run"))
        self.assertEqual(problems, [])
        self.assertRegex(first_page(path)[1], r"Peak storey drift 23\.4\u00a0mm Peak storey shear 1500\u00a0kN Peak floor acceleration 0\.500\u00a0g")
        self.assertRegex(text_of(path)[1], r"1 23\.40 1\.00 1500 0\.500")
        self.assertTrue(os.path.exists(self.path("run/figures/building-run.png")))


if __name__ == "__main__":
    unittest.main()
