"""Run by the Python of an environment that holds the pip package, in a folder of its own: what `import rimpact` gives there."""
import importlib.metadata
import os
import unittest

import h5py
import numpy as np
import rimpact
from rimpact import program

HERE = os.path.dirname(os.path.abspath(rimpact.__file__))
REFERENCES = os.path.join(HERE, "share", "rimpact", "data", "references")
#: All built in: none needs a record.
SCENES = {"impact-window": {}, "ricker-0.78g-1.0s": {"excitation.scale": 1.05}, "pulse-bidirectional": {}, "lir-dcfp-stages": {}, "shear-building": {}}


class Inside(unittest.TestCase):
    def test_its_version_and_program_are_the_packages(self):
        self.assertEqual(importlib.metadata.version("rimpact"), rimpact.__version__)
        self.assertEqual(program.path(), os.path.join(HERE, "bin", "rimpact"))
        self.assertEqual(program.run("--version"), f"rimpact {rimpact.__version__}\n")

    def test_runs_here_are_the_programs_to_the_last_bit(self):
        for name, settings in SCENES.items():
            words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
            program.run("reduced", name, *words, "-o", f"bits-{name}", "--quiet")
            flown = rimpact.run_reduced(rimpact.Scene(name, settings))
            with h5py.File(f"bits-{name}/response.h5", "r") as file:
                self.assertEqual(set(file["response"]) - {"time"}, set(flown.response))
                for signal in flown.response:
                    np.testing.assert_array_equal(file["response"][signal][:], flown.response[signal], f"{name}: {signal}")
            self.assertEqual(rimpact.load(f"bits-{name}").summary["impacts"], flown.summary["impacts"])

    def test_a_calibration_gives_a_law(self):
        runs = [os.path.join(REFERENCES, name) for name in ("window-0.10", "window-0.20", "window-0.35")]
        fitted = rimpact.calibrate(runs, "fitted", laws="elastoplastic")
        self.assertEqual(fitted.answer["law"]["name"], "elastoplastic")
        self.assertGreater(rimpact.law(fitted)(2e-3), 1e4)

    def test_a_verb_of_finite_elements_is_an_input_error(self):
        with self.assertRaisesRegex(rimpact.InputError, "no finite-element side"):
            program.run("run", "impact-window")


if __name__ == "__main__":
    unittest.main()
