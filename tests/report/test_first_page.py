"""The first page: what it says, from which record, and that nothing doubtful is passed over."""
import dataclasses
import json
import math
import os
import re
import unittest

import numpy as np
import synthetic
import synthetic_calibration
from small_results import DOUBT, SmallResults, first_page
from support import in_process, text_of, unpainted

from report import document
from report.build import build
from report.plain_words import for_page
from report.run_folder import load_run
from report.series import shown_part


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

    def test_errors_are_bars_on_one_scale_with_the_unknown_named(self):
        page, text = self.page()
        for said in ("Peak force steel 27 % 28 % not known: step", "k_i steel 54 % 54 %", "Strain – not known: mesh"):
            self.assertIn(said, re.sub(r"\s+", " ", re.sub(r"\s*<[^>]*>\s*", " ", text)).replace("k i", "k_i"))
        widths = [float(width) for width in re.findall(r'class="bar" style="width:([\d.]+)%"', page)]
        self.assertEqual(len(widths), 2)
        self.assertEqual(max(widths), 100.0)
        self.assertAlmostEqual(widths[0] / widths[1], math.hypot(0.27, 0.041) / 0.54, delta=2e-3)

    def test_strain_is_told_by_the_speeds_that_tell(self):
        rows = [{"speed_m_s": v, "strain": 0.3 * v} for v in (0.1, 0.2, 0.3, 0.5, 0.6, 0.7, 0.8, 1.0)]
        _, text = self.page(strain=synthetic_calibration.answer()["strain"] | {"rows": rows})
        self.assertIn("Plastic strain of the rim 3.0\u202f% at 0.10, 18.0\u202f% at 0.60, 21.0\u202f% at 0.70, 30.0\u202f% at 1.0", text)

    def test_what_is_not_known_has_its_command_and_nothing_is_no_part(self):
        said = "What is not known of step: rimpact study runs/a/scene.toml --axes step tells it (about 6 min)."
        errors = [*synthetic_calibration.answer()["errors"], {"quantity": "peak_force", "source": "geometry", "value": 0, "how": "measured", "from": "none"}]
        page, text = self.page(errors=errors, finding_sentences=[said])
        self.assertIn(said, text)
        self.assertNotIn('class="part geometry', page)
        self.assertIn("Peak force steel 27 % 28 % not known: step", re.sub(r"\s+", " ", re.sub(r"\s*<[^>]*>\s*", " ", text)))

    def test_a_record_without_errors_has_no_bars(self):
        self.assertNotIn("bar-row", self.page(errors=[])[0])

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

    def test_an_assumed_number_has_the_digits_that_say_something(self):
        _, text = self.page(assumptions=[{"key": "material.steel.hardening_Q_MPa", "value": "240.6377216927041"}, {"key": "rim.height_mm", "value": "60"}])
        self.assertIn("hardening_Q_MPa\u00a0240.638", text)
        self.assertIn("rim.height_mm\u00a060", text)

    def test_a_runs_own_report(self):
        self.results(warnings=[DOUBT])
        path, _ = build(self.path("runs/window-0.20"))
        self.assertIn(DOUBT, first_page(path)[1])

    def test_the_slip_of_a_sliders_halves_is_a_result(self):
        self.results()
        self.assertNotIn("Slip of the slider", first_page(build(self.path("runs/window-0.20"))[0])[1])
        with open(self.path("runs/window-0.20/summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        summary["interface"] = {"largest_interface_slip_m": 0.0194, "residual_interface_slip_m": 0.0101}
        self.write("runs/window-0.20/summary.json", json.dumps(summary))
        self.assertRegex(first_page(build(self.path("runs/window-0.20"))[0])[1], r"Slip of the slider's halves, largest and left\s+19\.4, 10\.1\u00a0mm")

    def test_a_run_strained_beyond_its_limit_says_so(self):
        self.results()
        name = self.path("runs/window-0.20/summary.json")
        with open(name, encoding="utf-8") as file:
            summary = json.load(file)
        summary["strain_limit"] = {"limit": 1e-6, "largest": 0.012, "place": None, "exceeded": True, "assumption": True}
        self.write("runs/window-0.20/summary.json", json.dumps(summary))
        _, text = first_page(build(self.path("runs/window-0.20"))[0])
        self.assertRegex(text, r"! Steel\. The largest plastic strain of any body, \d+\.\d\u202f%, exceeds the limit of 0\u202f% \(an assumption of ours\)")

    def test_steel_that_knows_its_rate_says_so(self):
        self.results()
        name = self.path("runs/window-0.20/scene.toml")
        with open(name, encoding="utf-8") as file:
            scene = file.read()
        self.assertNotIn("Steel at speed", first_page(build(self.path("runs/window-0.20"))[0])[1])
        rate = 'rate = "cowper-symonds"\nrate_D_per_s = 40.0 # assumption\nrate_q = 5.0\n'
        self.write("runs/window-0.20/scene.toml", scene.replace("tangent_modulus_MPa", rate + "tangent_modulus_MPa"))
        _, text = first_page(build(self.path("runs/window-0.20"))[0])
        self.assertRegex(text, r"Steel at speed grows with its rate, Cowper and Symonds, D\u00a040\u00a01/s \* , q\u00a05")

    def test_without_doubts_there_is_no_mark(self):
        page, text = self.page(doubts=[], strain=None, table=[], law=synthetic_calibration.answer()["law"] | {"parameters": {}})
        self.assertNotIn('class="mark"', page)


@unpainted
class SaidOnce(SmallResults):
    STRAINS = ("plastic strain reaches 21.0 %, above the 20 % that the steel is trusted to", "plastic strain reaches 56.6 %, above the 20 % that the steel is trusted to")

    def sentences(self, page):
        """Of the page's paragraphs and points, in words; numbers and signs are none. What is assumed is a list."""
        blocks = re.findall(r"<(?:p|li)(?: class=\"[^\"]*\")?>(.*?)</(?:p|li)>", re.sub(r"<p class=\"small assumptions\">.*?</p>", "", page, flags=re.S), flags=re.S)
        plain = (re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", block)) for block in blocks)
        return [[word for word in re.findall(r"\S+", sentence) if re.search("[A-Za-z]", word)] for block in plain for sentence in re.split(r"(?<=[.!?]) ", block)]

    def test_doubts_of_one_kind_are_one_line_with_their_count_and_the_worst(self):
        doubts = [f"window-{n}: {said}" for n, said in zip(("0.10", "1.20", "0.35"), (*self.STRAINS, self.STRAINS[0]))]
        page, text = self.page(doubts=[*doubts, "the rim was never touched"])
        self.assertIn("! 2 doubts", text)
        self.assertIn(f"3 alike, the worst: window-1.20: {self.STRAINS[1]}", text)
        self.assertNotIn("21.0", text)
        self.assertIn("the rim was never touched", text)

    def test_each_by_itself_stands_in_the_appendix(self):
        doubts = [f"window-{n}: {said}" for n, said in zip(("0.10", "1.20"), self.STRAINS)]
        page, _ = text_of(build(self.results(doubts=doubts))[0])
        listed = page[page.index('<section id="each-doubt" class="appendix">'):]
        for said in doubts:
            self.assertIn(said, listed)
        page, _ = text_of(build(self.results(doubts=doubts[:1]))[0])
        self.assertNotIn('id="each-doubt"', page)

    def test_no_sentence_is_longer_than_thirty_words(self):
        page, _ = self.page(warnings=[DOUBT, *self.STRAINS])
        found = self.sentences(page)
        self.assertGreater(len(found), 15)
        for words in found:
            self.assertLessEqual(len(words), 30, " ".join(words))
        self.assertGreater(max(map(len, self.sentences(f"<p>{'word ' * 31}end.</p>"))), 30)

    def test_numbers_have_three_figures_and_codes_are_left_out(self):
        code = "8bda7323b58640b6"
        long = f"Law x of the rim {code} of bearing b holds from 0.049989 to 1.23456 m/s"
        page, text = self.page(doubts=[f"the element was fitted to another rim ({code}; this one is {code[::-1]}): 12.3456 mm"], validity=long)
        self.assertIn("of the rim of bearing b holds from 0.0500 to 1.23 m/s", text)
        self.assertIn("fitted to another rim: 12.3 mm", text)
        whole, _ = text_of(build(self.results(validity=long))[0])
        self.assertNotRegex(re.sub(r'"[^"]*"', "", re.sub(r"<(script|style).*?</\1>", "", whole, flags=re.S)), r"\b[0-9a-f]{16}\b")
        for name in ("window-0.049989", "ricker-0.1234g", "v1.2345"):
            self.assertEqual(for_page(name), name)  # a name is no number

    def test_pad_and_foot_are_assumed_only_where_they_take_part(self):
        assumed = [{"key": key, "value": "1"} for key in ("rim.height_mm", "pad.thickness_mm", "foot.radius_mm", "material.ertalyte.density_kg_per_m3")]
        for rung, there in (("rim", False), ("rigid-dish", True), (["rim", "full"], True)):
            _, text = self.page(assumptions=assumed, rung=rung)
            self.assertIn("rim.height_mm", text)
            for key in ("pad.thickness_mm", "foot.radius_mm", "material.ertalyte"):
                self.assertEqual(key in text, there, (rung, key))
            self.assertEqual("Pad and foot do not take part" in text, not there)

    def test_a_window_is_drawn_to_the_end_of_its_impact(self):
        self.results()
        run = load_run(self.path("runs/window-0.20"))
        release = max(impact["release_time_s"] for impact in run.impacts)
        run.summary["impacts"] = run.impacts
        far = {name: np.concatenate([values, np.full(50, -0.35)]) for name, values in run.signals.items()}
        far["time"] = np.concatenate([run.time, run.time[-1] + 0.02 * np.arange(1, 51)])
        shown = shown_part(dataclasses.replace(run, signals=far))
        self.assertGreater(shown.time[-1], release)
        self.assertLess(shown.time[-1], release + max(0.03, 2 * release))
        self.assertGreater(shown.signals["displacement_x"].min(), -0.3)
        pulse = dataclasses.replace(run, scene={"excitation": {"kind": "ricker"}}, signals=far)
        self.assertIs(shown_part(pulse), pulse)


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
