"""Damaged checkpoints and early ends of rung rigid-dish, on the draft mesh; as test_checkpoints.py of rung rim."""
import os
import tempfile
import unittest

import numpy as np
from checkpoints import copy_of, every_field, numbers, replace, with_entry
from command import rimpact
from test_checkpoints import contents, steps_kept, until

SLIDE = ["run", "static-unidirectional", "--mesh", "0", "--set", "excitation.amplitude_m=0.05", "--quiet", "--no-fields"]


class RigidDish(unittest.TestCase):
    def test_every_field_is_checked(self):
        with tempfile.TemporaryDirectory() as temporary:
            half = os.path.join(temporary, "half")
            code, errors = until(half, lambda folder: steps_kept(folder, 10), *SLIDE)
            self.assertEqual(code, 130, errors)
            kept = numbers(os.path.join(half, "checkpoint.h5"))
            cases = [case for case in every_field(kept) if not case[0].startswith("response_") or case[0] == "response_force_x"]
            cases += [("reached", "beyond", [1.5]), ("contact0_status", "5", with_entry(kept["contact0_status"], 0, 5)),
                      ("contact0_gap", "nan", with_entry(kept["contact0_gap"], 0, np.nan)), ("contact0_stiffening", "0", [0.0])]
            for name, what, values in cases:
                with self.subTest(field=name, what=what):
                    folder = copy_of(half, "field")
                    replace(os.path.join(folder, "checkpoint.h5"), name, values)
                    before = contents(folder)
                    run = rimpact(*SLIDE, "-o", folder, "--resume")
                    self.assertEqual(run.returncode, 3, run.stderr)
                    self.assertEqual(run.stderr.count("error: "), 1, run.stderr)
                    self.assertIn("is damaged (field ", run.stderr)
                    self.assertEqual(contents(folder), before)  # what there is is kept
            run = rimpact(*SLIDE, "-o", half, "--resume")
            self.assertEqual(run.returncode, 0, run.stderr)


if __name__ == "__main__":
    unittest.main()
