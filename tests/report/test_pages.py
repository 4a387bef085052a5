"""Whole reports: of a results folder, of one run, and of folders in which things are missing or broken."""
import json
import os
import re
import shutil
import tempfile
import time
import unittest

from support import InFolder, command, text_of

import synthetic
import synthetic_calibration
import synthetic_results
from report.build import build
from report.results import load_results


class MainResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = cls.holder.name
        synthetic_results.main_folder(cls.folder, pulses=synthetic_results.PULSES[:1], speeds=(0.1, 0.3, 1.0))
        start = time.process_time()
        cls.path, cls.problems = build(cls.folder)
        cls.seconds = time.process_time() - start
        cls.page, cls.text = text_of(cls.path)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_nothing_is_missing(self):
        self.assertEqual(self.problems, [])
        self.assertNotIn("not run", self.text)
        self.assertNotIn("could not be drawn", self.text)

    def test_one_file_and_no_links_out(self):
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:image/webp;base64,|#)', self.page), [])
        self.assertNotRegex(self.page, r"https?://|<script[^>]* src|@import|url\(|fetch\(")
        self.assertLess(len(self.page), 12e6)

    def test_the_answer_comes_first(self):
        answer = self.text.index("The answer")
        self.assertLess(answer, self.text.index("Behind the first page"))
        self.assertLess(self.text.index("Behind the first page"), self.text.index("1 Inputs and assumptions"))

    def test_every_rung_of_both_pulses_is_shown_with_time_and_error(self):
        speed = self.text[self.text.rindex("Speed beside error"):]
        for pulse in ("ricker-0.78g-1.0s", "ricker-0.38g-1.5s"):
            self.assertIn(f"Every rung on {pulse}", speed)
            self.assertTrue(os.path.exists(os.path.join(self.folder, "figures", f"speed-rungs-{pulse}.png")))
        for rung in ("reduced", "rim-mesh1", "rigid-dish-mesh1", "full-mesh1"):
            self.assertIn(rung, speed)

    def test_errors_belong_to_the_forces_beside_them(self):
        forces = {}
        for place in ("runs", "reduced"):
            with open(os.path.join(self.folder, place, "ricker-0.78g-1.0s", "summary.json"), encoding="utf-8") as file:
                forces[place] = json.load(file)["peak_impact_force_N"]
        error = 100 * (forces["reduced"] / forces["runs"] - 1)
        self.assertIn(f"reduced, pair (signed) {forces['reduced'] / 1e3:.0f} {error:+.1f}\u202f%", self.text)
        self.assertIn("NRMSE force 0.78\u00a0g, 1.0\u00a0s predicted, not fitted", self.text)

    def test_assumptions_are_marked(self):
        self.assertEqual(self.page.count('class="assumed"'), 8)
        self.assertRegex(self.text, r"thickness of the rim 40 mm assumption")

    def test_pictures_lie_beside(self):
        names = set(os.listdir(os.path.join(self.folder, "figures")))
        for name in ("law", "bearing", "response-ricker-0.78g-1.0s", "impacts-ricker-0.78g-1.0s-x1.10", "ki-and-e-over-speed",
                     "windows-force", "calibration-errors", "calibration-residuals", "calibration-parameters",
                     "critical-amplitudes", "energy", "speed-time-split", "rim-ricker-0.78g-1.0s-x1.10"):
            self.assertIn(name + ".png", names)
        self.assertFalse([name for name in names if name.endswith(".part")])

    def test_every_section_and_scene_is_there(self):
        for section in ("inputs", "histories", "rim", "windows", "calibration", "laws", "comparison", "critical", "energy",
                        "speed", "reproducibility", "conventions"):
            self.assertIn(f'<section id="{section}">', self.page)
        self.assertEqual(self.page.count("<details>"), 6)
        self.assertIn("deal.II", self.text)

    def test_the_published_pair_is_beside_ours(self):
        # synthetic windows: k_i = 5.2e5 (1 - 0.5 v), so that 0.3 m/s is nearest to 4.5e5
        for said in ("The published values beside ours", "The rim softens with speed", "the one at 0.30 m/s comes nearest"):
            self.assertIn(said, self.text)

    def test_laws_are_ranked(self):
        for said in ("elastoplastic 3.0\u202f% 3.0\u202f% 3.0\u202f% 6.0\u202f% 6.0\u202f% 0.10 to 0.50",
                     "signed 20.0\u202f% 20.0\u202f% 20.0\u202f% 40.0\u202f% 40.0\u202f% nowhere",
                     "The law that leaves least unexplained", "(v / 1 m/s) −0.80", "A constant pair is valid from 0.1 to 0.2 m/s.",
                     "inside, fitted 0.10 +3.1\u202f% −2.0\u202f%"):
            self.assertIn(said, self.text)

    def test_quick_enough(self):
        self.assertLess(self.seconds, 60)  # processor time, about 4 s


class OneRun(InFolder):
    def run_folder(self, rung="reduced", **options):
        synthetic.run(self.path("run"), "ricker-0.78g-1.0s", 'kind = "ricker"\nscale = 1.0\namplitude_g = 0.78',
                      synthetic.ricker(0.9, 1.0), synthetic.Rim(4e8, 0.6), rung, **options)
        return self.path("run")

    def test_report_of_a_run(self):
        done = command("report", self.run_folder(), "--output", self.path("out.html"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.strip(), self.path("out.html"))
        page, text = text_of(self.path("out.html"))
        self.assertIn("Peak impact force", text)
        self.assertNotIn("What is missing", text)
        self.assertNotIn("Calibration", text)
        self.assertGreaterEqual(page.count("data:image/webp"), 3)

    def test_a_stopped_run_says_so(self):
        path, _ = build(self.run_folder("rim", status="stopped", truncate=0.4))
        self.assertIn("stopped: step fell below 1e-7 s; what is shown of it is partial", text_of(path)[1])

    def test_two_directions(self):
        import numpy as np

        from report.run_folder import load_run
        run = load_run(self.run_folder())
        run.signals["displacement_y"] = 0.1 * np.sin(3 * run.time)
        run.signals["force_y"] = -2e4 * np.sin(3 * run.time)
        synthetic.write_signals(self.path("run"), run.signals)
        path, problems = build(self.path("run"))
        self.assertEqual(problems, [])

    def test_quick_picture(self):
        self.assertEqual(command("report.quick", "reduced", self.run_folder()).returncode, 0)
        self.assertTrue(os.path.isfile(self.path("run", "response.png")))

    def test_only_a_summary(self):
        os.remove(os.path.join(self.run_folder(), "response.h5"))
        os.remove(self.path("run", "response.csv"))
        os.remove(self.path("run", "scene.toml"))
        path, problems = build(self.path("run"))
        text = text_of(path)[1]
        self.assertIn("no response.h5 or response.csv", text)
        self.assertIn("No response is stored, so nothing is drawn.", text)


class Missing(InFolder):
    def small(self):
        """One pulse, one window, no calibration."""
        motion = synthetic.ricker(0.9, 1.0)
        scene = 'kind = "ricker"\nscale = 1.0\namplitude_g = 0.78\nperiod_s = 1.0'
        synthetic.run(self.path("runs/ricker-0.78g-1.0s"), "ricker-0.78g-1.0s", scene, motion, synthetic.Rim(5e8), "rim")
        synthetic.run(self.path("reduced/ricker-0.78g-1.0s"), "ricker-0.78g-1.0s", scene, motion, synthetic.Rim(4e8, .6),
                      "reduced")
        synthetic.run(self.path("reduced/window-0.10"), "window-0.10", 'kind = "window"\nspeed_m_per_s = 0.1',
                      lambda t: 0.0, synthetic.Rim(4e8, 0.6), "reduced", 0.1)

    def test_no_main_no_calibration_no_window(self):
        self.small()
        path, _ = build(self.folder)
        text = text_of(path)[1]
        for said in ("calibration: not run", "window-0.10: no finite-element run is stored", "no main.json", "No impact law was fitted to these runs"):
            self.assertIn(said, text)
        page = text_of(path)[0]
        for chapter in ("calibration", "laws", "critical", "measured", "building"):  # nothing to say: neither chapter nor contents
            self.assertNotIn(f'id="{chapter}"', page)
            self.assertNotIn(f'href="#{chapter}"', page)
        self.assertNotIn("could not be drawn", text)

    def test_a_broken_run_does_not_lose_the_others(self):
        self.small()
        with open(self.path("reduced/window-0.10/response.h5"), "wb") as file:
            file.write(b"not HDF5")
        path, problems = build(self.folder)
        self.assertTrue(any("window-0.10" in p and "not readable HDF5" in p for p in problems))
        self.assertIn("peak impact force", text_of(path)[1])

    def test_listed_runs_that_never_ran(self):
        self.small()
        with open(self.path("main.json"), "w", encoding="utf-8") as file:
            json.dump({"runs": [{"name": "ricker-0.78g-1.0s", "role": "fit", "fe": "runs/ricker-0.78g-1.0s"},
                                {"name": "ricker-0.38g-1.5s", "role": "predict", "fe": None}],
                       "warnings": ["the BLAS is slow"]}, file)
        path, _ = build(self.folder)
        text = text_of(path)[1]
        self.assertIn("ricker-0.38g-1.5s: no finite-element run is stored", text)
        self.assertIn("the BLAS is slow", text)

    def test_calibration_alone(self):
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer())
        path, _ = build(self.folder)
        self.assertIn("4.10 × 10⁵", text_of(path)[1])

    def test_nulls_are_borne(self):
        self.small()
        os.makedirs(self.path("calibration"))
        self.write("calibration/calibration.json", json.dumps(
            {"parameters": {"k_i": {"value": 4e5, "interval_95": [None, None], "identifiable": False}},
             "answer": {"law": {"name": None, "parameters": {"k_i": None}}, "table": [None, {}], "pair": None, "strain": None},
             "fit": {"ricker-0.78g-1.0s": None}, "windows": {"rows": [None, {}]}, "critical_amplitudes": [{}],
             "laws": {"rows": [None, {"law": "signed", "leave_one_out": [{}]}]}, "speed_laws": {"k_i": None},
             "notes": None, "correlation": {"k_i": None}, "derived": {"c_i": None}}))
        self.write("main.json", '{"runs": null, "totals": null, "warnings": [null]}')
        path, _ = build(self.folder)
        self.assertIn("4.00 × 10⁵ – – no", text_of(path)[1])

    def test_exit_codes(self):
        for folder in (self.path("nowhere"), self.folder):
            done = command("report", folder)
            self.assertEqual(done.returncode, 3)
            self.assertRegex(done.stderr, r"^rimpact report: .+\n$")
        self.assertEqual(command("report").returncode, 2)
        self.small()
        run = self.path("reduced/window-0.10")
        done = command("report", run, "--output", self.write("file", "") + "/report.html")
        self.assertEqual(done.returncode, 6)
        self.assertRegex(done.stderr, r"^rimpact report: cannot write .+\n$")
        shutil.copy(self.path("file"), os.path.join(run, "response.h5"))
        self.assertEqual(command("report", run).returncode, 3)

    def test_roles(self):
        self.small()
        results = load_results(self.folder)
        self.assertEqual([(e.name, e.role) for e in results.entries],
                         [("ricker-0.78g-1.0s", "history"), ("window-0.10", "window")])


if __name__ == "__main__":
    unittest.main()
