"""rimpact reliability: from a study file to its tables and its report, and what it refuses."""
import csv
import json
import math
import os
import tempfile
import unittest

import h5py
import numpy as np
from command import rimpact

HEAD = """scene = "frame-four-dof"
[set]
excitation.duration_s = 8.0
[intensity]
period_s = 3.0
[motions]
folders = ["records"]
table = "table.csv"
level_is = "intensity_g"
scale = "level"
[hazard]
points = [[0.1129, 475], [0.26227, 2475]]
[[limit]]
quantity = "peak_displacement_m"
values = [0.1, 0.3]
[[limit]]
quantity = "ductility"
values = [1.0, 4.0]
[[limit]]
quantity = "collapsed"
[grid]
bearing.surface.a_m = [2.25, 0.5625]
[latin_hypercube]
samples = 3
reduced.mu_fast = { mean = 0.05, deviation = 0.01155, low = 0.03, high = 0.07 }
[linked]
reduced.mu_slow = { product = [0.5, "reduced.mu_fast"] }
[[difference]]
key = "bearing.surface.a_m"
reference = 2.25
[bootstrap]
replicates = 20
"""
TABLE = "\ufefflevel;rsn;component;factor\n0,1;1;A000.AT2;1,5\n0,1;2;B000.AT2;1\n0,4;1;A000.AT2;6\n0,4;7;C000.AT2;1\n"


def at2(period):
    values = [0.25 * math.sin(2 * math.pi * 0.01 * i / period) if i < 400 else 0.0 for i in range(600)]
    return "PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 600, DT= .01 SEC\n" + "\n".join(f"{v:.6e}" for v in values) + "\n"


class Reliability(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        os.mkdir(self.path("records"))
        for name, period in (("RSN1_A000", 1.0), ("RSN2_B000", 1.7)):
            self.write(f"records/{name}.AT2", at2(period))
        self.write("table.csv", TABLE)
        self.write("study.toml", HEAD)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def run_study(self, *options):
        return rimpact("reliability", self.path("study.toml"), "-o", self.path("out"), *options)

    def test_all_runs_of_a_study_are_one_lazy_table(self):
        done = self.run_study("--quiet", "--no-report")
        self.assertEqual(done.returncode, 0, done.stderr)
        frames = []
        for system in ("0001", "0002"):
            with open(self.path(f"out/systems/{system}/table.csv"), encoding="utf-8") as file:
                frames += list(csv.DictReader(file))
        moved = self.path("moved")  # paths in it are relative: the folder may go elsewhere
        os.rename(self.path("out"), moved)
        with h5py.File(f"{moved}/runs.h5") as file:
            table = file["table"]
            self.assertTrue(table["peak_displacement_m"].is_virtual)
            self.assertEqual(len(frames), 2 * 3 * 3)
            self.assertEqual(list(table["system"]), [1.0] * 9 + [2.0] * 9)
            self.assertEqual(list(table["bearing.surface.a_m"]), [2.25] * 9 + [0.5625] * 9)
            self.assertEqual(list(table["record"].asstr()), [row["record"] for row in frames])
            for column in ("run", "reduced.mu_fast", "peak_displacement_m", "ductility"):
                np.testing.assert_array_equal(table[column][:], [float(row[column]) for row in frames], column)
            np.testing.assert_array_equal(np.isnan(table["first_touch_s"]), [row["first_touch_s"] == "" for row in frames])
            self.assertEqual(table["peak_displacement_m"][10], float(frames[10]["peak_displacement_m"]))  # a row alone
        self.assertLess(os.path.getsize(f"{moved}/runs.h5"), 60_000)

    def test_the_shelf_serves_a_study_that_names_no_folder(self):
        own = rimpact("reliability", self.path("study.toml"), "-o", self.path("out"), "--dry-run", RIMPACT_RECORDS="/nowhere")
        self.assertEqual(own.returncode, 0, own.stderr)
        self.assertNotIn("RIMPACT_RECORDS", own.stderr)
        self.write("study.toml", HEAD.replace('folders = ["records"]\n', ""))
        shelf = rimpact("reliability", self.path("study.toml"), "-o", self.path("out"), "--dry-run", RIMPACT_RECORDS=self.path("records"))
        self.assertEqual(shelf.returncode, 0, shelf.stderr)
        self.assertIn("(RIMPACT_RECORDS)", shelf.stderr)
        self.assertEqual(rimpact("reliability", self.path("study.toml"), "-o", self.path("out"), "--dry-run", RIMPACT_RECORDS="").returncode, 2)

    def table(self, name):
        with open(self.path(f"out/{name}.csv"), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_a_record_given_twice_moves_no_rate(self):
        study = HEAD.replace('table = "table.csv"\nlevel_is = "intensity_g"\nscale = "level"\n', "").replace(
            "period_s = 3.0\n", "period_s = 3.0\nlevels_g = [0.1, 0.2, 0.4]\n")
        self.write("study.toml", study)
        self.assertEqual(self.run_study("--no-report").returncode, 0)
        once = [float(row["rate_per_year"]) for row in self.table("reliability")]
        self.assertTrue(any(once))
        for name, period in (("RSN9_AGAIN000", 1.7), ("RSN8_AGAIN000", 1.0)):
            self.write(f"records/{name}.AT2", at2(period))
        self.assertEqual(rimpact("reliability", self.path("study.toml"), "-o", self.path("twice"), "--no-report").returncode, 0)
        with open(self.path("twice/reliability.csv"), encoding="utf-8") as file:
            twice = [float(row["rate_per_year"]) for row in csv.DictReader(file)]
        for a, b in zip(once, twice, strict=True):
            self.assertLessEqual(abs(a - b), 1e-12 * a)

    def test_from_a_study_to_its_report(self):
        done = self.run_study("--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads(done.stdout)
        self.assertEqual((summary["n_systems"], summary["n_runs"], summary["n_runs_without_result"]), (2, 18, 0))
        self.assertIn("RSN 7 C000.AT2 at 0.4 g: no file at hand", summary["missing"][0])
        self.assertEqual(len(self.table("reliability")), 2 * 5)
        self.assertEqual(len(self.table("difference")), 5)
        for row in self.table("fragility"):
            self.assertLessEqual(float(row["low"]), float(row["probability"]) + 1e-12)
            self.assertLessEqual(float(row["probability"]), 1)
        for name in ("report.html", "ida.h5", "reliability.json", "motions.csv"):
            self.assertTrue(os.path.exists(self.path("out/" + name)), name)
        again = self.run_study("--no-report", "--json")
        self.assertEqual(json.loads(again.stdout)["kept"], 18)

    def test_shards_then_gathering(self):
        for shard in ("1/2", "2/2"):
            self.assertEqual(self.run_study("--shard", shard).returncode, 0)
        self.assertFalse(os.path.exists(self.path("out/reliability.json")))
        self.assertEqual(json.loads(self.run_study("--json", "--no-report").stdout)["kept"], 18)

    def test_the_plan_runs_little_and_writes_nothing(self):
        done = self.run_study("--dry-run", "--json")
        plan = json.loads(done.stdout)
        self.assertEqual((plan["n_runs"], plan["n_motions"], plan["n_listed"]), (18, 3, 4))
        self.assertGreater(plan["core_hours"], 0)
        once = json.loads(self.run_study("--dry-run", "--json", "--samples", "1").stdout)
        self.assertEqual(once["n_runs"], 6)
        self.assertFalse(os.path.exists(self.path("out")))

    def test_samples_of_a_study_that_draws_none_are_refused(self):
        head, tail = HEAD.split("[latin_hypercube]")
        self.write("study.toml", head + tail[tail.index("[[difference]]"):])
        done = self.run_study("--samples", "2")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("latin_hypercube.samples", done.stderr)

    def test_refusals(self):
        cases = [("study.toml", HEAD.replace("[[limit]]", "[[limits]]"), 2, "limits"),
                 ("study.toml", HEAD.replace("[0.26227, 2475]", "[0.26227, 400]"), 2, "not monotone"),
                 ("table.csv", TABLE.replace("1,5", "0"), 3, "table.csv:2"),
                 ("table.csv", TABLE + "0,4;1;A000.AT2;6\n0,4;1;A000.AT2;6\n", 3, "more than once"),
                 ("records/RSN1_A000.AT2", "no record", 3, "RSN1_A000.AT2")]
        for name, text, code, words in cases:
            with self.subTest(words):
                self.setUp()
                self.write(name, text)
                done = self.run_study()
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
