"""The main job with a stand-in for the finite elements (stand_in_fe.py): what it runs, keeps, says and writes."""
import json
import os
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
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = os.path.join(self.temporary.name, "main")
        self.log = os.path.join(self.temporary.name, "calls")

    def environment(self, **more):
        return {"RIMPACT_FE_PROGRAM": STAND_IN, "STAND_IN_LOG": self.log, **more}

    def main(self, *arguments, **more):
        return rimpact("main", *arguments, "-o", self.folder, **self.environment(**more))

    def calls(self):
        if not os.path.exists(self.log):
            return []
        with open(self.log) as file:
            return file.read().splitlines()

    def test_the_references_pair_is_found_and_everything_is_written(self):
        run = self.main("--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        table = json.loads(run.stdout)
        self.assertAlmostEqual(table["parameters"]["k_i"]["value"] / 2.0e5, 1, places=4)
        self.assertAlmostEqual(table["parameters"]["e"]["value"], 0.4, places=4)
        self.assertTrue(os.path.getsize(table["report"]) > 10000)
        main = read(self.folder, "main.json")
        self.assertEqual(len(main["runs"]), N_RUNS)
        self.assertEqual({run["role"] for run in main["runs"]}, {"fit", "predict", "window"})
        self.assertEqual(main["warnings"], [])
        self.assertEqual(main["versions"]["rimpact"], "stand-in")
        for row in main["comparison"]:
            self.assertLess(abs(row["fitted_error"]), 1e-3)
        for pulse in main["critical_amplitudes"]:  # both pulses only graze the rim at the printed amplitudes
            self.assertLess(abs(pulse["reduced_g"] / pulse["printed_g"] - 1), 0.003)

    def test_done_runs_are_kept_unless_the_bearing_changes(self):
        self.assertEqual(self.main("--quiet").returncode, 0)
        self.assertEqual(len(self.calls()), N_RUNS)
        again = self.main()
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(len(self.calls()), N_RUNS)
        self.assertIn("already done, kept", again.stderr)
        self.assertIn("report: " + self.folder, again.stdout)
        self.assertEqual(self.main("fps-225", "--quiet").returncode, 0)
        self.assertEqual(len(self.calls()), 2 * N_RUNS)

    def test_a_failing_run_does_not_lose_the_others(self):
        run = self.main("--quiet", STAND_IN_FAIL="window-0.20")
        self.assertEqual(run.returncode, 4)
        self.assertIn("window-0.20: the solver stopped because the test asked for it", run.stderr)
        self.assertEqual(len(read(self.folder, "main.json")["comparison"]), N_RUNS - 1)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "report.html")))
        self.assertTrue(os.path.exists(os.path.join(self.folder, "calibration", "calibration.json")))

    def test_an_interruption_stops_the_children_and_can_be_taken_up(self):
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
        run = self.main("--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)

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
