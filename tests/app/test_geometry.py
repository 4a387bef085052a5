"""The geometry study with a stand-in for the finite elements (stand_in_fe.py): shards, what is kept, what is written."""
import csv
import json
import os
import tempfile
import unittest

from command import rimpact

STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in_fe.py")


class Geometry(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder, self.log = os.path.join(temporary.name, "study"), os.path.join(temporary.name, "calls")

    def geometry(self, *arguments, **more):
        return rimpact("geometry", "-o", self.folder, *arguments, RIMPACT_FE_PROGRAM=STAND_IN, STAND_IN_LOG=self.log, **more)

    def calls(self):
        with open(self.log) as file:
            return len(file.read().splitlines())

    def test_shards_add_up_and_nothing_is_run_twice(self):
        first = self.geometry("--samples", "12", "--shard", "1/2", "--json")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual(len(json.loads(first.stdout)["rows"]), 6)
        second = self.geometry("--samples", "12", "--shard", "2/2", "--json")
        self.assertEqual(len(json.loads(second.stdout)["rows"]), 12)
        self.assertEqual(self.calls(), 12)
        again = self.geometry("--samples", "12", "--json")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(self.calls(), 12)
        study = json.loads(again.stdout)
        for row in study["rows"]:  # the pair the stand-in has, whatever the dimensions
            self.assertAlmostEqual(row["k_i"] / 2.0e5, 1, places=4)
            self.assertAlmostEqual(row["e"], 0.4, places=4)
        self.assertLess(study["surrogates"]["k_i"]["left_out_error_largest"], 1e-3)
        with open(os.path.join(self.folder, "geometry.csv")) as file:
            self.assertEqual(len(list(csv.DictReader(file))), 12)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "geometry.png")), 1000)
        wanted = self.geometry("--samples", "12", "--pair", "2e5,0.4", "--json")  # the stand-in's e knows no speed: no rim can be told
        self.assertEqual(wanted.returncode, 0, wanted.stderr)
        self.assertEqual(self.calls(), 12)
        self.assertIsNone(json.loads(wanted.stdout)["pair"])

    def test_a_run_that_stops_does_not_lose_the_others(self):
        run = self.geometry("--samples", "4", "--json", STAND_IN_FAIL="g002")
        self.assertEqual(run.returncode, 4, run.stderr)
        self.assertEqual([row["name"] for row in json.loads(run.stdout)["rows"]], ["g000", "g001", "g003"])

    def test_whose_load_is_flown_is_said_everywhere(self):
        case = os.path.join(os.path.dirname(self.folder), "case")
        os.makedirs(case)
        for name, text in (("bearing.toml", '[slider]\ndiameter_mm = 200.0\n'),
                           ("scene.toml", '[bearing]\nfile = "bearing.toml"\n[load]\nvertical_kN = 3400.0\n[excitation]\nkind = "ricker"\n')):
            with open(os.path.join(case, name), "w", encoding="utf-8") as file:
                file.write(text)
        bearing, scene = os.path.join(case, "bearing.toml"), os.path.join(case, "scene.toml")
        for words, kN, whose in (([], 853, "the thesis's, an assumption"), ([bearing], 853, "the thesis's, an assumption"), ([scene], 3400, "scene.toml:4"),
                                 ([case], 3400, "scene.toml:4"), ([bearing, "--set", "load.vertical_kN=3400"], 3400, "--set load.vertical_kN=3400")):
            with self.subTest(words=words):
                run = self.geometry(*words, "--samples", "3", "--force")
                self.assertEqual(run.returncode, 0, run.stderr)
                for said in (run.stderr, run.stdout):
                    self.assertIn(f"load: dead load {kN} kN ({whose.replace('the ', 'default: the ')}" if kN == 853 else f"load: dead load {kN} kN (", said)
                    self.assertIn(whose, said)
                self.assertEqual("no load is given" in run.stderr, words == [bearing])
                with open(os.path.join(self.folder, "geometry.json"), encoding="utf-8") as file:
                    study = json.load(file)
                self.assertEqual((study["load"]["vertical_kN"], study["load"]["assumed"]), (kN, kN == 853))
                self.assertEqual(any("no load is given" in sentence for sentence in study["warnings"]), words == [bearing])
                with open(os.path.join(self.folder, "geometry.csv"), encoding="utf-8") as file:
                    rows = list(csv.DictReader(file))
                self.assertEqual({float(row["vertical_kN"]) for row in rows}, {kN})
                self.assertEqual({round(float(row["mass_kg"])) for row in rows}, {86952 if kN == 853 else round(3400e3 / 9.81)})
                with open(os.path.join(self.folder, "runs", "g000", "scene.toml"), encoding="utf-8") as file:
                    text = file.read()
                self.assertIn(f"vertical_kN = {kN}.0", text)
                self.assertEqual("# assumption: dead load" in text, kN == 853)

    def test_bearing_keys_are_read(self):
        run = self.geometry("--samples", "3", "--set", "bearing.rim.thickness_mm=30.0", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual({row["rim_thickness"] for row in json.loads(run.stdout)["rows"]}, {30.0})

    def test_bad_words_are_refused(self):
        for words, said in ((["--shard", "3/2"], "--shard 3/2"), (["--range", "rim_height"], "NAME=LOW:HIGH"),
                            (["--range", "rim_hight=50:70"], "did you mean"), (["--samples", "1"], "samples 1"), (["--samples", "10001"], "from 3 to 10000"),
                            (["--range", "speed=0.5:0.1"], "LOW < HIGH"), (["--pair", "4.5e5,1.2"], "e 1.2"),
                            (["--pair", "4.5e5"], "--pair")):
            run = self.geometry(*words)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)


if __name__ == "__main__":
    unittest.main()
