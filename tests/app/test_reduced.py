"""`rimpact reduced`: what one run stores, when it stops, what of it is doubted."""
import json
import math
import os
import subprocess
import tempfile
import unittest

import h5py
from command import RIMPACT, Refusals, rimpact


class ReducedRun(Refusals):
    def test_a_reduced_run_that_stops_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=50", "-o", folder)
            self.assertEqual(run.returncode, 4)
            self.assertIn("thrown over the rim", run.stderr)
            with open(os.path.join(folder, "summary.json")) as file:
                self.assertEqual(json.load(file)["status"], "stopped")

    def test_a_scene_that_ends_on_the_rim_has_its_rebound_doubted(self):
        with tempfile.TemporaryDirectory() as folder:
            for duration, doubted in ((0.01, True), (0.06, False)):
                run = rimpact("reduced", "impact-window", "--set", f"excitation.duration_s={duration}", "-o", folder)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual("while the rim still bears" in run.stderr, doubted, run.stderr)

    def test_a_window_through_the_rim_is_doubted(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        for more, words in ((["reduced.k_i_kN_per_m=2e4"], "into a rim of 40 mm"), (["reduced.k_i_kN_per_m=0", "excitation.duration_s=0.3"], "that this run leaves out")):
            words_of = [word for assignment in ["excitation.speed_m_per_s=5", *more] for word in ("--set", assignment)]
            run = rimpact("reduced", "impact-window", *words_of, "-o", folder, "--json")
            summary = json.loads(run.stdout)
            self.assertTrue(summary["beyond_rim"])
            self.assertTrue(any(words in sentence for sentence in summary["warnings"]), summary["warnings"])
            self.assertTrue(any("past the dish's edge at 520 mm" in sentence for sentence in summary["warnings"]), summary["warnings"])
            self.assertIn("past the dish's edge", run.stderr)

    def test_a_slow_cycle_tells_no_second_and_no_speed(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        run = rimpact("reduced", "static-unidirectional", "--set", "excitation.amplitude_m=0.401", "-o", folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("m/s", run.stdout)
        self.assertIn("  23.90 % of the path     0.0 deg  pressed and let go  450.0 kN", run.stdout)
        slow = rimpact("reduced", "impact-window", "--set", "excitation.speed_m_per_s=0.00004", "-o", folder, "--force")
        self.assertIn("in 0.04 mm/s  out 0.0", slow.stdout)
        self.assertNotIn("0.0000 m/s", slow.stdout)

    def test_moments_at_nodes(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("reduced", "ricker-0.78g-1.0s", "--nodes", "350,220", "-o", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            with h5py.File(os.path.join(folder, "response.h5")) as file:
                force, moment = file["response/force_x"][:], file["response/moment_above_y"][:]
            self.assertLess(abs(moment + 0.22 * force).max(), 1e-6)
            self.assertEqual(rimpact("reduced", "ricker-0.78g-1.0s", "--nodes", "350").returncode, 2)
            self.assertEqual(rimpact("reduced", "ricker-0.78g-1.0s", "--nodes=-1,2").returncode, 2)

    def test_a_scene_file_is_not_replaced_by_its_run(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.toml")
            with open(path, "w") as file:
                file.write("# mine\n[excitation]\nkind = \"ricker\"\n")
            for verb in ("reduced", "run"):
                self.refused(2, "would replace the scene file", path, arguments=[verb, path, "-o", folder])
            with open(path) as file:
                self.assertTrue(file.read().startswith("# mine"))
            again = os.path.join(folder, "run")
            self.assertEqual(rimpact("reduced", path, "-o", again).returncode, 0)
            self.assertEqual(rimpact("reduced", again, "-o", again).returncode, 0)  # a run's own scene, once more

    def test_a_record_is_sought_beside_the_scene_and_then_on_the_shelf(self):
        with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as shelf:
            def record(folder, peak):
                with open(os.path.join(folder, "OWN.AT2"), "w") as file:
                    file.write("PEER\nown\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .0100 SEC\n")
                    file.writelines(f"{peak * math.sin(0.1 * k):.6e}\n" for k in range(200))

            def scene(environment):
                words = ["--set", "excitation.kind=record", "--set", "excitation.x=OWN.AT2", "-o", "run", "--force"]
                run = rimpact("reduced", "ricker-0.78g-1.0s", *words, cwd=place, **environment)
                with open(os.path.join(place, "run", "scene.toml")) as file:
                    return run, file.read()

            record(shelf, 0.2)
            run, kept = scene({"RIMPACT_RECORDS": shelf})
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(os.path.join(shelf, "OWN.AT2"), kept)
            record(place, 0.1)
            self.assertIn(os.path.join(place, "OWN.AT2"), scene({"RIMPACT_RECORDS": shelf})[1])
            os.remove(os.path.join(place, "OWN.AT2"))
            self.refused(3, "OWN.AT2", arguments=["reduced", "ricker-0.78g-1.0s", "--set", "excitation.kind=record", "--set",
                                                  f"excitation.x={place}/OWN.AT2", "-o", os.path.join(place, "none")])

    def test_full_disk_leaves_the_earlier_result(self):
        with tempfile.TemporaryDirectory() as folder:
            rimpact("reduced", "impact-window", "-o", folder)
            with open(os.path.join(folder, "summary.json")) as file:
                before = file.read()
            run = subprocess.run(["bash", "-c", f"ulimit -f 4; trap '' XFSZ; '{RIMPACT}' reduced impact-window -o '{folder}'"],
                                 capture_output=True, text=True)
            self.assertEqual(run.returncode, 6, run.stderr)
            with open(os.path.join(folder, "summary.json")) as file:
                self.assertEqual(file.read(), before)


if __name__ == "__main__":
    unittest.main()
