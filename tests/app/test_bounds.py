"""--bounds of reduced and building: runs, table, files and exit codes; what finite elements refuse of friction and integrators."""
import csv
import json
import pathlib
import tempfile
import unittest

from command import rimpact


class Bounds(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = self.temporary.name + "/bounds"

    def test_a_table_of_three_runs(self):
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "lower,upper", "-o", self.folder, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        table = json.loads(run.stdout)
        self.assertEqual([one["bound"] for one in table["runs"]], ["nominal", "lower", "upper"])
        self.assertAlmostEqual(table["runs"][1]["lambda"], 0.7 * 0.85)
        self.assertAlmostEqual(table["runs"][2]["lambda"], 1.42 * 1.3 * 1.15)
        self.assertEqual(table["factors"], {"standard": "asce-7-22", "assumed": True, "lambda_ae_max": 1.56, "lambda_ae_min": 1, "lambda_test_max": 1.3,
                                            "lambda_test_min": 0.7, "lambda_spec_max": 1.15, "lambda_spec_min": 0.85})
        self.assertIn("assumption", table["origin"])
        rows = {row["quantity"]: row["values"] for row in table["rows"]}
        self.assertGreater(rows["peak displacement"]["lower"], rows["peak displacement"]["upper"])
        with open(self.folder + "/bounds.csv", newline="") as file:
            written = {row["quantity"]: row for row in csv.DictReader(file)}
        self.assertAlmostEqual(float(written["peak displacement"]["lower"]), rows["peak displacement"]["lower"], 6)
        for bound in ("nominal", "lower", "upper"):
            self.assertTrue((pathlib.Path(self.folder) / bound / "summary.json").exists())
        # A bound's folder runs again by itself, and is the run with that friction.
        again = rimpact("reduced", self.folder + "/lower/scene.toml", "-o", self.folder + "/again", "--json")
        self.assertAlmostEqual(json.loads(again.stdout)["peak_displacement_m"] * 1e3, rows["peak displacement"]["lower"], 6)

    def test_factors_of_ones_own(self):
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "upper", "-o", self.folder, "--set", "bounds.lambda_max=1.25")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("upper x 1.25", run.stdout)
        self.assertNotIn("lower", run.stdout)
        self.assertNotIn("assumption", run.stdout)
        factors = json.loads(pathlib.Path(self.folder, "bounds.json").read_text())["factors"]
        self.assertEqual(factors["lambda_max"], 1.25, "the factor itself, which took the place of the products")
        self.assertFalse(factors["assumed"])

    def test_factors_of_the_european_standard(self):
        given = {"lambda_ageing": 1.2, "lambda_temperature": 1.1, "lambda_contamination": 1.1, "lambda_travel": 1, "lambda_combination": 0.7}
        words = [word for key, value in given.items() for word in ("--set", f"bounds.{key}={value}")]
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "upper", "-o", self.folder, "--json", "--set", 'bounds.standard="en-15129"', *words)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(json.loads(run.stdout)["factors"],
                         {"standard": "en-15129", "assumed": False, "lambda_spec_max": 1.15, "lambda_spec_min": 0.85, **given})

    def test_factors_that_are_not_given_are_null(self):
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "upper", "-o", self.folder, "--json", "--set", 'bounds.standard="en-15129"',
                      "--set", "bounds.lambda_max=1.4")
        self.assertEqual(run.returncode, 0, run.stderr)
        factors = json.loads(run.stdout)["factors"]
        self.assertIsNone(factors["lambda_ageing"])
        self.assertEqual(factors["lambda_max"], 1.4)

    def test_a_building(self):
        run = rimpact("building", "ricker-0.78g-1.0s", "--bounds", "lower", "-o", self.folder, "--set", "excitation.scale=0.3", "--set",
                      "excitation.duration_s=4", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("storey drift", [row["quantity"] for row in json.loads(run.stdout)["rows"]])

    def test_wrong_words_and_stopped_runs(self):
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "highest", "-o", self.folder)
        self.assertEqual(run.returncode, 2)
        self.assertIn("--bounds highest is none of nominal, lower, upper", run.stderr)
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "lower", "-o", self.folder, "--set", "bounds.lambda_min=2.5")
        self.assertEqual(run.returncode, 2)
        run = rimpact("reduced", "ricker-0.78g-1.0s", "--bounds", "lower", "-o", self.folder, "--set", "reduced.k_i_kN_per_m=0", "--set",
                      "excitation.scale=3")
        self.assertEqual(run.returncode, 4)
        self.assertIn("left the dish", run.stderr)


class Refusals(unittest.TestCase):
    def refused(self, *words: str) -> str:
        run = rimpact(*words)
        self.assertEqual(run.returncode, 2, run.stderr)
        return run.stderr

    def test_finite_elements_have_steps_of_their_own(self):
        for verb in ("run", "main", "check"):
            with self.subTest(verb=verb):
                self.assertIn('reduced.integrator "cvode"', self.refused(verb, "ricker-0.78g-1.0s", "--set", 'reduced.integrator="cvode"',
                                                                           *(["--dry-run"] if verb != "check" else [])))

    def test_finite_elements_carry_no_heat(self):
        self.assertIn("reduced.mu_by_temperature", self.refused("run", "ricker-0.78g-1.0s", "--dry-run", "--set", "reduced.mu_by_temperature=true"))

    def test_solids_take_the_bearings_friction(self):
        for setting in ("reduced.mu_scale=1.2", "reduced.mu_reference_pressure_MPa=20"):
            with self.subTest(setting=setting):
                said = self.refused("run", "ricker-0.78g-1.0s", "--rung", "rigid-dish", "--dry-run", "--set", setting)
                self.assertIn("bearing.contact", said)

    def test_a_quasi_static_motion_has_no_heat(self):
        self.assertIn("needs a motion in time", self.refused("reduced", "static-unidirectional", "--set", "reduced.mu_by_temperature=true"))


if __name__ == "__main__":
    unittest.main()
