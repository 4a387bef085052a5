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

    def main(self, *arguments, report=False, **more):
        words = [*arguments, *([] if report else ["--no-report"])]
        return rimpact("main", *words, "--laws", "none", "-o", self.folder, **self.environment(**more))

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
            self.assertIsNotNone(row["published_error"])  # this is the thesis's bearing under its mass
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
        run = self.main(report=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr.count("already done, kept"), N_RUNS - 1)
        self.assertEqual(len(self.calls()), 1)
        self.assertIn("window-0.20", self.calls()[0])
        self.assertIn("--resume", self.calls()[0])
        self.assertIn("report: " + self.folder, run.stdout)

    def kill(self, name):
        """Leaves what a run has that was killed in its course."""
        run_folder = os.path.join(self.folder, "runs", name)
        for file in ("summary.json", "response.h5"):
            os.remove(os.path.join(run_folder, file))
        with open(os.path.join(run_folder, "checkpoint.h5"), "w"):
            pass

    def test_a_killed_run_goes_on_or_where_its_checkpoint_is_refused_begins_anew(self):
        shutil.copytree(self.done, self.folder)
        self.kill("window-0.20")
        run = self.main()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("window-0.20: was killed, goes on from its checkpoint", run.stderr)
        self.assertEqual([call.split()[-1] for call in self.calls()], ["--resume"])
        self.kill("window-0.20")
        run = self.main(STAND_IN_REFUSE="1")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("checkpoint.h5 belongs to another run: the test says so\n", run.stderr)
        self.assertEqual([call.split()[-1] for call in self.calls()], ["--resume", "--resume", "--force"])

    def test_another_bearing_runs_afresh_and_total_failure_is_said(self):
        shutil.copytree(self.done, self.folder)
        refused = self.main("fps-225", "--quiet")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("of another scene", refused.stderr)
        self.assertEqual(self.calls(), [])
        run = self.main("fps-225", "--quiet", "--force", report=True, STAND_IN_FAIL="*")
        self.assertEqual(run.returncode, 4)
        self.assertIn("no run of the main job ended well", run.stderr)
        self.assertEqual(len(self.calls()), N_RUNS)

    def test_a_failing_run_does_not_lose_the_others(self):
        shutil.copytree(self.done, self.folder)
        shutil.rmtree(os.path.join(self.folder, "runs", "window-0.20"))
        run = self.main("--quiet", report=True, STAND_IN_FAIL="window-0.20")
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

    def test_pulses_that_cannot_reach_the_rim_are_left_out(self):
        run = self.main("--set", "reduced.mu_fast=2", "--set", "reduced.mu_slow=2")
        self.assertEqual(run.returncode, 0, run.stderr)
        sentence = "ricker-0.38g-1.5s is left out: no scale up to 3 takes the slider to the rim"
        self.assertIn(sentence, run.stderr)
        self.assertNotIn("report: ", run.stdout)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "report.html")), "--no-report")
        main = read(self.folder, "main.json")
        self.assertIn(sentence, main["warnings"])
        self.assertEqual([row["name"] for row in main["runs"] if row["name"].startswith("ricker-0.38g")], [])

    def own_bearing(self):
        path = os.path.join(self.temporary.name, "own.toml")
        with open(path, "w") as file:
            file.write('name = "own"\n[slider]\ndiameter_mm = 200.0\n[rim]\nthickness_mm = 50.0\n')
        return path

    def test_own_bearing_and_load(self):
        """The user's load is in every run, and every pulse touches the rim within the asked speeds."""
        run = self.main(self.own_bearing(), "--set", "load.vertical_kN=2000", "--set", "load.mass_kg=203900", "--title", "Bearing 7", "--quiet")
        self.assertEqual(run.returncode, 0, run.stderr)
        main = read(self.folder, "main.json")
        self.assertEqual(main["bearing"]["name"], "own")
        self.assertIn("own.toml", main["bearing"]["from"])
        self.assertEqual((main["load"]["vertical_kN"], main["load"]["mass_kg"]), (2000, 203900))
        self.assertIn("--set load.mass_kg=203900", main["load"]["mass_from"])
        self.assertEqual(main["document"], {"title": "Bearing 7", "client": None, "project": None, "author": None})
        self.assertIn("dead load 2000 kN (--set load.vertical_kN=2000), supported mass 203900 kg", run.stdout)
        pulses = [row for row in main["comparison"] if row["role"] != "window"]
        self.assertEqual(len(pulses), 6)
        for row in main["comparison"]:
            with open(os.path.join(self.folder, "runs", row["name"], "scene.toml")) as file:
                scene = file.read()
            self.assertIn("vertical_kN = 2000.0", scene)
            self.assertIn("mass_kg = 203900.0", scene)
            self.assertIn("thickness_mm = 50.0", scene)
            self.assertIsNone(row["published_kN"])  # the published pair is of another bearing
        for row in pulses:
            self.assertLess(0.04, row["approach_speed_m_s"])
            self.assertLess(row["approach_speed_m_s"], 0.65)
        self.assertGreater(max(row["approach_speed_m_s"] for row in pulses), 0.5)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "published")))

    def band(self, *more, rate="", report=False):
        """What the main job says of an own bearing's steel; its whole calibration beside."""
        with open(self.own_bearing(), "a") as file:
            file.write(rate)
        run = self.main(os.path.join(self.temporary.name, "own.toml"), "--windows-only", "--speeds", "0.1,0.125,0.2,0.4", "--quiet", *more, report=report)
        self.assertEqual(run.returncode, 0, run.stderr)
        return read(self.folder, "calibration", "calibration.json")["answer"]["steel_band"], run

    def test_a_bearing_of_ones_own_has_a_band_of_its_steel(self):
        band, run = self.band(report=True)
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "twins"))), ["window-0.10-fast", "window-0.125-fast", "window-0.40-fast"])
        self.assertEqual((band["law_is_of"], band["rate_is_assumption"], band["calibration"]), ("static", True, "fast"))
        self.assertEqual([row["speed_m_s"] for row in band["rows"]], [0.1, 0.125, 0.4])
        for row in band["rows"]:
            self.assertAlmostEqual(row["fast"]["peak_force_kN"] / row["static"]["peak_force_kN"], 1.1, places=2)
        fast = read(self.folder, "calibration", "fast", "calibration.json")
        self.assertAlmostEqual(fast["parameters"]["k_i"]["value"] / 2.42e5, 1, places=3)
        self.assertAlmostEqual(read(self.folder, "calibration", "calibration.json")["parameters"]["k_i"]["value"] / 2.0e5, 1, places=3)
        self.assertEqual([row["name"] for row in read(self.folder, "main.json")["runs"]], ["window-0.40", "window-0.20", "window-0.125", "window-0.10"])
        self.assertIn("raises the peak force by 10 %", run.stdout)
        with open(os.path.join(self.folder, "report.html")) as file:
            self.assertIn("The steel at speed", file.read())
        exported = rimpact("export", self.folder, "--csv", "-o", os.path.join(self.folder, "out"))
        self.assertEqual(exported.returncode, 0, exported.stderr)
        self.assertIn("two springs", exported.stderr)
        for place in ("out", os.path.join("out", "fast")):
            self.assertTrue(os.path.exists(os.path.join(self.folder, place, "law.csv")), place)

    def test_a_bearing_whose_steel_knows_its_rate_has_static_twins(self):
        band, _ = self.band(rate='[material.steel]\nrate = "cowper-symonds"\nrate_D_per_s = 3200.0\n')
        self.assertEqual((band["law_is_of"], band["rate_is_assumption"], band["calibration"]), ("fast", False, "static"))
        self.assertIn("D = 3200", band["rate"])
        for row in band["rows"]:
            self.assertGreater(row["fast"]["peak_force_kN"], 1.05 * row["static"]["peak_force_kN"])

    def test_twins_are_left_out_where_they_are_not_wanted(self):
        band, _ = self.band("--no-twins")
        self.assertIsNone(band)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "twins")))
        self.assertFalse(os.path.exists(os.path.join(self.done, "twins")))  # a built-in bearing's steel is the thesis's

    def test_a_twin_that_fails_leaves_the_law(self):
        self.own_bearing()
        run = self.main(os.path.join(self.temporary.name, "own.toml"), "--windows-only", "--speeds", "0.1,0.2,0.4", STAND_IN_FAIL="window-0.20-fast")
        self.assertEqual(run.returncode, 4, run.stderr)
        self.assertEqual(len(read(self.folder, "calibration", "calibration.json")["answer"]["steel_band"]["rows"]), 2)
        self.assertIn("window-0.20-fast: ", " ".join(read(self.folder, "main.json")["warnings"]))

    def test_a_scene_gives_bearing_load_and_settings(self):
        scene = os.path.join(self.temporary.name, "scene.toml")
        self.own_bearing()
        with open(scene, "w") as file:
            file.write('[bearing]\nfile = "own.toml"\n[load]\nvertical_kN = 1500.0\nmass_kg = 150000.0\n[model]\nmesh = 2\n[excitation]\nkind = "ricker"\n')
        run = self.main(scene, "--windows-only", "--speeds", "0.1,0.125,0.4")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("is not run", run.stderr)
        main = read(self.folder, "main.json")
        self.assertEqual([row["name"] for row in main["runs"]], ["window-0.40", "window-0.125", "window-0.10"])
        self.assertIn("scene.toml:4:", main["load"]["vertical_from"])
        with open(os.path.join(self.folder, "runs", "window-0.40", "scene.toml")) as file:
            self.assertIn("mesh = 2", file.read())
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "runs"))), ["window-0.10", "window-0.125", "window-0.40"])  # folders only
        self.assertIn("window-0.40.log", os.listdir(os.path.join(self.folder, "logs")))

    def test_another_bearing_without_a_load_is_warned_of(self):
        run = self.main(self.own_bearing(), "--dry-run")
        self.assertEqual(run.returncode, 0, run.stderr)
        for word in ("warning: no load is given", "load.vertical_kN = 853", "load.mass_kg = 86952", "the thesis's of shfps-225, an assumption"):
            self.assertIn(word, run.stderr)
        self.assertEqual(self.calls(), [])
        self.assertNotIn("warning", self.main("--dry-run").stderr)

    def test_what_is_neither_scene_nor_bearing_is_said(self):
        path = os.path.join(self.temporary.name, "odd.toml")
        for text, sentence in (('name = "x"\n', "neither a scene"), ("[rim]\nheight_mm = 60.0\n[load]\nmass_kg = 1e5\n", "at once")):
            with open(path, "w") as file:
                file.write(text)
            run = self.main(path)
            self.assertEqual(run.returncode, 2)
            self.assertIn(sentence, run.stderr)
        run = self.main("--set", "excitation.scale=1.05")
        self.assertEqual(run.returncode, 2)
        self.assertIn("--pulse-speeds", run.stderr)
        self.assertEqual(self.main("--speeds", "0.1,0.1").returncode, 2)

    def test_a_dry_run_lists_runs_and_times(self):
        run = self.main("--dry-run", "--json", "--jobs", "3")
        table = json.loads(run.stdout)
        names = [row["name"] for row in table["runs"]]
        self.assertEqual(names[:3], ["window-1.00", "window-0.05", "window-0.20"])
        self.assertTrue(all(name.startswith("ricker") for name in names[6:]))
        times = {row["name"]: row["expected_seconds"] for row in table["runs"]}
        by_speed = [times[name] for name in ("window-1.00", "window-0.60", "window-0.35", "window-0.20", "window-0.10", "window-0.05")]
        self.assertEqual(by_speed, sorted(by_speed, reverse=True))
        self.assertGreater(by_speed[0], 2.5 * by_speed[-1])  # the estimate knows the speed
        self.assertLess(table["expected_seconds"], sum(row["expected_seconds"] for row in table["runs"]) / 2)
        self.assertEqual(self.calls(), [])
        self.assertFalse(os.path.exists(self.folder))

    def test_a_motion_in_two_directions_is_predicted_when_asked_for(self):
        rows = json.loads(self.main("--bidirectional", "--dry-run", "--json").stdout)["runs"]
        self.assertEqual([row["name"] for row in rows if row["role"] == "predict"], ["pulse-bidirectional", "ricker-0.78g-1.0s-x1.00", "ricker-0.38g-1.5s-x1.00"])

    def test_jobs_at_a_time(self):
        for jobs in (1, 3):
            trace = os.path.join(self.temporary.name, f"trace{jobs}")
            folder = os.path.join(self.temporary.name, f"jobs{jobs}")
            rimpact("main", "--windows-only", "--laws", "none", "--jobs", str(jobs), "-o", folder, "--quiet", "--no-report",
                    **self.environment(STAND_IN_SLEEP="1", STAND_IN_TRACE=trace))
            running = most = 0
            with open(trace) as file:
                for word in file.read().split():
                    running += 1 if word == "begin" else -1
                    most = max(most, running)
            self.assertEqual(most, jobs)

    def test_doubts_of_a_run_reach_the_table(self):
        run = self.main("--windows-only", STAND_IN_DOUBT="window-0.20")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("warning: window-0.20: the test doubts this run", run.stderr)
        self.assertIn("window-0.20 !", run.stdout)
        self.assertEqual(run.stdout.count("window-0.20: the test doubts this run"), 1, "said once, beside the answer")
        self.assertNotIn("window-0.10 !", run.stdout)
        main = read(self.folder, "main.json")
        rows = {row["name"]: row for row in main["comparison"]}
        self.assertEqual(rows["window-0.20"]["doubts"], ["the test doubts this run"])
        self.assertEqual(rows["window-0.10"]["doubts"], [])
        self.assertIn("window-0.20: the test doubts this run", main["warnings"])

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
