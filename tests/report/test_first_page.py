"""The first page: what it says, from which record, and that nothing doubtful is passed over."""
import json
import os
import re
import unittest

import synthetic
import synthetic_calibration
from small_results import DOUBT, SmallResults, first_page
from support import in_process, text_of, unpainted

from report import document
from report.build import build


@unpainted
class Answer(SmallResults):
    def test_the_record_is_what_is_said(self):
        _, text = self.page()
        for said in ("Law elastoplastic", "600\u202f000\u00a0kN/m 5.88 to 6.12 × 10⁵", "900\u00a0kN 882 to 918", "The law belongs to the rim",
                     "0.400 1600 4.80 18.0 0.540 2.1\u202f% 3.4\u202f% runs left out", "runs fitted", "Worst errors there: peak force 3.1\u202f%, rebound 4.4\u202f%.",
                     "251\u202f000 kN/m", "1790 kN s/m", "0.10 to 0.20 m/s", "The law holds within 5 % from 0.1 to 0.75 m/s",
                     "The plastic strain exceeds the limit of 20 % above 0.3 m/s", "limit 20\u202f%, an assumption of ours",
                     "Peak forces lie within about 1.5 % of a finer mesh.", "The steel is strained beyond its limit at 1 m/s.",
                     "86\u202f952\u00a0kg", "853\u00a0kN", "520\u00a0mm", "60\u00a0mm * high, 40\u00a0mm * thick", "rim.height_mm\u00a060; rim.thickness_mm\u00a040."):
            self.assertIn(said, re.sub(r"\s*<[^>]*>\s*", " ", text).replace("  ", " "))

    def test_what_is_not_identifiable_carries_a_mark(self):
        self.assertRegex(self.page()[1], r"unloading gain 0\.400 0\.320 to 0\.480 ! flat")

    def test_rows_outside_the_fit_carry_a_mark(self):
        self.assertRegex(self.page()[1], r"1\.000 ! 4000 .*outside the speeds the law was fitted to")

    def test_no_pair_says_why(self):
        _, text = self.page(pair=None, no_pair="No constant pair is met within 20 % at three neighbouring speeds.")
        self.assertIn("Constant pair No constant pair is met within 20 %", text)
        self.assertNotIn("251", text)

    def test_a_calibration_without_an_answer_gives_no_numbers(self):
        self.results()
        synthetic_calibration.calibration(self.folder, [])
        _, text = first_page(build(self.folder)[0])
        self.assertIn("holds no answer: it was made by an earlier version", text)
        self.assertNotIn("4.10", text)

    def test_the_published_pair_belongs_to_the_published_bearing(self):
        for applies in (True, False):
            synthetic.run(self.path("published/window-0.20"), "window-0.20", 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0,
                          synthetic.Rim(4.5e8, 0.65), "reduced", 0.2)
            text = text_of(build(self.results(published_applies=applies))[0])[1]
            self.assertEqual("published" in text.lower(), applies)

    def test_another_laws_run_is_not_drawn_as_the_answers(self):
        self.results()
        os.rename(self.path("law"), self.path("reduced"))
        path, _ = build(self.folder)
        self.assertIn('id="first"', text_of(path)[0])
        name = self.path("reduced/window-0.20/scene.toml")
        with open(name, encoding="utf-8") as file:
            scene = file.read()
        self.write("reduced/window-0.20/scene.toml", scene.replace("elastoplastic", "signed"))
        os.remove(self.path("figures/law.png"))
        _, text = first_page(build(self.folder)[0])
        self.assertIn("the law's picture is not drawn", text)
        self.assertFalse(os.path.exists(self.path("figures/law.png")))


@unpainted
class Doubts(SmallResults):
    def test_every_warning_is_there_in_full_and_its_rows_are_marked(self):
        path, _ = build(self.results(warnings=[DOUBT, "penetration 90 mm beyond the rim's thickness of 40 mm"]))
        page, first = text_of(path)[0], first_page(path)[1]
        self.assertIn(f"window-0.20: {DOUBT}", first)
        self.assertIn("window-0.20: penetration 90 mm beyond the rim's thickness of 40 mm", first)
        for chapter in ("windows", "energy", "speed", "inputs", "rim"):
            if f'<section id="{chapter}">' in page:
                body = page[page.index(f'<section id="{chapter}">'):]
                self.assertIn('<b class="mark"', body[:body.index("</section>")], chapter)
        for chapter in ("windows", "energy", "speed", "inputs"):
            self.assertIn(f'<section id="{chapter}">', page)

    def test_a_stopped_run_is_a_doubt(self):
        path, _ = build(self.results(status="stopped", truncate=0.4))
        self.assertIn("window-0.20: stopped: step fell below 1e-7 s; what is shown of it is partial", first_page(path)[1])

    def test_what_main_says_of_a_row_and_of_all(self):
        self.results()
        with open(self.path("main.json"), "w", encoding="utf-8") as file:
            json.dump({"runs": [{"name": "window-0.20", "role": "window"}], "warnings": ["the BLAS is slow", "window-0.20: it left the dish"],
                       "comparison": [{"name": "window-0.20", "doubts": ["it left the dish"]}]}, file)
        path, _ = build(self.folder)
        for said in ("window-0.20: it left the dish", "the BLAS is slow"):
            self.assertEqual(first_page(path)[1].count(said), 1)

    def test_a_run_that_a_sentence_names_is_marked_too(self):
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer((0.1, 0.2), doubts=["results/runs/window-0.10: it slips"]))
        page, _ = text_of(build(self.folder)[0])
        laws = page[page.index('<section id="laws">'):]
        self.assertIn('<b class="mark"', laws[:laws.index("</section>")])
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer((0.1, 0.2), doubts=["results/runs/window-0.101: it slips"]))
        page, _ = text_of(build(self.folder)[0])
        laws = page[page.index('<section id="laws">'):]
        self.assertNotIn('<b class="mark"', laws[:laws.index("</section>")])

    def test_a_runs_own_report(self):
        self.results(warnings=[DOUBT])
        path, _ = build(self.path("runs/window-0.20"))
        self.assertIn(DOUBT, first_page(path)[1])

    def test_a_run_strained_beyond_its_limit_says_so(self):
        self.results()
        name = self.path("runs/window-0.20/scene.toml")
        with open(name, encoding="utf-8") as file:
            scene = file.read()
        self.write("runs/window-0.20/scene.toml", scene.replace("[load]", "strain_limit = 1e-6 # assumption\n[load]"))
        _, text = first_page(build(self.path("runs/window-0.20"))[0])
        self.assertRegex(text, r"! Steel\. The largest plastic strain, \d+\.\d\u202f%, exceeds the limit of 0\u202f% \(an assumption of ours\)")

    def test_without_doubts_there_is_no_mark(self):
        page, text = self.page(doubts=[], strain=None, table=[], law=synthetic_calibration.answer()["law"] | {"parameters": {}})
        self.assertNotIn('class="mark"', page)


@unpainted
class Head(SmallResults):
    def test_what_is_given_is_escaped_and_goes_before_what_is_stored(self):
        self.results()
        with open(self.path("main.json"), "w", encoding="utf-8") as file:
            json.dump({"document": {"title": "stored", "client": "Stored & Co", "author": None}}, file)
        toml = self.write("d.toml", 'client = "From File"\nproject = "P <1>"\n')
        done = in_process("report", self.folder, "--title", "<script>alert(1)</script>", "--document", toml, "--author", 'A "B"')
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        page, text = first_page(self.path("report.html"))
        self.assertNotIn("<script", page)
        for said in ("<script>alert(1)</script>", "From File", "P <1>", 'A "B"'):
            self.assertIn(said, __import__("html").unescape(page))
        self.assertNotIn("Stored", page)

    def test_a_wrong_document_is_the_users_mistake(self):
        self.results()
        for content, said in (('clint = "x"', 'unknown key "clint"; did you mean "client"?'), ("title = 3", "title must be a text, got 3"), ("title", "TOML")):
            done = in_process("report", self.folder, "--document", self.write("d.toml", content))
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"^rimpact report: .+\n$")
            self.assertIn(said, done.stderr)

    def test_the_first_that_is_given_counts(self):
        one, other = document.Document(title="a"), document.Document("b", "c")
        self.assertEqual(one.or_else(other), document.Document("a", "c"))


if __name__ == "__main__":
    unittest.main()
