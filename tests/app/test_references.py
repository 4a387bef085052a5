"""The reduced model with the fitted law against the stored curves of rung rigid-dish (calibration/references), each from its own
start: a pulse from rest. The grazing windows and the one beyond the law's range (1 m/s) are held by their displacement alone."""
import json
import pathlib
import tempfile
import unittest

from command import rimpact

REFERENCES = pathlib.Path(__file__).resolve().parents[2] / "calibration/references"
WELL_CONDITIONED = ("pulse", "window-0.20", "window-0.35", "window-0.50", "window-0.70", "window-1.00")


class References(unittest.TestCase):
    def test_the_law_gives_the_curves_back(self):
        law = json.loads((REFERENCES / "elastoplastic.json").read_text())
        settings = [word for key, value in law.items() for word in ("--set", f"{key}={json.dumps(value)}")]
        curves = sorted(folder for folder in REFERENCES.iterdir() if folder.is_dir())
        self.assertEqual(len(curves), 12)
        for curve in curves:
            with self.subTest(curve.name), tempfile.TemporaryDirectory() as folder:
                made = rimpact("reduced", str(curve / "scene.toml"), "-o", folder, "--quiet", *settings)
                self.assertEqual(made.returncode, 0, made.stderr)
                metrics = json.loads(rimpact("compare", str(curve), folder, "--json").stdout)
                self.assertLess(metrics["nrmse_displacement"], 0.01)
                if curve.name.startswith(WELL_CONDITIONED):
                    self.assertLess(abs(metrics["peak_force_error"]), 0.05)
                    self.assertLess(abs(metrics["rebound_error"]), 0.05)


if __name__ == "__main__":
    unittest.main()
