"""compare: what differs between scenes comes first; what cannot be compared is refused."""
import json
import os
import shutil
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from command import rimpact


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        for name, settings in {"a": [], "stiff": ["reduced.k_i_kN_per_m=5e5"], "faster": ["excitation.speed_m_per_s=0.2"],
                               "heavier": ["load.mass_kg=100000"], "other": ["bearing.rim.height_mm=58"]}.items():
            words = [word for setting in settings for word in ("--set", setting)]
            run = rimpact("reduced", "impact-window", "-o", cls.path(name), "--quiet", *words)
            assert run.returncode == 0, run.stderr

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.shared.name, name)

    def test_settings_of_the_model_may_differ(self):
        run = rimpact("compare", self.path("a"), self.path("stiff"))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("reduced.k_i_kN_per_m", run.stdout)
        self.assertLess(run.stdout.index("reduced.k_i_kN_per_m"), run.stdout.index("peak impact force"))
        self.assertRegex(run.stdout, r"peak impact force +\+5\.\d+ %")  # sqrt(5 / 4.5) = 1.054
        table = json.loads(rimpact("compare", self.path("a"), self.path("stiff"), "--json").stdout)
        self.assertEqual(table["differences"], [{"key": "reduced.k_i_kN_per_m", "a": "450000", "b": "500000", "comparable": True}])
        self.assertAlmostEqual(table["peak_force_error"], (5 / 4.5) ** 0.5 - 1, places=3)

    def test_other_motion_load_or_bearing_is_refused(self):
        for other, key in (("faster", "excitation.speed_m_per_s"), ("heavier", "load.mass_kg"), ("other", "bearing.rim.height_mm")):
            run = rimpact("compare", self.path("a"), self.path(other))
            self.assertEqual(run.returncode, 2, other)
            self.assertIn(key, run.stderr)
            self.assertIn("--anyway", run.stderr)
            run = rimpact("compare", self.path("a"), self.path(other), "--anyway", "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(key, [each["key"] for each in json.loads(run.stdout)["differences"] if not each["comparable"]])

    def test_more_than_two_have_a_column_each(self):
        run = rimpact("compare", self.path("a"), self.path("stiff"), self.path("faster"), "--anyway")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("B against A", run.stdout)
        self.assertIn("C against A", run.stdout)

    def test_pictures_of_any_number_and_of_any_kind(self):
        drawn = self.path("drawn")
        arguments = [self.path("a"), self.path("stiff"), self.path("faster/response.h5"), self.path("heavier/response.csv")]
        run = rimpact("compare", *arguments, "--anyway", "-o", drawn)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("D against A", run.stdout)
        self.assertTrue(run.stdout.endswith("compare.html\n"))
        for name in ("compare.html", "figures/response.png", "figures/impacts.png"):
            self.assertGreater(os.path.getsize(os.path.join(drawn, name)), 1000, name)
        with open(os.path.join(drawn, "compare.html"), encoding="utf-8") as file:
            page = file.read()
        for text in ("reduced.k_i_kN_per_m", "excitation.speed_m_per_s", "peak impact force"):
            self.assertIn(text, page)
        table = json.loads(rimpact("compare", *arguments, "--anyway", "-o", drawn, "--json").stdout)
        self.assertEqual(table["page"], os.path.join(drawn, "compare.html"))

    def window(self, name, *settings):
        words = [word for setting in settings for word in ("--set", setting)]
        rimpact("reduced", "impact-window", "-o", self.path(name), "--quiet", *words)
        return self.path(name)

    def metrics(self, *runs):
        run = rimpact("compare", *runs, "--anyway", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def test_approach_rebound_and_restitution_are_told_apart(self):
        """A signed law returns e of every speed: a quicker approach is a quicker rebound, and no other restitution."""
        slow, quick = self.window("slow"), self.window("quick", "excitation.speed_m_per_s=0.22")
        table = self.metrics(slow, quick)
        self.assertGreater(table["approach_speed_error"], 0.05)
        self.assertAlmostEqual(table["rebound_error"], table["approach_speed_error"], places=4)
        self.assertAlmostEqual(table["restitution_error"], 0, places=4)
        for title in ("approach speed ", "rebound speed ", "restitution "):
            self.assertIn("\n" + title, rimpact("compare", slow, quick, "--anyway").stdout)

    def test_an_impact_that_is_not_let_go_has_no_rebound(self):
        still = self.window("open", "excitation.duration_s=0.008")
        with open(os.path.join(still, "summary.json"), encoding="utf-8") as file:
            impact = json.load(file)["impacts"][0]
        self.assertEqual([impact[key] for key in ("release_time_s", "rebound_speed_m_s", "restitution")], [None] * 3)
        self.assertGreater(impact["peak_force_N"], 0)
        for pair, who in (((self.path("a"), still), "candidate"), ((still, self.path("a")), "reference")):
            table = self.metrics(*pair)
            self.assertIsNone(table["rebound_error"])
            self.assertIn(f"the {who} ends while the rim is pressed", " ".join(table["notes"]))

    def test_a_record_that_begins_too_late_says_nothing_of_the_touch(self):
        pulse = self.path("pulse")
        rimpact("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "-o", pulse, "--quiet")
        with open(os.path.join(pulse, "response.csv"), encoding="utf-8") as file:
            head, *rows = file.read().splitlines()
        touch = self.metrics(pulse, pulse)["touch_time_difference_s"]
        self.assertEqual(touch, 0)
        for begin, force, said in ((2.463, 0, "no touch to compare"), (2.6, None, "nothing says how hard it hits")):
            late = self.path(f"late-{begin}.csv")
            with open(late, "w", encoding="utf-8") as file:
                file.write("\n".join([head, *(row for row in rows if float(row.split(",")[0]) >= begin)]) + "\n")
            table = self.metrics(pulse, late)
            self.assertIsNone(table["touch_time_difference_s"])
            self.assertIn(said, " ".join(table["notes"]))
            self.assertEqual(table["peak_force_error"] is None, force is None)

    def test_noise_of_a_bare_table_is_not_contact(self):
        noisy = self.path("noisy.csv")
        with open(noisy, "w", encoding="utf-8") as file:
            file.write("time_s,ux_m,uy_m,Fx_N,Fy_N,Ix_N,Iy_N\n")
            for k in range(1000):
                force = 1e6 * max(0.0, 1 - abs(k - 500) / 20)
                file.write(f"{1e-3 * k},{0.4 - 1e-4 * abs(k - 500)},0,0,0,{-force - 1e3 * (1 + k % 3)},0\n")
        run = rimpact("compare", noisy, noisy)
        self.assertEqual(run.returncode, 3)
        self.assertIn("noise", run.stderr)
        self.assertIn("mapping file", run.stderr)

    def test_a_planar_table_needs_no_y(self):
        planar = self.path("planar.csv")
        with open(planar, "w", encoding="utf-8") as file:
            file.write("time_s,ux_m,Fx_N,Ix_N\n" + "".join(f"{1e-3 * k},{0.39 + 1e-4 * k},0,{-1e6 * max(0, 20 - abs(k - 120))}\n" for k in range(200)))
        self.assertEqual(self.metrics(planar, planar)["peak_force_error"], 0)

    def test_a_rim_that_pushes_outwards_meets_no_limit(self):
        outwards = self.path("outwards.csv")
        with open(outwards, "w", encoding="utf-8") as file:
            file.write("time_s,ux_m,Fx_N,Ix_N\n" + "".join(f"{1e-3 * k},{0.39 + 1e-4 * k},0,{1e6 * max(0, 20 - abs(k - 120))}\n" for k in range(200)))
        self.assertIn("wrong sign", self.metrics(outwards, outwards)["doubts"][outwards])
        run = rimpact("compare", outwards, outwards, "--max", "peak=5")
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("pushes outwards with 2e+04 kN at 0.12 s", run.stderr)

    def test_what_is_assumed_and_doubted_is_said(self):
        tables = [os.path.join(self.path(name), "response.csv") for name in ("a", "stiff")]
        bare = [self.path(f"bare-{k}.csv") for k in (0, 1)]
        for path, copy in zip(tables, bare):
            shutil.copy(path, copy)
        run = rimpact("compare", *bare)
        self.assertIn("L_c = 400 mm, that of shfps-225, is assumed", run.stderr)
        self.assertNotIn("is assumed", rimpact("compare", *bare, "--capacity-mm", "200").stderr)
        self.assertEqual(json.loads(rimpact("compare", *bare, "--capacity-mm", "200", "--json").stdout)["lateral_capacity_m"], 0.2)
        deep = self.window("deep", "excitation.speed_m_per_s=5")
        doubts = self.metrics(self.path("a"), deep)["doubts"]
        self.assertIn("its forces are no result", doubts[deep])

    def test_settings_that_a_run_does_not_read_are_no_difference(self):
        solid = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../data/references/window-0.10")
        keys = {each["key"]: each for each in self.metrics(solid, self.path("a"))["differences"]}
        self.assertEqual((keys["solved by"]["a"], keys["solved by"]["b"]), ("rigid-dish", "reduced"))
        self.assertFalse([key for key in keys if key.startswith(("model.", "reduced."))])

    def test_a_missing_column_is_named_with_its_file(self):
        path = self.path("bare.csv")
        with open(path, "w") as file:
            file.write("time_s,ux_m,Fx_N\n0,0,0\n0.1,0.01,5\n")
        for order in ((self.path("a"), path), (path, self.path("a"))):
            run = rimpact("compare", *order)
            self.assertEqual(run.returncode, 3)
            self.assertIn("bare.csv", run.stderr)
            self.assertIn("Ix_N", run.stderr)

    def test_limits_make_a_test_of_it(self):
        """sqrt(5 / 4.5) of the force is 5.4 %: met by 6, missed by 5."""
        met = rimpact("compare", self.path("a"), self.path("stiff"), "--max", "peak=6,time_ms=0.1", "--max", "rebound=1")
        self.assertEqual(met.returncode, 0, met.stderr)
        for title, words in (("peak impact force", "within 6 %"), ("rebound speed", "within 1 %"), ("first touch", "within 0.1 ms")):
            self.assertRegex(met.stdout, rf"{title} +met   {words}\n")
        self.assertNotIn("limits", rimpact("compare", self.path("a"), self.path("stiff")).stdout)
        missed = rimpact("compare", self.path("a"), self.path("stiff"), self.path("a"), "--max", "peak=5,rebound=1")
        self.assertEqual(missed.returncode, 5)
        self.assertRegex(missed.stdout, r"peak impact force +NOT MET +met   within 5 %")
        self.assertRegex(missed.stderr, r"error: 1 of 4 limits are not met: B: peak impact force: \+5\.4\d % against A, within 5 % is allowed")
        table = json.loads(rimpact("compare", self.path("a"), self.path("stiff"), "--max", "peak=5", "--json").stdout)
        (limit,) = table["candidates"][0]["limits"]
        self.assertEqual((limit["name"], limit["met"], limit["limit"], limit["unit"]), ("peak", False, 5, "%"))
        self.assertAlmostEqual(limit["value"], 100 * table["peak_force_error"])
        self.assertEqual(len(table["figures"]), 9)

    def test_what_is_not_known_or_no_result_meets_no_limit(self):
        still, deep = self.window("still-pressed", "excitation.duration_s=0.008"), self.window("too-deep", "excitation.speed_m_per_s=5")
        for pair, limit, said in (((self.path("a"), still), "rebound=1000", "ends while the rim is pressed"), ((deep, deep), "peak=5", "its forces are no result")):
            run = rimpact("compare", *pair, "--max", limit)
            self.assertEqual(run.returncode, 5, run.stderr)
            self.assertIn(said, run.stderr)

    def test_verdicts_for_continuous_integration(self):
        odd = self.path('a <b> & "c"')
        shutil.copytree(self.path("stiff"), odd)
        junit = self.path("verdicts.xml")
        run = rimpact("compare", self.path("a"), odd, "--max", "peak=5,rebound=1", "--junit", junit)
        self.assertEqual(run.returncode, 5, run.stderr)
        (suite,) = ElementTree.parse(junit).getroot().findall("testsuite")
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("2", "1", "0"))
        cases = {case.get("name"): case for case in suite.iter("testcase")}
        self.assertEqual([case.get("classname") for case in cases.values()], [odd, odd])
        self.assertIn("within 5 % is allowed", cases["peak impact force within 5 %"].findtext("failure"))
        self.assertIsNone(cases["rebound speed within 1 %"].find("failure"))

    def test_a_folder_whose_name_is_no_text_stands_in_readable_xml(self):
        odd, junit = os.fsencode(self.path("odd-")) + b"\xff", self.path("odd.xml")
        shutil.copytree(os.fsencode(self.path("stiff")), odd)
        self.assertEqual(rimpact("compare", self.path("a"), os.fsdecode(odd), "--max", "peak=10", "--junit", junit).returncode, 0)
        self.assertIn("odd-\ufffd", next(ElementTree.parse(junit).getroot().iter("testcase")).get("classname"))

    def test_limits_that_cannot_be_are_refused(self):
        for words, said in ((["--max", "peek=5"], 'did you mean "peak"'), (["--max", "peak=-1"], "from 0"), (["--max", "peak=nan"], "from 0"), (["--max", "peak"], "NAME=VALUE"),
                            (["--max", "peak=1,peak=6"], "given twice"),
                            (["--junit", self.path("none.xml")], "--max peak=5")):
            run = rimpact("compare", self.path("a"), self.path("stiff"), *words)
            self.assertEqual(run.returncode, 2, words)
            self.assertIn(said, run.stderr)


if __name__ == "__main__":
    unittest.main()
