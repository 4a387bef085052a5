"""The study with a stand-in for the finite elements (stand_in_fe.py): what is run, kept, written, and its gate."""
import csv
import json
import os
import shutil
import tempfile
import unittest

from command import rimpact

STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in_fe.py")


class Study(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder, self.log = os.path.join(temporary.name, "study"), os.path.join(temporary.name, "calls")

    def study(self, *arguments):
        return rimpact("study", "impact-window", "-o", self.folder, *arguments, RIMPACT_FE_PROGRAM=STAND_IN,
                       STAND_IN_LOG=self.log)

    def calls(self):
        with open(self.log) as file:
            return len(file.read().splitlines())

    def test_axes_make_the_runs_and_nothing_is_run_twice(self):
        run = self.study("--axes", "rung,mesh,step", "--meshes", "1,2", "--steps", "1,0.5", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = json.loads(run.stdout)["rows"]
        self.assertEqual({row["name"] for row in rows},
                         {"reduced", "rim-mesh1-1ms", "rim-mesh1-0.5ms", "rim-mesh2-1ms", "rim-mesh2-0.5ms"})
        self.assertEqual([row["name"] for row in rows if row["reference"]], ["rim-mesh2-0.5ms"])
        self.assertEqual(self.calls(), 4)
        self.assertEqual(self.study("--axes", "rung,mesh,step", "--meshes", "1,2", "--steps", "1,0.5").returncode, 0)
        self.assertEqual(self.calls(), 4)
        with open(os.path.join(self.folder, "study.csv")) as file:
            self.assertEqual(len(list(csv.DictReader(file))), 5)
        for name in ("study.txt", "study.png"):
            self.assertGreater(os.path.getsize(os.path.join(self.folder, name)), 100)

    def test_the_reduced_runs_name_their_element(self):
        curve = os.path.join(os.path.dirname(self.folder), "curve.h5")
        shutil.copy(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data/reliability/frame-four-dof-rim.h5"), curve)
        run = self.study("--axes", "rung", "--error", "900", "--set", "bearing.slider.diameter_mm=220.0", "--curve", curve, "--json")  # the curve's own rim
        self.assertEqual(run.returncode, 0, run.stderr)
        study = json.loads(run.stdout)
        elements = {row["name"]: row["element"] for row in study["rows"]}
        self.assertIn("k_i = 450000 kN/m, e = 0.65", elements["reduced"])
        self.assertEqual(elements["curve"], f"curve, {curve}")
        self.assertEqual(elements["rim-mesh1"], "")
        self.assertIn("--curve", study["command"])
        self.assertIn("commit", study["made_by"])
        with open(os.path.join(self.folder, "study.txt"), encoding="utf-8") as file:
            self.assertIn("reduced: signed, k_i = 450000 kN/m", file.read())
        self.assertEqual(self.study("--axes", "rung", "--rungs", "rim,full", "--curve", curve).returncode, 2)
        run = rimpact("study", "impact-window", "--axes", "rung", "--rungs", "reduced", "--error", "900", "--set", "bearing.slider.diameter_mm=220.0", "--curve", curve,
                      "-o", self.folder + "-reduced", "--json")
        self.assertEqual([row["name"] for row in json.loads(run.stdout)["rows"] if row["reference"]], ["curve"])  # whichever was faster

    def test_a_reduced_run_that_stops_is_named(self):
        curve = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data/reliability/frame-four-dof-rim.h5")
        run = self.study("--axes", "rung", "--error", "900", "--set", "bearing.slider.diameter_mm=220.0", "--set", "excitation.speed_m_per_s=3",
                         "--curve", curve, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("curve stopped and is not in the table: ", run.stderr)
        self.assertEqual({row["name"] for row in json.loads(run.stdout)["rows"]}, {"reduced", "rim-mesh1"})

    def test_shards_add_up(self):
        first = self.study("--shard", "1/3")
        self.assertEqual(first.returncode, 0, first.stderr)
        for part in ("2/3", "3/3"):
            last = self.study("--shard", part)
        self.assertEqual(last.returncode, 0, last.stderr)
        self.assertEqual(self.calls(), 2)

    def test_a_wanted_error_that_nothing_reaches_is_a_gate(self):
        run = self.study("--axes", "rung", "--error", "0.001")
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("0.001 %", run.stderr)

    def test_bad_words_are_refused(self):
        for words, said in ((["--axes", "mush"], "mush"), (["--rungs", "rime"], "rime"), (["--rungs", "reduced,reduced"], "once"), (["--steps", "nan"], "nan"), (["--meshes", "4"], "4"),
                            (["--shard", "0/2"], "--shard 0/2"), (["--error", "-1"], "-1"),
                            (["--axes", "rung", "--rungs", "reduced"], "two runs")):
            run = self.study(*words)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)


if __name__ == "__main__":
    unittest.main()
