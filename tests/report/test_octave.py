"""examples/octave: what read_run.m reads is in a response.h5 of the command, plain numbers; Octave itself where it is installed."""
import os
import re
import shutil
import subprocess
import unittest

import h5py
import numpy as np
from support import SOURCE, InFolder

SCRIPT = os.path.join(SOURCE, "examples", "octave", "read_run.m")
KNOWN = os.environ.get("RIMPACT_PROGRAM") or shutil.which("rimpact")


@unittest.skipUnless(KNOWN, "the command rimpact is not built")
class ReadRun(InFolder):
    def setUp(self):
        super().setUp()
        subprocess.run([KNOWN, "reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.1", "-o", self.path("run")], check=True, capture_output=True)
        shutil.copy(SCRIPT, self.folder)

    def said(self):
        """What the script prints, by h5py."""
        with h5py.File(self.path("run", "response.h5")) as file:
            force, gap, time = (file[f"response/{name}"][()] for name in ("impact_x", "gap", "time"))
        at = int(np.argmax(np.abs(force)))
        return f"{len(time)} instants, rim force up to {np.abs(force[at]) / 1e3:.1f} kN at {time[at]:.4f} s, penetration {-1e3 * gap.min():.3f} mm"

    def test_signals_are_plain_numbers_and_the_root_holds_no_text(self):
        with open(SCRIPT, encoding="utf-8") as file:
            names = re.search(r"for name = \{(.*?)\}", file.read()).group(1).replace("'", "").split(", ")
        with h5py.File(self.path("run", "response.h5")) as file:
            self.assertEqual([type(item) for item in file.values()], [h5py.Group] * len(file))
            for name in names:
                data = file[f"response/{name}"]
                self.assertEqual((data.dtype, data.ndim), (np.dtype("float64"), 1))
                self.assertIsNotNone(data.attrs["units"])
        with open(os.path.join(os.path.dirname(SCRIPT), "README.md"), encoding="utf-8") as file:
            self.assertIn(self.said(), file.read())

    @unittest.skipUnless(shutil.which("octave-cli"), "Octave is not installed")
    def test_octave_reads_it(self):
        done = subprocess.run(["octave-cli", "--no-init-file", "read_run.m"], cwd=self.folder, capture_output=True, text=True, timeout=100)
        self.assertIn(self.said(), done.stdout, done.stderr)

    @unittest.skipUnless(shutil.which("octave-cli"), "Octave is not installed")
    def test_octave_loads_it_whole(self):
        loads = "run = load('run/response.h5'); printf('%d %s\\n', numel(run.response.time), run.meta.version)"
        done = subprocess.run(["octave-cli", "--no-init-file", "--eval", loads], cwd=self.folder, capture_output=True, text=True, timeout=100)
        with h5py.File(self.path("run", "response.h5")) as file:
            self.assertIn(f"{len(file['response/time'])} {file['meta/version'][()].decode()}", done.stdout, done.stderr)

    def test_texts_have_a_length(self):
        with h5py.File(self.path("run", "response.h5")) as file:
            for name, text in file["meta"].items():
                self.assertEqual(text.dtype.kind, "S", name)


if __name__ == "__main__":
    unittest.main()
