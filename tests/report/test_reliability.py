"""The report of a reliability study, from tables made up here."""
import csv
import json
import unittest

from support import InFolder, in_process


def rows(systems, quantity, limits, **columns):
    return [{"system": s, "bearing.surface.a_m": a, "case": case, "quantity": quantity, "limit": limit, **columns}
            for s, (a, case) in enumerate(systems, 1) for limit in limits]


class Reliability(InFolder):
    def table(self, name, content):
        with open(self.path(name + ".csv"), "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(content[0]))
            writer.writeheader()
            writer.writerows(content)

    def study(self, missing=(), hits=None, **reliability):
        systems = [(a, case) for case in ("stiff", "soft") for a in (2.25, 0.5625)]
        levels, q, limits = [0.1, 0.3], "ductility", [1.0, 2.0, 4.0]
        self.table("ida", [{"system": s, "bearing.surface.a_m": a, "case": c, "quantity": q, "level_g": x, "p16": x, "p50": 2 * x,
                            "p84": "" if x > 0.2 else 3 * x} for s, (a, c) in enumerate(systems, 1) for x in levels])
        self.table("fragility", [r | {"level_g": x, "probability": x, "low": x / 2, "high": 2 * x}
                                 for r in rows(systems, q, limits) for x in levels])
        self.table("reliability", rows(systems, q, limits, rate_per_year=1e-3, rate_above_levels=1e-4, probability=0.05,
                                       probability_low=0.03, probability_high=0.08, probability_most=0.09, n_unknown=3, probability_if_none=0.0444,
                                       probability_if_all=0.0555, **reliability))
        self.table("difference", rows([systems[1]], q, limits, reduction=0.11, reduction_low=0.02, reduction_high=0.2))
        self.table("levels", [r | {"level_g": x, "share": 0.5} for r in rows(systems, q, limits) for x in levels])
        self.table("records", rows(systems, q, limits, record="RSN<68>", share=0.4))
        self.table("sensitivity", rows(systems, q, limits, key="reduced.mu_fast", elasticity=-1.5))
        summary = {"study": "two <systems>", "scene": "frame", "years": 50.0, "period_s": 3.0, "n_systems": 4, "samples": 15,
                   "keys": ["bearing.surface.a_m", "case"], "confidence": 0.9, "replicates": 60,
                   "hazard": [[0.05, 100.0], [0.4, 10000.0]],
                   "levels": [{"level_g": x, "return_period_years": 475.0, "n_records": 17, "n_listed": 30} for x in levels],
                   "differences": [{"key": "bearing.surface.a_m", "value": 0.5625, "quantity": q, "limit": 2.0, "n_systems": 2,
                                    "mean_reduction": 0.11, "least_reduction": 0.1, "largest_reduction": 0.12,
                                    "n_systems_whose_band_excludes_0": 2}],
                   "doubts": ["a doubt"], "missing": list(missing), "hits": hits}
        self.write("reliability.json", json.dumps(summary))

    def report(self):
        done = in_process("report.reliability", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("report.html"), encoding="utf-8") as file:
            return file.read()

    def test_every_picture_and_table_is_there(self):
        self.study(["t.csv:3: RSN 9: no file at hand"])
        html = self.report()
        self.assertEqual(html.count("data:image/webp"), 6)  # hazard, IDA, fragility, reliability, reduction, shares
        for words in ("two &lt;systems&gt;", "RSN&lt;68&gt;", "1 listed motions are not at hand", "11 %", "2 of 2", "-1.50", "17", "12: 4.440e-02 to 5.550e-02"):
            self.assertIn(words, html)
        self.assertNotIn("What is missing", html)

    def test_what_the_levels_leave_open_is_a_range(self):
        unsettled = {"settled": 0, "probability_range_low": 2e-3, "probability_range_high": 0.4}
        self.study(**unsettled)
        html = self.report()
        self.assertIn("<b>a range</b>", html)
        self.assertIn("2.0e-03 to 4.0e-01", html)
        self.assertNotIn("5.000e-02", html)  # no single number
        self.study(**unsettled | {"settled": 1})
        html = self.report()
        self.assertNotIn("a range</b>", html)
        self.assertIn("5.000e-02", html)

    def test_hits_beyond_the_law_are_shown_and_the_unknown_said(self):
        self.study(hits={"n_hits": 50, "slowest_approach_speed_m_s": 0.01, "fastest_approach_speed_m_s": 1.5, "known_to_m_s": 0.22,
                         "hits_beyond_pair": 17, "share_beyond_pair": 0.34, "hits_beyond_fit": None, "share_beyond_fit": None})
        html = self.report()
        for words in ("34.0", "known for up to 0.220 m/s", "not known"):
            self.assertIn(words, html)

    def test_a_folder_that_is_no_study_is_refused(self):
        done = in_process("report.reliability", self.folder)
        self.assertEqual(done.returncode, 3)
        self.assertIn("reliability.json", done.stderr)
        self.write("reliability.json", "[]")
        self.assertIn("no summary", in_process("report.reliability", self.folder).stderr)


if __name__ == "__main__":
    unittest.main()
