"""`rimpact check` refuses what cannot be built or run, and says of a good scene what its run will be."""
import json
import os
import re
import tempfile
import unittest

from command import Refusals, rimpact


class RefusedScenes(Refusals):
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
        self.refused(2, "the finite elements take one that [bearing] gives", "surface.concave", "rimpact reduced", arguments=["check", "lir-dcfp-stages"])
        self.refused(2, "superstructure.kind", "rigid mass", arguments=["check", "frame-four-dof"])

    def test_verbs_that_press_a_rim_want_it_in_bearing(self):
        for verb in ("main", "geometry", "study", "curve"):
            with self.subTest(verb):
                self.refused(2, "has its bearing in [isolator]", f"{verb} takes one that [bearing] gives", "rimpact reduced",
                             "surface.concave", arguments=[verb, "lir-dcfp-specimen", "-o", "/proc/nowhere"])
                self.refused(2, "the bearings of its stops", arguments=[verb, "tfp-pulse", "-o", "/proc/nowhere"])

    def test_rims_that_overlap_at_rest_clear_by_either_way_that_is_offered(self):
        low = ["check", "impact-window", "--set", "bearing.name=dcfp-155", "--set", "bearing.slider.height_mm=90"]
        said = self.refused(2, "lie in one another", arguments=low).stderr
        higher, lower = re.search(r"slider.height_mm must be ([0-9.]+) mm or more, or rim.height_mm ([0-9.]+) mm or less", said).groups()
        self.assertEqual(rimpact(*low, "--set", f"bearing.slider.height_mm={higher}").returncode, 0)
        self.assertEqual(rimpact(*low, "--set", f"bearing.rim.height_mm={lower}").returncode, 0)
        shallow = ["check", "impact-window", "--set", "bearing.name=dcfp-155", "--set", "bearing.surface.planar_radius_mm=390"]  # a rim low enough would not meet the slider's side
        self.assertNotIn("or less", self.refused(2, "lie in one another", arguments=shallow).stderr)

    def test_wrong_type(self):
        self.check('excitation.scale="much"', "scale")

    def test_not_a_number(self):
        self.check("excitation.amplitude_g=nan", "amplitude_g")

    def test_missing_scene(self):
        self.refused(2, "nowhere.toml", arguments=["check", "nowhere.toml"])

    def test_toml_error_names_file_line_and_column(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.toml")
            with open(path, "w") as file:
                file.write("[excitation]\nkind = \"ricker\"\nscal = 1.0\n")
            self.refused(2, "scene.toml:3:", "scale", arguments=["check", path])

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

    def test_a_slider_of_two_halves_wants_a_rung_that_has_them(self):
        halves = ["impact-window", "--set", "bearing.name=lir-dcfp-155", "--set", 'excitation.with=["weight","friction"]']
        self.refused(2, "bearing.slider.mu_interface 0.15", "--rung rigid-dish", arguments=["run", *halves, "--dry-run"])
        self.refused(2, "bearing.slider.mu_interface 0.05", "0.05167",
                     arguments=["run", *halves, "--rung", "rigid-dish", "--set", "bearing.slider.mu_interface=0.05", "--dry-run"])
        self.refused(2, "main finds the law of a rim", arguments=["main", "lir-dcfp-155", "--dry-run"])
        weightless = ["impact-window", "--set", "bearing.name=lir-dcfp-155", "--rung", "rigid-dish"]
        run = self.refused(2, 'set excitation.with to ["weight", "friction"]', arguments=["run", *weightless, "--dry-run"])
        self.assertNotIn("`rim`", run.stderr)  # which has a slider of one piece
        done = rimpact("run", *halves, "--rung", "rigid-dish", "--dry-run")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_mass_below_the_sliders_is_refused(self):
        run = rimpact("check", "impact-window", "--set", "load.mass_kg=20", "--set", "load.vertical_kN=0.2")
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"load.mass_kg 20 is no more than the slider's own mass, 3[0-9]\.[0-9] kg")


class GoodScenes(unittest.TestCase):
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
            self.assertIn("rim's foot: one piece with the plate, assumed", rimpact("check", os.path.join(case, "scene.toml")).stdout)
            bolted = rimpact("check", os.path.join(case, "scene.toml"), "--set", 'bearing.rim.connection.kind="fillet"', "--set", "bearing.rim.connection.throat_mm=12")
            self.assertIn("rim's foot: two fillet welds with a throat of 12 mm, judged after every finite-element run", bolted.stdout)
            self.assertIn("assumed, not measured: nothing", rimpact("check", os.path.join(case, "scene.toml")).stdout)


if __name__ == "__main__":
    unittest.main()
