"""Bad input is refused with one sentence and the right exit code; good input gives what docs/interface.md says."""
import csv
import json
import os
import shutil
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
        self.refused(2, "95", "90", arguments=["check", "ricker-0.78g-1.0s", "--rung", "full", "--set", "bearing.foot.radius_mm=95"])
        self.assertEqual(rimpact("check", "ricker-0.78g-1.0s", "--set", "bearing.foot.radius_mm=95").returncode, 0)  # rung rim has none

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
                            (["--fit", "k_i,stiffness"], "stiffness"), (["--start", "k_i=much"], "is not a number"),
                            (["--lead-mm", "nan"], "--lead-mm nan must be in 0..1000"), (["--starts", "2147483647"], "n_starts 2.14748e+09 must be <= 1000")):
            self.refused(2, said, arguments=["calibrate", "/nowhere", *words])
        self.refused(2, "are the same run", arguments=["calibrate", "/nowhere", "/nowhere/../nowhere"])

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

    def test_a_report_takes_its_head_and_says_where_no_pdf_can_be_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            run = os.path.join(folder, "run")
            self.assertEqual(rimpact("reduced", "impact-window", "-o", run).returncode, 0)
            document = os.path.join(folder, "d.toml")
            with open(document, "w", encoding="utf-8") as file:
                file.write('client = "Acme & Co"\nproject = "R3"\n')
            made = rimpact("report", run, "--title", "--odd <title>", "--document", document, "--pdf", PATH="/nowhere")
            self.assertEqual((made.returncode, made.stdout), (0, os.path.join(run, "report.html") + "\n"))
            self.assertRegex(made.stderr, r"no PDF: none of chromium, .* Open .*report\.html in a browser")
            with open(os.path.join(run, "report.html"), encoding="utf-8") as file:
                page = file.read()
            for said in ("--odd &lt;title&gt;", "Acme &amp; Co", "R3"):
                self.assertIn(said, page)
            with open(document, "w", encoding="utf-8") as file:
                file.write('clinet = "x"\n')
            self.refused(2, 'd.toml: unknown key "clinet"; did you mean "client"?', arguments=["report", run, "--document", document])
            self.refused(6, "/dev/full", arguments=["report", run, "-o", "/dev/full"])

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
            self.assertEqual(fit["answer"]["law"]["name"], "signed")  # of the four ranked by default the one that made the run
            self.assertEqual(fit["answer"]["law"]["belongs_to"], "mass")
            asked = rimpact("calibrate", one, "--law", "no-tension", "-o", os.path.join(folder, "asked"))
            self.assertIn("The law signed is better", asked.stdout)
            with open(os.path.join(folder, "asked", "calibration.toml")) as file:
                self.assertIn('impact_law = "no-tension"', file.read())

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
            checked = rimpact("check", os.path.join(case, "scene.toml"))
            self.assertEqual((checked.returncode, checked.stderr), (0, "next: rimpact reduced SCENE (milliseconds), then rimpact run SCENE\n"))
            self.assertIn("bearing: case, L_c = 400.0 mm", checked.stdout)  # called as its folder
            self.assertIn("rim.height_mm = 60;", checked.stdout)  # assumed until the mark is struck
            self.assertEqual(rimpact("new", case).returncode, 2)  # nothing is overwritten
            path = os.path.join(case, "bearing.toml")
            with open(path) as file:
                text = file.read()
            with open(path, "w") as file:
                file.write("\n".join(line.split("# assumption")[0] for line in text.splitlines()))
            self.assertIn("assumed, not measured: nothing", rimpact("check", os.path.join(case, "scene.toml")).stdout)

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


class WhatIsRun(unittest.TestCase):
    """Every number's bearing, load, motion and element are said, and doubted where they are another bearing's."""
    PAIR = "the thesis's for shfps-225"
    MAKER = ('name = "acme"\n[surface]\nkind = "sphere"\nR0_m = 3.0\nplanar_radius_mm = 600\n[slider]\ndiameter_mm = 300\nbottom_mm = 58\ntop_mm = 158\n'
             '[rim]\nheight_mm = 70\nthickness_mm = 50\n[foot]\nradius_mm = 20\n')
    SCENE = '[bearing]\nfile = "b.toml"\n[load]\nvertical_kN = 2000\n[excitation]\nkind = "ricker"\namplitude_g = 1.1\n'

    def setUp(self):
        self.keeper = tempfile.TemporaryDirectory()
        self.addCleanup(self.keeper.cleanup)
        self.folder = self.keeper.name
        for name, text in (("b.toml", self.MAKER), ("s.toml", self.SCENE)):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write(text)
        self.scene = os.path.join(self.folder, "s.toml")

    def calibration(self, rim, **more):
        folder = os.path.join(self.folder, "cal")
        os.makedirs(folder, exist_ok=True)
        law = {"name": "no-tension", "belongs_to": "mass", "fitted_from_m_s": 0.05, "fitted_to_m_s": 0.3,
               "element": {"k_i": {"value": 1.2e5, "unit": "kN/m"}, "e": {"value": 0.3, "unit": "-"}}}
        with open(os.path.join(folder, "calibration.json"), "w") as file:
            json.dump({"answer": {"rim_identity": rim, "mass_kg": 2000e3 / 9.81, "law": {**law, **more}}}, file)
        return folder

    def test_a_makers_bearing_needs_no_pad_and_foot(self):
        checked = rimpact("check", self.scene)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        for words in ("bearing: acme, L_c = 450.0 mm", "W = 2000 kN, m = 203874 kg", "motion: ricker", "amplitude_g 1.1", "signed, k_i = 450000 kN/m, e = 0.65",
                      "the thesis's pair for shfps-225", "pad and foot are left out of these notes"):
            self.assertIn(words, checked.stdout)
        self.assertIn(self.PAIR, checked.stderr)
        table = json.loads(rimpact("check", self.scene, "--json").stdout)
        self.assertEqual(table["bearing"], "acme")
        self.assertAlmostEqual(table["load"]["mass_kg"], 2000e3 / 9.81)
        self.assertEqual(table["motion"]["amplitude_g"], 1.1)
        self.assertEqual(table["impact_element"]["source"], "the thesis's pair for shfps-225")
        self.assertTrue(any(self.PAIR in sentence for sentence in table["warnings"]))
        self.assertNotIn("rim.height_mm", table["assumptions"])
        self.assertIn("foot.cap_radius_mm", table["assumptions"])
        refused = rimpact("check", self.scene, "--rung", "full")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("foot", refused.stderr)

    def test_a_calibration_takes_the_pairs_place(self):
        out = os.path.join(self.folder, "run")
        published = rimpact("reduced", self.scene, "-o", out)
        self.assertIn(self.PAIR, published.stderr)
        with open(os.path.join(out, "summary.json")) as file:
            self.assertTrue(any(self.PAIR in sentence for sentence in json.load(file)["warnings"]))
        cal = self.calibration("0123456789abcdef")
        fitted = rimpact("reduced", self.scene, "--calibration", cal, "-o", out)
        self.assertEqual(fitted.returncode, 0, fitted.stderr)
        self.assertIn(f"no-tension, k_i = 120000 kN/m, e = 0.3 (calibration {cal}; fitted from 0.05 to 0.3 m/s; for 203874 kg only)", fitted.stdout)
        self.assertNotIn(self.PAIR, fitted.stderr)
        self.assertIn("fitted to another rim (0123456789abcdef", fitted.stderr)
        self.assertIn("outside the speeds the impact element was fitted to, 0.05 to 0.3 m/s", fitted.stderr)
        with open(os.path.join(out, "summary.json")) as file:
            first = json.load(file)
        self.assertTrue(first["beyond_fit"])
        shutil.rmtree(cal)
        again = os.path.join(self.folder, "again")
        self.assertEqual(rimpact("reduced", out, "-o", again).returncode, 0)  # the folder's scene.toml has the numbers
        with open(os.path.join(again, "summary.json")) as file:
            self.assertEqual(json.load(file)["impacts"], first["impacts"])
        gone = rimpact("reduced", self.scene, "--calibration", cal, "-o", out)
        self.assertEqual(gone.returncode, 3)
        self.assertIn("calibration.json: no such file", gone.stderr)

    def test_what_calibrate_writes_is_what_is_flown(self):
        law, runs = ["--set", "reduced.impact_law=hunt-crossley", "--set", "reduced.k_i_kN_per_m=3e5", "--set", "reduced.impact_exponent=1.3"], []
        for speed in ("0.1", "0.2", "0.4"):
            runs.append(os.path.join(self.folder, speed))
            rimpact("reduced", "impact-window", *law, "--set", f"excitation.speed_m_per_s={speed}", "-o", runs[-1])
        cal = os.path.join(self.folder, "own")
        made = rimpact("calibrate", *runs, "-o", cal)
        self.assertEqual(made.returncode, 0, made.stderr)
        peaks = []
        for out, words in (("typed", law), ("flown", ["--calibration", cal])):
            run = rimpact("reduced", "impact-window", *words, "--set", "excitation.speed_m_per_s=0.3", "-o", os.path.join(self.folder, out), "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            peaks.append(json.loads(run.stdout)["peak_impact_force_N"])
        self.assertAlmostEqual(peaks[1] / peaks[0], 1, places=3)
        self.assertEqual(run.stderr, "")  # the same rim, within its speeds

    def test_a_fleet_says_what_is_beyond(self):
        cal, out = self.calibration("0123456789abcdef"), os.path.join(self.folder, "fleet")
        sweep = os.path.join(self.folder, "sweep.toml")
        with open(sweep, "w") as file:
            file.write('[grid]\nexcitation.amplitude_g = [0.3, 1.1, 1.3]\n[fractiles]\nalong = "excitation.amplitude_g"\n')
        run = rimpact("reduced", self.scene, "--calibration", cal, "--sweep", sweep, "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("fitted to another rim", run.stderr)
        self.assertIn("at speeds its element was not fitted to (column beyond_fit)", run.stderr)
        with open(os.path.join(out, "table.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["beyond_fit"] for row in rows], ["0", "1", "1"])
        self.assertEqual(rows[0]["beyond_rim"], "0")
        with open(os.path.join(out, "fractiles.csv"), newline="") as file:
            levels = list(csv.DictReader(file))
        self.assertEqual([level["n_beyond_fit"] for level in levels], ["0", "1", "1"])
        with h5py.File(os.path.join(out, "table.h5")) as table:
            self.assertEqual(list(table["table/beyond_fit"]), [0, 1, 1])
        plain = rimpact("reduced", self.scene, "--sweep", sweep, "-o", os.path.join(self.folder, "plain"))
        self.assertIn(self.PAIR, plain.stderr)

    def test_a_window_through_the_rim_is_doubted(self):
        for more, words in ((["reduced.k_i_kN_per_m=2e4"], "into a rim of 40 mm"), (["reduced.k_i_kN_per_m=0", "excitation.duration_s=0.3"], "that this run leaves out")):
            words_of = [word for assignment in ["excitation.speed_m_per_s=5", *more] for word in ("--set", assignment)]
            run = rimpact("reduced", "impact-window", *words_of, "-o", self.folder, "--json")
            summary = json.loads(run.stdout)
            self.assertTrue(summary["beyond_rim"])
            self.assertTrue(any(words in sentence for sentence in summary["warnings"]), summary["warnings"])
            self.assertTrue(any("past the dish's edge at 520 mm" in sentence for sentence in summary["warnings"]), summary["warnings"])
            self.assertIn("past the dish's edge", run.stderr)

    def test_a_mass_below_the_sliders_is_refused(self):
        run = rimpact("check", "impact-window", "--set", "load.mass_kg=20", "--set", "load.vertical_kN=0.2")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"load.mass_kg 20 is no more than the slider's own mass, 3[0-9]\.[0-9] kg")


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
