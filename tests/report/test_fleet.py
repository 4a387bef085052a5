"""Sweeps: table.csv and fractiles.csv as the command writes them, their picture and their report."""
import json
import re
import unittest

import numpy as np
from support import InFolder, command, in_process, unpainted

from report import fleet
from report.errors import DataError

HEADER = "run,excitation.scale,reduced.mu_fast,reduced.mu_slow,status,peak_displacement_m,peak_lateral_force_N,peak_impact_force_N,n_impacts,first_touch_s,reason"


class Fleet(InFolder):
    def table(self, name="table.csv", first=1):
        rows = [HEADER]
        for i, (scale, mu) in enumerate(((s, m) for s in (0.8, 1.0, 1.2) for m in (0.05, 0.06, 0.08)), first):
            touched = int(scale > 0.9)
            rows.append(f'{i},{scale},{mu},{mu},"done",{0.4 * scale - mu},2e5,{1e6 * touched * scale},{touched},{2.1 if touched else ""},""')
        rows.append(f'{first + 9},1.2,0.09,0.09,"stopped",,,,,,"step, too small"')
        self.write(name, "\n".join(rows) + "\n")

    def fractiles(self):
        rows = ["excitation.scale,n_runs,p16_peak_displacement_m,p50_peak_displacement_m,p84_peak_displacement_m"]
        rows += [f"{s},3,{0.4 * s - 0.08},{0.4 * s - 0.06},{0.4 * s - 0.05}" for s in (0.8, 1.0, 1.2)]
        self.write("fractiles.csv", "\n".join(rows) + "\n")

    def test_what_was_varied(self):
        self.table()
        read = fleet.read(self.folder)
        self.assertEqual(read.parameters, ["excitation.scale", "reduced.mu_fast", "reduced.mu_slow"])
        self.assertEqual(read.varied, ["excitation.scale", "reduced.mu_fast"])
        self.assertEqual(read.status.count("done"), 9)
        self.assertTrue(np.isnan(read.columns["first_touch_s"][0]))

    def test_shards_are_one_table(self):
        self.table("table-1-of-2.csv")
        self.table("table-2-of-2.csv", 11)
        self.assertEqual(len(fleet.read(self.folder).status), 20)

    @unpainted
    def test_a_run_counts_once_and_missing_shards_are_said(self):
        self.table("table-1-of-2.csv")
        self.table("table-1-of-3.csv", 6)
        self.write("fleet.json", '{"n_runs": 30}')
        read = fleet.read(self.folder)
        self.assertEqual(list(read.columns["run"]), list(range(1, 16)))
        self.assertEqual(read.n_due, 30)
        self.assertEqual(in_process("report", self.folder).returncode, 0)
        with open(self.path("report.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("Sweep of 15 of 30 runs", page)
        self.assertIn("15 of 30 runs are here: the other shards are missing", page)

    def test_pictures_with_and_without_fractiles(self):
        self.table()
        self.assertEqual(in_process("report.quick", "fleet", self.folder).returncode, 0)
        with open(self.path("fleet.png"), "rb") as file:
            scatter = file.read()
        self.fractiles()
        self.assertEqual(in_process("report.quick", "fleet", self.folder).returncode, 0)
        with open(self.path("fleet.png"), "rb") as file:
            self.assertNotEqual(file.read(), scatter)

    def test_the_report(self):
        self.table()
        self.fractiles()
        done = command("report", self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("1 of 10 runs did not end well", page)
        panels = json.loads(re.search(r'<script class="curves" type="application/json">(.*?)</script>', page).group(1))
        self.assertEqual([p["title"] for p in panels], ["Peak displacement", "Runs that touch the rim"])
        self.assertNotIn("What is missing", page)

    @unpainted
    def test_hits_beyond_the_laws_range_are_said_and_the_unknown_is_not_nil(self):
        self.table()
        limits = {"n_hits": 320, "slowest_approach_speed_m_s": 0.02, "fastest_approach_speed_m_s": 1.8, "known_from_m_s": 0.05,
                  "known_to_m_s": 0.2, "hits_beyond_fit": 310, "share_beyond_fit": 0.96875, "hits_beyond_pair": None,
                  "share_beyond_pair": None, "hits_beyond_rim": 0, "share_beyond_rim": 0.0, "hits_beyond_steel": None,
                  "share_beyond_steel": None, "doubts": ["97 % of the hits lie outside <the speeds>"]}
        self.write("limits.json", json.dumps(limits))
        self.assertEqual(in_process("report", self.folder).returncode, 0)
        with open(self.path("report.html"), encoding="utf-8") as file:
            page = file.read()
        for words in ("97 % of the hits lie outside &lt;the speeds&gt;", "96.9", "known for 0.0500 to 0.200 m/s"):
            self.assertIn(words, page)
        self.assertEqual(page.count("not known"), 4)  # number and share of the pair and of the steel
        self.write("limits.json", "[1]")
        self.assertEqual(in_process("report", self.folder).returncode, 3)

    @unpainted
    def test_fractiles_by_another_key(self):
        self.table()
        rows = ["record,excitation.scale,n_runs,p16_peak_displacement_m,p50_peak_displacement_m,p84_peak_displacement_m"]
        rows += [f'"{name}",{s},3,0.3,{0.3 + 0.1 * s},{"" if s > 1 else 0.4}' for name in ("NGA 1", "NGA 2") for s in (0.8, 1.2)]
        self.write("fractiles.csv", "\n".join(rows) + "\n")
        read = fleet.read(self.folder)
        self.assertEqual((read.along, read.groups), ("excitation.scale", ["NGA 1", "NGA 1", "NGA 2", "NGA 2"]))
        self.assertEqual(in_process("report.quick", "fleet", self.folder).returncode, 0)
        self.assertEqual(in_process("report", self.folder).returncode, 0)
        with open(self.path("report.html"), encoding="utf-8") as file:
            panels = json.loads(re.search(r'<script class="curves" type="application/json">(.*?)</script>', file.read()).group(1))
        self.assertEqual([line["label"] for line in panels[0]["lines"]], ["NGA 1", "NGA 2"])

    def test_damage_is_said(self):
        self.write("table.csv", "a,b\n1,2\n")
        with self.assertRaisesRegex(DataError, "no column run"):
            fleet.read(self.folder)
        self.write("table.csv", HEADER + "\n1,2\n")
        with self.assertRaisesRegex(DataError, "as many cells"):
            fleet.read(self.folder)
        self.write("table.csv", HEADER + "\n")
        self.assertEqual(in_process("report", self.folder).returncode, 3)


if __name__ == "__main__":
    unittest.main()
