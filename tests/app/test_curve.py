"""rimpact curve: a draft curve is made, flown and refused where it does not hold."""
import csv
import json
import os
import tempfile
import unittest

import h5py
from command import rimpact


class Curve(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = os.path.join(cls.place.name, "curve")
        cls.made = rimpact("curve", "shfps-225", "--mesh", "0", "--speed", "0.1", "--unloadings", "3", "--json", "-o", cls.folder)
        cls.file = os.path.join(cls.folder, "curve.h5")

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def fly(self, *settings):
        return rimpact("reduced", "impact-window", "--set", "reduced.impact_law=curve", "--set", f"reduced.impact_curve={self.file}",
                       *settings, "--json", "--force", "-o", os.path.join(self.place.name, "flown"))

    def test_what_it_writes(self):
        self.assertEqual(self.made.returncode, 0, self.made.stderr)
        told = json.loads(self.made.stdout)
        self.assertGreater(told["fastest_m_s"]["held"], 0.1)
        self.assertEqual(told["n_unloadings"], 3)
        with h5py.File(self.file) as file:
            d, force = file["held/loading/penetration"][:], file["held/loading/force"][:]
            self.assertEqual(file["dish/loading/force"].attrs["units"], "N")
            self.assertEqual(file["meta/bearing"][()].decode(), "shfps-225")
            self.assertEqual((file["dish/unloading/force"][-1], set(file["dish/unloading/branch"][:])), (0, {1, 2, 3}))
        work = sum((b - a) * (f + g) / 2 for a, b, f, g in zip(d, d[1:], force, force[1:]))
        self.assertGreater(work, 0.5 * 86952 * 0.1**2)  # it was pushed until it stops the speed asked for
        with open(os.path.join(self.folder, "curve.csv"), encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(file) if row["path"] == "held" and row["branch"] == "0"]
        self.assertEqual([float(row["force_N"]) for row in rows], list(force))

    def test_it_balances_the_energy_of_a_window(self):
        run = self.fly("--set", "excitation.speed_m_per_s=0.08")
        self.assertEqual(run.returncode, 0, run.stderr)
        impact = json.loads(run.stdout)["impacts"][0]
        with h5py.File(self.file) as file:
            d, force = file["held/loading/penetration"][:], file["held/loading/force"][:]
        work = 0
        for a, b, f, g in zip(d, d[1:], force, force[1:]):
            end = min(b, impact["peak_penetration_m"])
            work += (end - a) * (f + f + (g - f) * (end - a) / (b - a)) / 2 if end > a else 0
        self.assertAlmostEqual(work / (0.5 * 86952 * 0.08**2), 1, delta=0.01)
        self.assertTrue(0.2 < impact["restitution"] < 0.9, impact)

    def test_the_held_path_alone_serves_windows_without_weight(self):
        folder = os.path.join(self.place.name, "held")
        made = rimpact("curve", "shfps-225", "--mesh", "0", "--speed", "0.1", "--unloadings", "3", "--held", "--json", "-o", folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        told = json.loads(made.stdout)
        self.assertIsNone(told["deepest_m"]["dish"])
        self.assertGreater(told["fastest_m_s"]["held"], 0.1)
        with h5py.File(os.path.join(folder, "curve.h5")) as held, h5py.File(self.file) as both:
            self.assertNotIn("dish", held)
            for column in ("held/loading/force", "held/steel/strain", "held/unloading/force"):
                self.assertEqual(list(held[column][:]), list(both[column][:]), column)
            strain = both["held/steel/strain"][:]
            self.assertEqual(strain[0], 0)
            self.assertGreater(strain[-1], strain[1])
            self.assertLess(strain[-1], 0.2)
        words = ["reduced", "impact-window", "--set", "reduced.impact_law=curve", "--set", f"reduced.impact_curve={folder}/curve.h5",
                 "--set", "excitation.speed_m_per_s=0.08", "--force", "-o", os.path.join(self.place.name, "on-held")]
        self.assertEqual(rimpact(*words).returncode, 0)
        weighed = rimpact(*words, "--set", 'excitation.with=["weight"]')
        self.assertEqual(weighed.returncode, 2)
        self.assertIn("--held", weighed.stderr)

    def test_what_it_refuses(self):
        fast = self.fly("--set", "excitation.speed_m_per_s=0.3")
        self.assertEqual(fast.returncode, 4)
        self.assertIn("an approach at 0.300 m/s exceeds", fast.stderr)
        self.assertIn("take rung rim", fast.stderr)
        other = self.fly("--set", "bearing.rim.height_mm=70")
        self.assertEqual(other.returncode, 2)
        self.assertIn("make its own by `rimpact curve BEARING`", other.stderr)
        twice = rimpact("curve", "--mesh", "0", "-o", self.folder)
        self.assertEqual(twice.returncode, 2)
        self.assertIn("holds a curve already", twice.stderr)
        unnamed = rimpact("reduced", "impact-window", "--set", "reduced.impact_law=curve", "-o", os.path.join(self.place.name, "none"))
        self.assertEqual(unnamed.returncode, 2)
        self.assertIn("needs reduced.impact_curve", unnamed.stderr)
        text = os.path.join(self.place.name, "text.h5")
        with open(text, "w", encoding="utf-8") as file:
            file.write("no curve")
        damaged = self.fly("--set", f"reduced.impact_curve={text}")
        self.assertEqual(damaged.returncode, 3)
        self.assertIn("is not a rim curve", damaged.stderr)


if __name__ == "__main__":
    unittest.main()
