"""rimpact references makes a kept reference again: the touch of 0.07 m/s moves by less than the solver's settings leave."""
import json
import os
import tempfile
import unittest

from command import rimpact


class ReferencesAgain(unittest.TestCase):
    def test_the_lightest_window(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("references", "window-0.07", "-o", folder, "--json", "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)
            row, = json.loads(run.stdout)
            self.assertLess(abs(row["peak_force_error"]), 0.005)
            self.assertLess(abs(row["rebound_error"]), 0.02)
            self.assertLess(abs(row["imbalance_relative"]), 1e-3)
            self.assertTrue(os.path.isfile(os.path.join(folder, "window-0.07", "response.h5")))


if __name__ == "__main__":
    unittest.main()
