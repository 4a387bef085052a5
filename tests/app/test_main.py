"""The main job with a stand-in for the finite elements (stand_in_fe.py): what it runs, keeps, says and writes."""
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from command import RIMPACT, rimpact

STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in_fe.py")
N_RUNS = 12


def read(*path):
    with open(os.path.join(*path)) as file:
        return json.load(file)


class Main(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.done = os.path.join(cls.shared.name, "main")
        cls.first = rimpact("main", "--json", "--laws", "signed,no-tension", "-o", cls.done, RIMPACT_FE_PROGRAM=STAND_IN)

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = os.path.join(self.temporary.name, "main")
        self.log = os.path.join(self.temporary.name, "calls")

    def environment(self, **more):
        return {"RIMPACT_FE_PROGRAM": STAND_IN, "STAND_IN_LOG": self.log, **more}

    def main(self, *arguments, **more):
        return rimpact("main", *arguments, "--laws", "none", "-o", self.folder, **self.environment(**more))

    def calls(self):
        if not os.path.exists(self.log):
            return []
        with open(self.log) as file:
            return file.read().splitlines()

    def test_the_references_pair_is_found_and_everything_is_written(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        table = json.loads(self.first.stdout)
        self.assertAlmostEqual(table["parameters"]["k_i"]["value"] / 2.0e5, 1, places=4)
        self.assertAlmostEqual(table["parameters"]["e"]["value"], 0.4, places=4)
        self.assertGreater(os.path.getsize(table["report"]), 10000)
        main = read(self.done, "main.json")
        self.assertEqual(len(main["runs"]), N_RUNS)
        self.assertEqual({run["role"] for run in main["runs"]}, {"fit", "predict", "window"})
        self.assertEqual(main["warnings"], [])
        self.assertEqual(main["versions"]["rimpact"], "stand-in")
        for row in main["comparison"]:
            self.assertLess(abs(row["fitted_error"]), 1e-3)
        for pulse in main["critical_amplitudes"]:  # both pulses only graze the rim at the printed amplitudes
            self.assertLess(abs(pulse["reduced_g"] / pulse["printed_g"] - 1), 0.003)

    def test_done_runs_are_kept_and_an_interrupted_one_goes_on(self):
        shutil.copytree(self.done, self.folder)
        run_folder = os.path.join(self.folder, "runs", "window-0.20")
        summary = read(run_folder, "summary.json")
        with open(os.path.join(run_folder, "summary.json"), "w") as file:
            json.dump({**summary, "status": "interrupted"}, file)
        with open(os.path.join(run_folder, "checkpoint.h5"), "w"):
            pass
        run = self.main()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr.count("already done, kept"), N_RUNS - 1)
        self.assertEqual(len(self.calls()), 1)
        self.assertIn("window-0.20", self.calls()[0])
        self.assertIn("--resume", self.calls()[0])
        self.assertIn("report: " + self.folder, run.stdout)

    def test_another_bearing_runs_afresh_and_total_failure_is_said(self):
        shutil.copytree(self.done, self.folder)
        run = self.main("fps-225", "--quiet", STAND_IN_FAIL="*")
        self.assertEqual(run.returncode, 4)
        self.assertIn("no run of the main job ended well", run.stderr)
        self.assertEqual(len(self.calls()), N_RUNS)

    def test_a_failing_run_does_not_lose_the_others(self):
        shutil.copytree(self.done, self.folder)
        shutil.rmtree(os.path.join(self.folder, "runs", "window-0.20"))
        run = self.main("--quiet", STAND_IN_FAIL="window-0.20")
        self.assertEqual(run.returncode, 4)
        self.assertIn("window-0.20: the solver stopped because the test asked for it", run.stderr)
        self.assertEqual(len(read(self.folder, "main.json")["comparison"]), N_RUNS - 1)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "report.html")))
        self.assertTrue(os.path.exists(os.path.join(self.folder, "calibration", "calibration.json")))

    def test_an_interruption_stops_the_children(self):
        process = subprocess.Popen([RIMPACT, "main", "-o", self.folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, env={**os.environ, **self.environment(STAND_IN_SLEEP="60")})
        while not self.calls():
            time.sleep(0.05)
        started = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130)
        self.assertLess(time.monotonic() - started, 20)  # the children sleep for a minute: they were told
        self.assertIn("interrupted; the same command goes on", errors)

    def test_pulses_that_miss_the_rim_are_said_and_not_fitted(self):
        bearing = os.path.join(self.temporary.name, "wide.toml")
        with open(bearing, "w") as file:
            file.write("[slider]\ndiameter_mm = 200.0\n")
        run = self.main(bearing)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("the rim is never touched", run.stderr)
        row = [row for row in read(self.folder, "main.json")["comparison"] if row["name"] == "ricker-0.78g-1.0s-x1.00"][0]
        self.assertIsNone(row["fitted_error"])

    def test_without_a_finite_element_program_nothing_is_started(self):
        run = rimpact("main", "-o", self.folder, RIMPACT_FE_PROGRAM="/nonexistent")
        self.assertEqual(run.returncode, 2)
        self.assertIn("no finite-element side", run.stderr)
        self.assertFalse(os.path.exists(self.folder))
        run = rimpact("main", "-o", self.folder, RIMPACT_FE_PROGRAM="/bin/false")
        self.assertEqual(run.returncode, 6)
        self.assertIn("does not start", run.stderr)

    def test_bad_bearing_and_folder(self):
        self.assertEqual(self.main("nowhere.toml").returncode, 2)
        run = rimpact("main", "-o", "/proc/nowhere", **self.environment())
        self.assertEqual(run.returncode, 6)
        self.assertEqual(self.calls(), [])


if __name__ == "__main__":
    unittest.main()
