"""Runs and tables held against references, and the example that does so with a model of its own."""
import importlib
import os
import pathlib
import sys
import unittest

import numpy as np
import rimpact

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
REFERENCES, EXAMPLE = SOURCE / "data/references", SOURCE / "examples/comparison-test"
os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]


def window(**settings):
    return rimpact.run_reduced(rimpact.Scene("impact-window", {f"reduced.{name}": value for name, value in settings.items()}))


class Comparisons(unittest.TestCase):
    def test_runs_of_this_process_are_compared_with_their_scenes(self):
        found = rimpact.compare(window(), window(k_i_kN_per_m=5e5), {"peak": 5, "rebound": 1})
        self.assertIsInstance(found, rimpact.Comparison)
        self.assertAlmostEqual(found.table.value["peak"], 100 * ((5 / 4.5) ** 0.5 - 1), delta=0.1)
        self.assertEqual(list(found.differences.key), ["reduced.k_i_kN_per_m"])
        self.assertEqual((found.table.met["peak"], found.table.met["rebound"], found.met), (False, True, False))
        with self.assertRaisesRegex(rimpact.GateError, "1 of 2 limits are not met: peak impact force"):
            found.check()
        self.assertIs(rimpact.compare(window(), window(), {"peak": 0}).check().met, True)
        self.assertIn("<table", found._repr_html_())

    def test_tables_of_any_spelling(self):
        run = window()
        bare = run.response[["displacement_x", "force_x", "impact_x"]]
        spelt = bare.rename(columns={"displacement_x": "ux_m", "force_x": "Fx_N", "impact_x": "Ix_N"}).reset_index(names="time_s")
        for table in (bare, spelt):
            found = rimpact.compare(table, run)
            np.testing.assert_allclose(found.table.value["peak"], 0, atol=1e-9)
        doubled = bare.assign(impact_x=1.1 * bare.impact_x, force_x=1.1 * bare.force_x)
        self.assertAlmostEqual(rimpact.compare(run, doubled).table.value["peak"], 10, places=6)
        with self.assertRaisesRegex(rimpact.DataError, "no column impact_x .or Ix_N."):
            rimpact.compare(run, bare.drop(columns="impact_x"))

    def test_what_is_not_known_is_nan_and_said(self):
        nothing = rimpact.run_reduced(rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": 0.2}))
        found = rimpact.compare(nothing, nothing, {"peak": 5})
        self.assertTrue(np.isnan(found.table.value["peak"]))
        self.assertIn("neither touches the rim", found.missed[0])

    def test_other_motions_and_wrong_names_raise(self):
        faster = rimpact.run_reduced(rimpact.Scene("impact-window", {"excitation.speed_m_per_s": 0.2}))
        with self.assertRaisesRegex(rimpact.InputError, "excitation.speed_m_per_s"):
            rimpact.compare(window(), faster)
        self.assertGreater(rimpact.compare(window(), faster, anyway=True).table.value["peak"], 50)
        with self.assertRaisesRegex(rimpact.InputError, "did you mean"):
            rimpact.compare(window(), window(), {"peek": 5})


class Example(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(EXAMPLE))
        cls.addClassCleanup(sys.path.remove, str(EXAMPLE))
        cls.tests, cls.model = importlib.import_module("test_my_model"), importlib.import_module("my_model")

    def test_its_model_meets_the_kept_runs(self):
        cases = [function for name, function in vars(self.tests).items() if name.startswith("test_")]
        self.assertGreaterEqual(len(cases), 3)
        for case in cases:
            with self.subTest(case.__name__):
                case()

    def test_and_a_worse_model_does_not(self):
        for number, worse in (("STIFFNESS", 1.1), ("UNLOADING", 0.5)):
            kept = getattr(self.model, number)
            self.addCleanup(setattr, self.model, number, kept)
            setattr(self.model, number, worse * kept)
            with self.subTest(number), self.assertRaisesRegex(rimpact.GateError, "peak|rebound"):
                self.tests.test_an_impact_as_earthquakes_bring_it()
            setattr(self.model, number, kept)


if __name__ == "__main__":
    unittest.main()
