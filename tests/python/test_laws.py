"""Laws as functions, and calibrations of the stored reference runs."""
import os
import tempfile
import unittest
import warnings

import numpy as np
import rimpact

REFERENCES = os.path.join(os.environ["RIMPACT_SOURCE"], "data", "references")
os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]


def scene(law, **reduced):
    return rimpact.Scene("impact-window", {"reduced.impact_law": law, **{f"reduced.{name}": value for name, value in reduced.items()}})


class Laws(unittest.TestCase):
    def test_spring_and_dashpot(self):
        law = rimpact.law(scene("signed", k_i_kN_per_m=4.5e5, restitution=0.65))
        ratio = -np.log(0.65) / np.hypot(np.pi, np.log(0.65))
        damping = 2 * ratio * np.sqrt(4.5e8 * law.scene.mass)  # (2-20)
        self.assertAlmostEqual(law.numbers["damping_N_s_per_m"], damping, delta=1e-9 * damping)
        self.assertAlmostEqual(law(1e-3, 0.2), 4.5e8 * 1e-3 + damping * 0.2, delta=1e-3)
        self.assertEqual(law(-1e-3), 0)

    def test_a_rim_that_yields_follows_its_loading_and_keeps_a_dent(self):
        law = rimpact.law(scene("elastoplastic", k_i_kN_per_m=1e6, yield_force_kN=900, hardening=0.15))
        self.assertIsInstance(law, rimpact.Law)
        self.assertTrue(law.yields)
        self.assertAlmostEqual(law(1e-7), 1e9 * 1e-7, delta=1e-3)  # the first slope is k_i
        self.assertGreater(law(3e-3), law(2e-3))
        self.assertLess(law(2e-3, deepest=3e-3), law(2e-3))
        way = np.concatenate([np.linspace(0, 3e-3, 50), np.linspace(3e-3, 0, 50)])
        force = law.path(way)
        np.testing.assert_array_equal(force[:50], law(way[:50]))
        self.assertEqual(force[-1], 0)
        self.assertGreater(way[50:][force[50:] == 0].max(), 1e-4)  # a dent stays

    def test_beyond_the_depth_that_is_known_a_warning_names_the_bound(self):
        spring = {"k_i_kN_per_m": 4e5, "restitution": 1.0}
        fitted = rimpact.law(scene("signed", **spring, fitted_to_m_per_s=0.35))
        depth = 0.35 * np.sqrt(fitted.scene.mass / 4e8)  # of a spring
        self.assertAlmostEqual(fitted.known_depth[0], depth, delta=2e-5)
        unknown = rimpact.law(scene("signed", **spring))
        thickness = 0.040
        self.assertEqual(unknown.known_depth[0], thickness)
        for law, bound in ((fitted, depth), (unknown, thickness)):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                law(0.99 * bound), law([0.0, np.nan, 0.99 * bound]), law.path([0.0, 0.99 * bound])
            for beyond in (lambda f: f(2.0), lambda f: f([1e-4, 2.0]), lambda f: f(1e-4, deepest=2.0), lambda f: f.path([0.0, 2.0])):
                with self.assertWarnsRegex(UserWarning, rf"2000 mm lies beyond {1e3 * law.known_depth[0]:.4g} mm.*in metres") as told:
                    beyond(law)
                self.assertEqual(told.filename, __file__)

    def test_a_nan_stays_one(self):
        law = rimpact.law(scene("elastoplastic", k_i_kN_per_m=1e6, yield_force_kN=900, hardening=0.15))
        self.assertTrue(np.isnan(law(np.nan)))
        self.assertTrue(np.isnan(law(1e-3, np.nan)))
        np.testing.assert_array_equal(np.isnan(law([1e-3, np.nan, -1e-3])), [False, True, False])

    def test_a_file_is_no_folder_of_a_calibration(self):
        with self.assertRaisesRegex(rimpact.DataError, "is no folder with a calibration.json"):
            rimpact.law(__file__)

    def test_every_law_but_the_curve_can_be_called(self):
        for name in ("signed", "no-tension", "printed", "hunt-crossley", "elastoplastic", "bilinear"):
            self.assertGreater(rimpact.law(scene(name))(1e-3, 0.1), 0, name)

    def test_reference_windows_give_a_law_that_meets_them(self):
        with tempfile.TemporaryDirectory() as folder:
            windows = [os.path.join(REFERENCES, f"window-{speed}") for speed in ("0.10", "0.20", "0.35", "0.50")]
            made = rimpact.calibrate(windows, os.path.join(folder, "fit"), law="elastoplastic", laws="none")
            self.assertEqual(made.answer["law"]["name"], "elastoplastic")
            self.assertIn("elastoplastic", made.sentence)
            self.assertIn("k_i", made.parameters.index)
            law = rimpact.law(made)
            self.assertAlmostEqual(law.numbers["stiffness_N_per_m"], 1e3 * made.parameters.value["k_i"], delta=1)
            for window in windows:
                run = rimpact.load(window)
                deepest, peak = run.impacts.peak_penetration_m[0], run.impacts.peak_force_N[0]
                self.assertAlmostEqual(law(deepest), peak, delta=0.06 * peak, msg=window)
            settings = {"reduced.calibration": str(made.folder), "excitation.speed_m_per_s": 0.35,
                        "excitation.with": ["weight", "friction"]}  # as the kept window had it
            flown = rimpact.summarise(rimpact.Scene("impact-window", settings))["peak_impact_force_N"]
            known = rimpact.load(windows[2]).summary["peak_impact_force_N"]
            self.assertAlmostEqual(flown, known, delta=0.05 * known)

    def test_what_the_command_refuses_is_raised(self):
        with self.assertRaises(rimpact.DataError):
            rimpact.calibrate([os.path.join(REFERENCES, "nowhere")])
        with self.assertRaisesRegex(rimpact.DataError, "calibration.json"):
            rimpact.law(REFERENCES)


if __name__ == "__main__":
    unittest.main()
