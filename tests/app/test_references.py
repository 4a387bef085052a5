"""The reduced model with the fitted law against the stored curves of rung rigid-dish (data/references), each from its own
start: a pulse from rest. The one beyond the law's range (1 m/s) is held by its displacement alone."""
import csv
import json
import math
import pathlib
import tempfile
import unittest

from command import rimpact

REFERENCES = pathlib.Path(__file__).resolve().parents[2] / "data/references"
BEYOND = "window-1.20"


class References(unittest.TestCase):
    def test_the_displacement_at_the_end_is_that_of_the_last_row_kept(self):
        kept = sorted(path.parent for root in (REFERENCES, REFERENCES.parent / "thesis/kept") for path in root.glob("*/summary.json"))
        self.assertGreater(len(kept), 12)
        for folder in kept:
            with self.subTest(folder.name), open(folder / "response.csv", encoding="utf-8") as file:
                row = {key: float(value) for key, value in list(csv.DictReader(file))[-1].items()}
                summary = json.loads((folder / "summary.json").read_text())
                self.assertAlmostEqual(summary["residual_displacement_m"], math.hypot(row["ux_m"], row["uy_m"]), delta=1e-7)
                if "vx_m_per_s" in row:
                    self.assertAlmostEqual(summary["final_speed_m_s"], math.hypot(row["vx_m_per_s"], row["vy_m_per_s"]), delta=1e-7)

    def test_they_are_listed_with_their_cost(self):
        listed = json.loads(rimpact("references", "--list", "--json").stdout)
        self.assertEqual([row["name"] for row in listed], sorted(folder.name for folder in REFERENCES.iterdir() if folder.is_dir()))
        self.assertTrue(all(row["wall_time_s"] > 1 and row["peak_impact_force_N"] > 1e4 for row in listed))
        text = rimpact("references", "--list", "window-0.20").stdout
        self.assertIn("window-0.20", text)
        self.assertNotIn("window-0.35", text)

    def test_an_unknown_name_is_refused(self):
        run = rimpact("references", "window-0.2", "--list")
        self.assertEqual(run.returncode, 2)
        self.assertIn("did you mean window-0.20?", run.stderr)

    def test_the_law_gives_the_curves_back(self):
        law = json.loads((REFERENCES / "elastoplastic.json").read_text())
        settings = [word for key, value in law.items() for word in ("--set", f"{key}={json.dumps(value)}")]
        curves = sorted(folder for folder in REFERENCES.iterdir() if folder.is_dir())
        self.assertEqual(len(curves), 12)
        curves = [curve for curve in curves if curve.name != "pulse-bidirectional"]
        for curve in curves:
            with self.subTest(curve.name), tempfile.TemporaryDirectory() as folder:
                made = rimpact("reduced", str(curve / "scene.toml"), "-o", folder, "--quiet", *settings)
                self.assertEqual(made.returncode, 0, made.stderr)
                metrics = json.loads(rimpact("compare", str(curve), folder, "--json").stdout)
                self.assertLess(metrics["nrmse_displacement"], 0.01)
                if curve.name != BEYOND:
                    self.assertLess(abs(metrics["peak_force_error"]), 0.05)
                    self.assertLess(abs(metrics["rebound_error"]), 0.05)

    def test_the_law_of_rung_rim_predicts_solids_with_a_pad(self):
        """None of these was fitted: what the rim's own law lacks is the pad's spring below the mass, which the calibration brings."""
        law = json.loads((REFERENCES / "rim.json").read_text())
        settings = [word for key, value in law.items() for word in ("--set", f"{key}={json.dumps(value)}")]
        rigid = ["--set", "reduced.normal_force=inertia"]
        for name in ("pulse-bidirectional", "pulse-0.78g-1.05", "pulse-0.38g-1.05", "window-0.20", "window-0.35", "window-0.50"):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                rebound = {}
                for what, more in (("pad", []), ("rigid", rigid)):
                    made = rimpact("reduced", str(REFERENCES / name / "scene.toml"), "-o", f"{folder}/{what}", "--quiet", *settings, *more)
                    self.assertEqual(made.returncode, 0, made.stderr)
                    metrics = json.loads(rimpact("compare", str(REFERENCES / name), f"{folder}/{what}", "--json").stdout)
                    rebound[what] = abs(metrics["rebound_error"])
                    self.assertLess(abs(metrics["peak_force_error"]), 0.04)
                self.assertLess(rebound["pad"], 0.06)
                self.assertLess(rebound["pad"], 0.5 * rebound["rigid"])

    def test_and_predicts_the_oblique_impact_of_the_bidirectional_pulse(self):
        """From the state at its touch: what leads there is seconds of sliding in two directions, a test of another kind."""
        law = json.loads((REFERENCES / "elastoplastic.json").read_text())
        fixed = {"k_i": "reduced.k_i_kN_per_m", "yield_force": "reduced.yield_force_kN", "elastic_slip": "reduced.elastic_slip_mm"} | {
            name: "reduced." + name for name in ("hardening", "hardening_exponent", "unloading_gain", "unloading_exponent")}
        with tempfile.TemporaryDirectory() as folder:
            made = rimpact("calibrate", str(REFERENCES / "pulse-0.78g-1.05"), "--predict", str(REFERENCES / "pulse-bidirectional"), "--law", "elastoplastic",
                           "--fit", "capacity_offset", "--starts", "1", "-o", folder, "--quiet", "--fixed", *(f"{name}={law[key]}" for name, key in fixed.items()))
            self.assertEqual(made.returncode, 0, made.stderr)
            (run,) = json.loads((pathlib.Path(folder) / "calibration.json").read_text())["prediction"].values()
        (impact,) = run["impacts"]
        restitution = json.loads((REFERENCES / "pulse-bidirectional/summary.json").read_text())["impacts"][0]["restitution"]
        self.assertLess(abs(impact["peak_force_error"]), 0.05)
        self.assertLess(abs(impact["rebound_error_over_approach"]) / restitution, 0.05)


if __name__ == "__main__":
    unittest.main()
