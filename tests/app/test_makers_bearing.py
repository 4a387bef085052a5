"""Every number's bearing, load, motion and element are said, and doubted where they are another bearing's."""
import csv
import json
import os
import shutil
import tempfile
import unittest

import h5py
from command import rimpact


class MakersBearing(unittest.TestCase):
    PAIR = "the thesis's for shfps-225"
    MAKER = ('name = "acme"\n[surface]\nkind = "sphere"\nR0_m = 3.0\nplanar_radius_mm = 600\n[slider]\ndiameter_mm = 300\nbottom_mm = 58\ntop_mm = 158\n'
             '[rim]\nheight_mm = 70\nthickness_mm = 50\n[foot]\nradius_mm = 20\n')
    SCENE = '[bearing]\nfile = "b.toml"\n[load]\nvertical_kN = 2000\n[excitation]\nkind = "ricker"\namplitude_g = 1.1\n'

    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = self.keeper.name
        for name, text in (("b.toml", self.MAKER), ("s.toml", self.SCENE)):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write(text)
        self.scene = os.path.join(self.folder, "s.toml")

    def calibration(self, rim, **more):
        folder = os.path.join(self.folder, "cal")
        os.makedirs(folder, exist_ok=True)
        law = {"name": "no-tension", "belongs_to": "mass", "fitted_from_m_s": 0.05, "fitted_to_m_s": 0.3,
               "element": {"k_i": {"value": 1.2e5, "unit": "kN/m"}, "e": {"value": 0.3, "unit": "-"}}}
        with open(os.path.join(folder, "calibration.json"), "w") as file:
            json.dump({"answer": {"rim_identity": rim, "mass_kg": 2000e3 / 9.81, "law": {**law, **more}}}, file)
        return folder

    def test_a_makers_bearing_needs_no_pad_and_foot(self):
        checked = rimpact("check", self.scene)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        for words in ("bearing: acme, L_c = 450.0 mm", "W = 2000 kN, m = 203874 kg", "motion: ricker", "amplitude_g 1.1", "signed, k_i = 450000 kN/m, e = 0.65",
                      "the thesis's pair for shfps-225", "pad and foot are left out of these notes"):
            self.assertIn(words, checked.stdout)
        self.assertIn(self.PAIR, checked.stderr)
        table = json.loads(rimpact("check", self.scene, "--json").stdout)
        self.assertEqual(table["bearing"], "acme")
        self.assertAlmostEqual(table["load"]["mass_kg"], 2000e3 / 9.81)
        self.assertEqual(table["motion"]["amplitude_g"], 1.1)
        self.assertEqual(table["impact_element"]["source"], "the thesis's pair for shfps-225")
        self.assertTrue(any(self.PAIR in sentence for sentence in table["warnings"]))
        self.assertNotIn("rim.height_mm", table["assumptions"])
        self.assertIn("foot.cap_radius_mm", table["assumptions"])
        refused = rimpact("check", self.scene, "--rung", "full")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("foot", refused.stderr)

    def test_a_calibration_knows_its_dish_from_every_folder(self):
        """Calibrated by relative names, moved, and exported from elsewhere without its runs: the dish and its friction are there."""
        made = rimpact("reduced", "s.toml", "-o", "run", "--set", "excitation.kind=window", "--set", "excitation.speed_m_per_s=0.2", cwd=self.folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        fitted = rimpact("calibrate", "run", "-o", "cal", "--laws", "none", cwd=self.folder)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "cal", "calibration.json")), fitted.stderr)
        with tempfile.TemporaryDirectory() as elsewhere:
            shutil.move(os.path.join(self.folder, "cal"), os.path.join(elsewhere, "moved"))
            done = rimpact("export", "moved", "--sap2000", "--opensees", "--json", cwd=elsewhere)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(json.loads(done.stdout)["whole_bearing"], done.stderr)
            self.assertNotIn("is not known here", done.stderr)
            # the pad whose stiffness is exported is not this bearing's
            self.assertIn("is the built-in bearing's", done.stderr)
            for name in ("bearing.s2k", "impact.tcl"):
                with open(os.path.join(elsewhere, "moved", name), encoding="utf-8") as file:
                    self.assertIn("built-in bearing's", " ".join(file.read().split()).replace(" # ", " ").replace(" $ ", " "))

    def test_a_calibration_takes_the_pairs_place(self):
        out = os.path.join(self.folder, "run")
        published = rimpact("reduced", self.scene, "-o", out)
        self.assertIn(self.PAIR, published.stderr)
        with open(os.path.join(out, "summary.json")) as file:
            self.assertTrue(any(self.PAIR in sentence for sentence in json.load(file)["warnings"]))
        cal = self.calibration("0123456789abcdef")
        fitted = rimpact("reduced", self.scene, "--calibration", cal, "-o", out)
        self.assertEqual(fitted.returncode, 0, fitted.stderr)
        self.assertIn(f"no-tension, k_i = 120000 kN/m, e = 0.3 (calibration {cal}; fitted from 0.05 to 0.3 m/s; for 203874 kg only)", fitted.stdout)
        self.assertNotIn(self.PAIR, fitted.stderr)
        self.assertIn("fitted to another rim: dish, slider, ", fitted.stderr)  # no code of the two rims: it tells a reader nothing
        self.assertIn("outside the speeds the impact element was fitted to, 0.05 to 0.3 m/s", fitted.stderr)
        with open(os.path.join(out, "summary.json")) as file:
            first = json.load(file)
        self.assertTrue(first["beyond_fit"])
        shutil.rmtree(cal)
        again = os.path.join(self.folder, "again")
        self.assertEqual(rimpact("reduced", out, "-o", again).returncode, 0)  # the folder's scene.toml has the numbers
        with open(os.path.join(again, "summary.json")) as file:
            self.assertEqual(json.load(file)["impacts"], first["impacts"])
        gone = rimpact("reduced", self.scene, "--calibration", cal, "-o", out)
        self.assertEqual(gone.returncode, 3)
        self.assertIn("calibration.json: no such file", gone.stderr)

    def test_a_fleet_says_what_is_beyond(self):
        cal, out = self.calibration("0123456789abcdef"), os.path.join(self.folder, "fleet")
        sweep = os.path.join(self.folder, "sweep.toml")
        with open(sweep, "w") as file:
            file.write('[grid]\nexcitation.amplitude_g = [0.3, 1.1, 1.3]\n[fractiles]\nalong = "excitation.amplitude_g"\n')
        run = rimpact("reduced", self.scene, "--calibration", cal, "--sweep", sweep, "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("fitted to another rim", run.stderr)
        self.assertIn("lie outside the speeds that the impact element was fitted to (0.05 to 0.3 m/s)", run.stderr)
        with open(os.path.join(out, "table.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["beyond_fit"] for row in rows], ["0", "1", "1"])
        self.assertEqual(rows[0]["beyond_rim"], "0")
        with open(os.path.join(out, "fractiles.csv"), newline="") as file:
            levels = list(csv.DictReader(file))
        self.assertEqual([level["n_beyond_fit"] for level in levels], ["0", "1", "1"])
        with h5py.File(os.path.join(out, "table.h5")) as table:
            self.assertEqual(list(table["table/beyond_fit"]), [0, 1, 1])
        plain = rimpact("reduced", self.scene, "--sweep", sweep, "-o", os.path.join(self.folder, "plain"))
        self.assertIn(self.PAIR, plain.stderr)


if __name__ == "__main__":
    unittest.main()
