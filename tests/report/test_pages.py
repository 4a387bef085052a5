"""Whole reports of one run, and of folders in which things are missing or broken."""
import json
import os
import shutil
import tempfile
import unittest

import synthetic
import synthetic_calibration
from support import InFolder, command, in_process, text_of, unpainted

from report.build import build
from report.results import load_results


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

    @unpainted
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
    @classmethod
    def setUpClass(cls):
        """One pulse, one window, no calibration."""
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.kept = holder.name
        motion = synthetic.ricker(0.9, 1.0)
        scene = 'kind = "ricker"\nscale = 1.0\namplitude_g = 0.78\nperiod_s = 1.0'
        synthetic.run(f"{cls.kept}/runs/ricker-0.78g-1.0s", "ricker-0.78g-1.0s", scene, motion, synthetic.Rim(5e8), "rim")
        synthetic.run(f"{cls.kept}/reduced/ricker-0.78g-1.0s", "ricker-0.78g-1.0s", scene, motion, synthetic.Rim(4e8, .6), "reduced")
        synthetic.run(f"{cls.kept}/reduced/window-0.10", "window-0.10", 'kind = "window"\nspeed_m_per_s = 0.1',
                      lambda t: 0.0, synthetic.Rim(4e8, 0.6), "reduced", 0.1)

    def small(self):
        """A copy of it."""
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True)

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

    @unpainted
    def test_a_broken_run_does_not_lose_the_others(self):
        self.small()
        with open(self.path("reduced/window-0.10/response.h5"), "wb") as file:
            file.write(b"not HDF5")
        path, problems = build(self.folder)
        self.assertTrue(any("window-0.10" in p and "not readable HDF5" in p for p in problems))
        self.assertIn("peak impact force", text_of(path)[1])

    @unpainted
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
        self.assertIn("4.00 × 10⁵ – – – no", text_of(path)[1])

    def test_exit_codes(self):
        for folder in (self.path("nowhere"), self.folder):
            done = in_process("report", folder)
            self.assertEqual(done.returncode, 3)
            self.assertRegex(done.stderr, r"^rimpact report: .+\n$")
        self.assertEqual(command("report").returncode, 2)
        self.small()
        run = self.path("reduced/window-0.10")
        done = command("report", run, "--output", self.write("file", "") + "/report.html")
        self.assertEqual(done.returncode, 6)
        self.assertRegex(done.stderr, r"^rimpact report: cannot write .+\n$")
        shutil.copy(self.path("file"), os.path.join(run, "response.h5"))
        self.assertEqual(in_process("report", run).returncode, 3)

    def test_roles(self):
        self.small()
        results = load_results(self.folder)
        self.assertEqual([(e.name, e.role) for e in results.entries],
                         [("ricker-0.78g-1.0s", "history"), ("window-0.10", "window")])


if __name__ == "__main__":
    unittest.main()
