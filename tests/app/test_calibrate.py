"""`rimpact calibrate`: its options, what it finds in runs of known laws, and what of it flies afterwards."""
import json
import os
import tempfile
import unittest

from command import Refusals, rimpact


class Calibrate(Refusals):
    def test_words_of_calibrate(self):
        for words, said in ((["--fixed", "e"], "NAME=VALUE"), (["--bounds", "k_i=3"], "NAME=LOW:HIGH"),
                            (["--sigma", "forse=0.1"], "did you mean \"force\""), (["--law", "signd"], "signed"),
                            (["--fit", "k_i,stiffness"], "stiffness"), (["--start", "k_i=much"], "is not a number"),
                            (["--lead-mm", "nan"], "--lead-mm nan must be in 0..1000"), (["--starts", "2147483647"], "n_starts 2.14748e+09 must be <= 1000")):
            self.refused(2, said, arguments=["calibrate", "/nowhere", *words])
        self.refused(2, "are the same run", arguments=["calibrate", "/nowhere", "/nowhere/../nowhere"])

    def test_reduced_compare_and_calibrate(self):
        with tempfile.TemporaryDirectory() as folder:
            one, two = os.path.join(folder, "one"), os.path.join(folder, "two")
            for path, stiffness in ((one, 3e5), (two, 4.5e5)):
                run = rimpact("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "--set",
                              f"reduced.k_i_kN_per_m={stiffness}", "-o", path)
                self.assertEqual(run.returncode, 0, run.stderr)
            metrics = json.loads(rimpact("compare", one, two, "--json").stdout)
            self.assertGreater(metrics["peak_force_error"], 0.1)
            self.assertEqual(json.loads(rimpact("compare", one, one, "--json").stdout)["nrmse_displacement"], 0)
            run = rimpact("calibrate", one, "--predict", two, "-o", os.path.join(folder, "fit"))
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(folder, "fit", "calibration.json")) as file:
                fit = json.load(file)
            self.assertAlmostEqual(fit["parameters"]["k_i"]["value"] / 3e5, 1, places=5)
            self.assertAlmostEqual(fit["parameters"]["e"]["value"], 0.65, places=5)
            self.assertEqual(fit["answer"]["law"]["name"], "signed")  # of the four ranked by default the one that made the run
            self.assertEqual(fit["answer"]["law"]["belongs_to"], "mass")
            asked = rimpact("calibrate", one, "--law", "no-tension", "-o", os.path.join(folder, "asked"))
            self.assertIn("The law signed is better", asked.stdout)
            with open(os.path.join(folder, "asked", "calibration.toml")) as file:
                self.assertIn('impact_law = "no-tension"', file.read())

    def test_calibrate_takes_laws_bounds_and_uncertainties(self):
        with tempfile.TemporaryDirectory() as folder:
            runs = []
            for speed in ("0.1", "0.2", "0.4"):
                runs.append(os.path.join(folder, speed))
                rimpact("reduced", "impact-window", "--set", f"excitation.speed_m_per_s={speed}", "-o", runs[-1])
            run = rimpact("calibrate", *runs, "-o", folder, "--json", "--fixed", "e=0.65", "--bounds", "k_i=1e5:1e6", "--laws",
                          "no-tension,signed", "--sigma", "force=0.02", "--starts", "2")
            self.assertEqual(run.returncode, 0, run.stderr)
            table = json.loads(run.stdout)
            self.assertEqual(list(table["parameters"]), ["k_i"])
            self.assertEqual([row["law"] for row in table["laws"]["rows"]], ["signed", "no-tension"])
            self.assertEqual(len(table["laws"]["rows"][0]["leave_one_out"]), 3)

    def test_grazing_is_not_identifiable(self):
        with tempfile.TemporaryDirectory() as folder:
            rimpact("reduced", "ricker-0.78g-1.0s", "-o", folder)
            run = rimpact("calibrate", folder, "-o", os.path.join(folder, "fit"), "--json")
            table = json.loads(run.stdout)
            self.assertFalse(table["parameters"]["k_i"]["identifiable"])

    def test_what_calibrate_writes_is_what_is_flown(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        law, runs = ["--set", "reduced.impact_law=hunt-crossley", "--set", "reduced.k_i_kN_per_m=3e5", "--set", "reduced.impact_exponent=1.3"], []
        for speed in ("0.1", "0.2", "0.4"):
            runs.append(os.path.join(folder, speed))
            rimpact("reduced", "impact-window", *law, "--set", f"excitation.speed_m_per_s={speed}", "-o", runs[-1])
        cal = os.path.join(folder, "own")
        made = rimpact("calibrate", *runs, "-o", cal)
        self.assertEqual(made.returncode, 0, made.stderr)
        peaks = []
        for out, words in (("typed", law), ("flown", ["--calibration", cal])):
            run = rimpact("reduced", "impact-window", *words, "--set", "excitation.speed_m_per_s=0.3", "-o", os.path.join(folder, out), "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            peaks.append(json.loads(run.stdout)["peak_impact_force_N"])
        self.assertAlmostEqual(peaks[1] / peaks[0], 1, places=3)
        self.assertEqual(run.stderr, "")  # the same rim, within its speeds


if __name__ == "__main__":
    unittest.main()
