"""The slide out to the rim is made once a bearing, mesh and direction: later windows take it, and come out as if they had not."""
import json
import os
import pathlib
import shutil
import tempfile
import unittest

import h5py
from command import rimpact

# A millisecond behind the touch: what is compared is the way there and the first contact.
WINDOW = ["run", "impact-window", "--rung", "rigid-dish", "--set", "model.mesh=0", "--set", "excitation.duration_s=0.001",
          "--set", 'excitation.with=["weight","friction"]', "--no-fields", "--quiet"]


def run(folder, speed, *more):
    result = rimpact(*WINDOW, "--set", f"excitation.speed_m_per_s={speed}", "-o", folder, *more)
    assert result.returncode == 0, result.stderr
    return json.loads(pathlib.Path(folder, "summary.json").read_text())["solver_work"]["newton_iterations"]


def forces(folder):
    with h5py.File(os.path.join(folder, "response.h5")) as file:
        return {name: file["response"][name][:].tolist() for name in ("time", "impact_x", "force_x", "displacement_z")}


class KeptSlide(unittest.TestCase):
    def test_second_window_takes_it(self):
        with tempfile.TemporaryDirectory() as folder:
            first = run(os.path.join(folder, "one", "first"), 0.3)
            second = run(os.path.join(folder, "one", "second"), 0.5)
            alone = run(os.path.join(folder, "other", "second"), 0.5)
            self.assertLess(second, alone - 50)  # of Newton's iterations
            self.assertLess(second, first)
            self.assertEqual(forces(os.path.join(folder, "one", "second")), forces(os.path.join(folder, "other", "second")))

    def test_never_of_another_bearing_or_damaged(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = run(os.path.join(folder, "first"), 0.5)
            kept = list(pathlib.Path(folder, "slid-out").iterdir())
            self.assertEqual(len(kept), 1)
            run(os.path.join(folder, "smoother"), 0.5, "--set", "bearing.contact.steel_ertalyte=0.06")
            self.assertEqual(len(list(pathlib.Path(folder, "slid-out").iterdir())), 2)
            shutil.rmtree(os.path.join(folder, "first"))
            kept[0].write_bytes(kept[0].read_bytes()[:-1000])
            self.assertEqual(run(os.path.join(folder, "first"), 0.5), alone)


if __name__ == "__main__":
    unittest.main()
