"""Bad input is refused with one sentence and the right exit code; good input gives what INTERFACE says."""
import csv
import json
import os
import subprocess
import tempfile
import unittest

import h5py

from command import RIMPACT, in_terminal, rimpact

AT2 = "PEER\nA RECORD\n{}\nNPTS= {}, DT= .0100 SEC\n"


class BadInput(unittest.TestCase):
    def refused(self, code, *needles, arguments):
        run = rimpact(*arguments)
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual(len([line for line in run.stderr.splitlines() if line.startswith("error:")]), 1, run.stderr)
        for needle in needles:
            self.assertIn(needle, run.stderr)

    def check(self, key_value, *needles, code=2):
        self.refused(code, *needles, arguments=["check", "ricker-0.78g-1.0s", "--set", key_value])

    def test_negative_radius(self):
        self.check("bearing.slider.diameter_mm=-240", "diameter_mm", "-240")

    def test_rim_lower_than_the_slider(self):
        self.check("bearing.rim.height_mm=5", "height_mm", "5")

    def test_dish_beyond_the_ellipse(self):
        self.check("bearing.surface.planar_radius_mm=600", "600", "562.5")

    def test_no_lateral_capacity(self):
        self.check("bearing.slider.diameter_mm=1100", "diameter_mm")

    def test_foot_wider_than_its_cap(self):
        self.check("bearing.foot.radius_mm=95", "95", "90")

    def test_unknown_key_has_a_suggestion(self):
        self.check("excitation.amplitud_g=0.7", "did you mean", "amplitude_g")

    def test_models_without_a_rung(self):
        self.refused(2, "two dishes", "rimpact reduced", arguments=["check", "lir-dcfp-stages"])
        self.refused(2, "superstructure.kind", "rigid mass", arguments=["check", "frame-four-dof"])

    def test_wrong_type(self):
        self.check('excitation.scale="much"', "scale")

    def test_not_a_number(self):
        self.check("excitation.amplitude_g=nan", "amplitude_g")

    def test_words_of_calibrate(self):
        for words, said in ((["--fixed", "e"], "NAME=VALUE"), (["--bounds", "k_i=3"], "NAME=LOW:HIGH"),
                            (["--sigma", "forse=0.1"], "did you mean \"force\""), (["--law", "signd"], "signed"),
                            (["--fit", "k_i,stiffness"], "stiffness"), (["--start", "k_i=much"], "is not a number")):
            self.refused(2, said, arguments=["calibrate", "/nowhere", *words])

    def test_missing_scene(self):
        self.refused(2, "nowhere.toml", arguments=["check", "nowhere.toml"])

    def test_unknown_verb_and_option(self):
        self.refused(2, "did you mean \"run\"", arguments=["runn"])
        self.refused(2, "did you mean --json", arguments=["check", "ricker-0.78g-1.0s", "--jsn"])
        self.refused(2, "--fast", arguments=["check", "ricker-0.78g-1.0s", "--fast"])
        self.refused(2, arguments=[])

    def test_a_terminal_gets_colours_unless_told_not_to(self):
        self.assertIn("\033[31m", in_terminal("check", "nowhere.toml"))
        self.assertNotIn("\033", in_terminal("check", "nowhere.toml", NO_COLOR="1"))
        self.assertNotIn("\033", rimpact("check", "nowhere.toml").stderr)

    def test_unwritable_places(self):
        for arguments in (["reduced", "impact-window", "-o", "/proc/nowhere"], ["new", "/proc/nowhere"]):
            self.refused(6, "/proc/nowhere", arguments=arguments)
        with open("/dev/full", "w") as full:
            run = subprocess.run([RIMPACT, "list"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(run.returncode, 6, run.stderr)

    def test_unreadable_data(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "response.h5")
            with open(path, "wb") as file:
                file.write(b"\x89HDF\r\n\x1a\n and then nothing")
            self.refused(3, "response.h5", arguments=["compare", path, path])
            self.refused(3, folder, arguments=["export", folder, "--opensees"])
            self.assertEqual(rimpact("report", folder).returncode, 3)
            self.assertEqual(rimpact("calibrate", folder).returncode, 3)

    def test_toml_error_names_file_line_and_column(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.toml")
            with open(path, "w") as file:
                file.write("[excitation]\nkind = \"ricker\"\nscal = 1.0\n")
            self.refused(2, "scene.toml:3:", "scale", arguments=["check", path])

    def test_a_reduced_run_that_stops_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=50", "-o", folder)
            self.assertEqual(run.returncode, 4)
            self.assertIn("left the dish", run.stderr)
            with open(os.path.join(folder, "summary.json")) as file:
                self.assertEqual(json.load(file)["status"], "stopped")

    def test_check_says_what_run_would_refuse(self):
        for more, word in ((["--set", 'model.rung="rigid-dish"'], "weightless"),
                           (["--set", 'model.rung="rigid-dish"', "--set", 'excitation.with=["weight"]', "--set", "load.vertical_kN=0"],
                            "holds the stack")):
            checked = rimpact("check", "impact-window", *more, "--json")
            self.assertEqual(checked.returncode, 2)
            self.assertIn(word, checked.stderr)
            self.assertIn(word, json.loads(checked.stdout)["refusal"])
            self.assertEqual(rimpact("run", "impact-window", "--dry-run", *more).returncode, 2)

    def test_a_mass_in_tonnes_is_remarked_upon(self):
        for verb in (["check"], ["run", "--dry-run"]):
            done = rimpact(*verb, "ricker-0.78g-1.0s", "--set", "load.mass_kg=87")
            self.assertEqual(done.returncode, 0)
            self.assertIn("are the units right?", done.stderr)

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

    def test_records(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.AT2")
            self.refused(3, "a.AT2", arguments=["motion", path])
            for units, npts, needle in (("VELOCITY TIME SERIES IN UNITS OF CM/S", 3, "VELOCITY"),
                                        ("ACCELERATION TIME SERIES IN UNITS OF G", 30, "30")):
                with open(path, "w") as file:
                    file.write(AT2.format(units, npts) + " .1E-01 .2E-01 .1E-01\n")
                run = rimpact("motion", path)
                self.assertEqual(run.returncode, 3)
                self.assertIn(needle.lower(), run.stderr.lower())


class GoodInput(unittest.TestCase):
    def test_list_and_check_as_json(self):
        table = json.loads(rimpact("list", "--json").stdout)
        self.assertIn("shfps-225", table["bearings"])
        self.assertIn("rim-push", table["scenes"])
        plan = json.loads(rimpact("check", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "--json").stdout)
        self.assertEqual(plan["symmetry"], "half")
        self.assertEqual(len(plan["impacts"]), 1)
        whole = json.loads(rimpact("check", "pulse-bidirectional", "--json").stdout)
        self.assertEqual(whole["symmetry"], "whole")  # impacts aslant

    def test_the_scout_sees_what_the_scene_does(self):
        cyclic = json.loads(rimpact("check", "static-unidirectional", "--json").stdout)
        self.assertAlmostEqual(cyclic["closest_gap_m"], 0.010, places=4)  # 0.39 m of 0.40 m
        self.assertFalse(cyclic["rim_takes_part"])
        blind = json.loads(rimpact("check", "ricker-0.78g-1.0s", "--set", "reduced.k_i_kN_per_m=0", "--json").stdout)
        self.assertEqual(len(blind["impacts"]), 1)  # whatever element the scene gives its own reduced model
        for bearing, said in (("shfps-225", True), ("fps-225", False)):  # a sphere is as curved everywhere
            plan = json.loads(rimpact("check", "impact-window", "--set", f"bearing.name={bearing}", "--json").stdout)
            self.assertEqual(any("fore and aft" in note for note in plan["notes"]), said)

    def test_a_scene_that_ends_on_the_rim_has_its_rebound_doubted(self):
        with tempfile.TemporaryDirectory() as folder:
            for duration, doubted in ((0.01, True), (0.06, False)):
                run = rimpact("reduced", "impact-window", "--set", f"excitation.duration_s={duration}", "-o", folder)
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertEqual("while the rim still bears" in run.stderr, doubted, run.stderr)

    def test_reduced_compare_and_calibrate(self):
        with tempfile.TemporaryDirectory() as folder:
            one, two = os.path.join(folder, "one"), os.path.join(folder, "two")
            for path, stiffness in ((one, 3e5), (two, 4.5e5)):
                run = rimpact("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "--set",
                              f"reduced.k_i_kN_per_m={stiffness}", "-o", path)
                self.assertEqual(run.returncode, 0, run.stderr)
            metrics = json.loads(rimpact("compare", one, two, "--json").stdout)
            self.assertGreater(metrics["peak_force_error"], 0.1)
            self.assertEqual(json.loads(rimpact("compare", one, one, "--json").stdout)["nrmse_displacement"], 0)
            run = rimpact("calibrate", one, "--predict", two, "-o", os.path.join(folder, "fit"))
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(folder, "fit", "calibration.json")) as file:
                fit = json.load(file)
            self.assertAlmostEqual(fit["parameters"]["k_i"]["value"] / 3e5, 1, places=5)
            self.assertAlmostEqual(fit["parameters"]["e"]["value"], 0.65, places=5)

    def test_calibrate_takes_laws_bounds_and_uncertainties(self):
        with tempfile.TemporaryDirectory() as folder:
            runs = []
            for speed in ("0.1", "0.2", "0.4"):
                runs.append(os.path.join(folder, speed))
                rimpact("reduced", "impact-window", "--set", f"excitation.speed_m_per_s={speed}", "-o", runs[-1])
            run = rimpact("calibrate", *runs, "-o", folder, "--json", "--fixed", "e=0.65", "--bounds", "k_i=1e5:1e6", "--laws",
                          "no-tension,signed", "--sigma", "force=0.02", "--starts", "2")
            self.assertEqual(run.returncode, 0, run.stderr)
            table = json.loads(run.stdout)
            self.assertEqual(list(table["parameters"]), ["k_i"])
            self.assertEqual([row["law"] for row in table["laws"]["rows"]], ["signed", "no-tension"])
            self.assertEqual(len(table["laws"]["rows"][0]["leave_one_out"]), 3)

    def test_moments_at_nodes(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("reduced", "ricker-0.78g-1.0s", "--nodes", "350,220", "-o", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            with h5py.File(os.path.join(folder, "response.h5")) as file:
                force, moment = file["response/force_x"][:], file["response/moment_above_y"][:]
            self.assertLess(abs(moment + 0.22 * force).max(), 1e-6)
            self.assertEqual(rimpact("reduced", "ricker-0.78g-1.0s", "--nodes", "350").returncode, 2)
            self.assertEqual(rimpact("reduced", "ricker-0.78g-1.0s", "--nodes=-1,2").returncode, 2)

    def test_grazing_is_not_identifiable(self):
        with tempfile.TemporaryDirectory() as folder:
            rimpact("reduced", "ricker-0.78g-1.0s", "-o", folder)
            run = rimpact("calibrate", folder, "-o", os.path.join(folder, "fit"), "--json")
            table = json.loads(run.stdout)
            self.assertFalse(table["parameters"]["k_i"]["identifiable"])

    def test_new_case_can_be_checked(self):
        with tempfile.TemporaryDirectory() as folder:
            case = os.path.join(folder, "case")
            self.assertEqual(rimpact("new", case).returncode, 0)
            self.assertEqual(rimpact("check", os.path.join(case, "scene.toml")).returncode, 0)
            self.assertEqual(rimpact("new", case).returncode, 2)  # nothing is overwritten

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

    def test_motion_of_real_records(self):
        records = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../shared/records"))
        path = os.path.join(records, "RSN1086_NORTHR_SYL360.AT2")
        if not os.path.exists(path):
            self.skipTest("the ground-motion records are not here (set RIMPACT_RECORDS)")
        table = json.loads(rimpact("motion", path, "--json").stdout)
        self.assertAlmostEqual(table[0]["dt_s"], 0.02)


class Sweeps(unittest.TestCase):
    GRID = ["reduced", "ricker-0.78g-1.0s", "--sweep", "excitation.scale=0.5:1.4:4", "--sweep", "reduced.mu_fast=0.07:0.08:2"]

    def rows(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_grid_in_shards_resumed_and_gathered(self):
        with tempfile.TemporaryDirectory() as folder:
            def run(*more):
                done = rimpact(*self.GRID, "-o", folder, "--json", "--quiet", *more)
                self.assertEqual(done.returncode, 0, done.stderr)
                return json.loads(done.stdout)
            self.assertEqual([run("--shard", f"{i}/3")["n_runs"] for i in (1, 2, 3)], [3, 3, 2])
            self.assertEqual(len(self.rows(f"{folder}/table-2-of-3.csv")), 3)
            whole = run("--threads", "2")
            self.assertEqual((whole["n_runs"], whole["kept"], whole["done"]), (8, 8, 8))
            rows = self.rows(whole["table"])
            self.assertEqual([row["run"] for row in rows], [str(i) for i in range(1, 9)])
            self.assertEqual({(row["excitation.scale"], row["n_impacts"] != "0") for row in rows},
                             {("0.5", False), ("0.8", False), ("1.1", True), ("1.4", True)})
            with h5py.File(f"{folder}/table.h5") as table:
                peaks = [float(row["peak_displacement_m"]) for row in rows]
                self.assertEqual(list(table["table/peak_displacement_m"]), peaks)

    def test_bad_sweeps(self):
        for arguments, code, needle in ((["--sweep", "excitation.scale=1:2"], 2, "KEY=a:b:n"),
                                        (["--sweep", "nowhere.toml"], 2, "nowhere.toml"),
                                        (["--sweep", "excitation.scale=1:2:3", "--shard", "4/3"], 2, "4/3"),
                                        (["--sweep", "excitation.scale=1:2:3", "--shard", "nan/3"], 2, "nan/3"),
                                        (["--shard", "1/3"], 2, "--sweep")):
            run = rimpact("reduced", "ricker-0.78g-1.0s", *arguments)
            self.assertEqual(run.returncode, code, run.stderr)
            self.assertIn(needle, run.stderr)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)


if __name__ == "__main__":
    unittest.main()
