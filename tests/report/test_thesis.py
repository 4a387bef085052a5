"""The catalogue of the thesis: complete, every number compared or excused, ours kept, docs/thesis.md made of it."""
import json
import os
import re
import unittest

import numpy as np
from support import SOURCE, InFolder, command, in_process

from report.data_files import read_any_json
from report.errors import DataError, InputError
from report.style import plt
from report.thesis import catalogue as catalogues
from report.thesis import document, headlines, probabilities, refitted
from report.thesis.catalogue import Number
from report.thesis.results import Ours
from report.thesis.runs import Runs, value_of, value_without_cause
from report.thesis.spectrum import pseudo_acceleration

FIGURES = {"2": 39, "3": 26, "4": 25, "A": 4, "B": 2}
TABLES = {"2": 3, "3": 10, "4": 1, "C": 20}


class Catalogue(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.catalogue = catalogues.load()
        cls.ours = Ours("/nonexistent")

    def test_every_figure_and_table_is_there_once(self):
        ids = [name for entry in self.catalogue.entries for name in entry.ids]
        self.assertEqual(len(ids), len(set(ids)))
        for kind, numbers in (("fig", FIGURES), ("table", TABLES)):
            wanted = {f"{kind}-{chapter}-{k}" for chapter, n in numbers.items() for k in range(1, n + 1)}
            self.assertEqual(wanted, {name for name in ids if name.startswith(kind)})

    def test_every_number_can_be_judged(self):
        for entry in self.catalogue.entries:
            for number in entry.numbers:
                with self.subTest(f"{entry.id}: {number.what}"):
                    if number.why:
                        self.assertGreater(len(number.why), 5)
                        continue
                    self.assertTrue(number.at_least is not None or (number.printed is not None and number.within is not None))
                    if number.verdict(self.ours.of(entry, number)) == "not met":
                        self.assertTrue(number.cause.startswith("unknown") or number.without, "a cause is checked by a run, or unknown")

    def test_the_slider_study_is_there_number_by_number(self):
        tables = [self.catalogue.find(f"table-3-{k}") for k in range(2, 8)]
        self.assertEqual(sum(len(entry.numbers) for entry in tables), 162)

    def test_the_thirteen_results_of_abstract_and_conclusions_are_judged(self):
        found = {entry.section: [] for entry, _ in headlines.of(self.catalogue)}
        for entry, number in headlines.of(self.catalogue):
            found[entry.section].append(number.printed)
            self.assertIn(number.verdict(self.ours.of(entry, number)), ("met", "not met"), number.headline)
        self.assertEqual(found, {"2.5.3": [-5, -44, -11, -8, -6], "2.6.8": [-11, -9.5], "3.5": [-44, -57, -48, -56, -58], "4.8": [-20]})

    def test_the_frame_s_means_are_those_of_its_table(self):
        with open(os.path.join(SOURCE, "tests", "buildings", "frame_2_5.txt"), encoding="utf-8") as file:
            rows = re.findall(r"^  a = 0\.(\d+) R0 +(.*)$", file.read(), re.M)
        kept = read_any_json(os.path.join(SOURCE, "data", "thesis", "kept", "frame-2.5.json"))["changes_percent"]
        self.assertEqual({f"a0{a}": [float(word) for word in values.split()] for a, values in rows}, {a: list(means.values()) for a, means in kept.items()})

    def test_missing_and_drawn_entries_say_so(self):
        for entry in self.catalogue.entries:
            if entry.state in ("partly", "missing"):
                self.assertTrue(entry.differs, entry.id)
            if entry.state == "done":
                self.assertTrue(entry.panels or entry.numbers or entry.command, entry.id)

    def test_an_unknown_name_is_refused(self):
        with self.assertRaises(InputError):
            self.catalogue.find("fig-2-99")

    def test_the_page_is_made_of_the_catalogue(self):
        with open(os.path.join(SOURCE, "docs", "thesis.md"), encoding="utf-8") as file:
            self.assertEqual(file.read(), document.text(), "make it again: python3 -m report.thesis.document docs/thesis.md")


class Values(InFolder):
    class Runs:
        """Summaries by name."""

        def __init__(self, summaries):
            self.summaries = summaries

        def summary(self, name):
            return self.summaries.get(name)

    def test_terms_ratios_and_changes(self):
        runs = self.Runs({"a": {"x": 3.0, "list": [{"t": 4.0}]}, "b": {"x": 2.0}})
        for ours, factor, wanted in (("a:x", 10, 30), ("a:list.0.t", 1, 4), ("a:x / b:x", 1, 1.5), ("a:x / b:x - 1", 100, 50), ("a:list.1.t", 1, None),
                                     ("c:x", 1, None), ("a:x / c:x", 1, None), ("a:x; b:x", 2, 5), ("a:x / b:x - 1; b:x / a:x", 6, 3.5), ("a:x; c:x", 1, None)):
            value = value_of(Number("", ours=ours, factor=factor), runs)
            self.assertEqual(value_without_cause(Number("", without=ours, factor=factor), runs), value)
            self.assertEqual(value, wanted) if wanted is None else self.assertAlmostEqual(value, wanted, msg=ours)

    def test_a_reduction_of_a_kept_study(self):
        row = {"quantity": "ductility", "limit": 5.0, "value": "LIR 10 cm", "mean_reduction": 0.25, "largest_reduction": 0.5}
        runs = self.Runs({"s": {"study": "s", "differences": [row]}})
        self.assertEqual(value_of(Number("", ours="s:reduction largest ductility 5 LIR 10 cm", factor=-100), runs), -50)
        self.assertEqual(value_of(Number("", ours="s:reduction mean ductility 5 LIR 10 cm"), runs), 0.25)
        with self.assertRaisesRegex(DataError, "ductility 6"):
            value_of(Number("", ours="s:reduction mean ductility 6 LIR 10 cm"), runs)

    #: Two frames on rims without a gap and with two; the flexible one gains nothing.
    CURVES = {"study": "small", "limits": {"ductility": [1.0, 3.0]}, "systems": [
        {"of": {"case": case, "device": device, "r": r}, "ductility": [0.2, value]}
        for case, r, values in (("stiff", 0.1, (0.10, 0.09, 0.08)), ("soft", -0.1, (0.04, 0.04, 0.04)))
        for device, value in zip(("DCFP", "LIR 2 cm", "LIR 10 cm"), values)]}

    def test_reductions_over_the_gap(self):
        found = dict(probabilities.reductions(self.CURVES, [], "ductility", 3.0))
        np.testing.assert_allclose(found["stiff", "r 0.1"], [(0, 0), (2, 10), (10, 20)])
        np.testing.assert_allclose(found["soft", "r -0.1"], [(0, 0), (2, 0), (10, 0)])
        self.assertEqual(list(dict(probabilities.reductions(self.CURVES, ["case=soft"], "ductility", 3.0))), [("r -0.1",)])
        self.assertEqual(len(dict(probabilities.reductions(self.CURVES, ["r=0.1|-0.1"], "ductility", 3.0))), 2, "two values of a key are two curves")

    def test_systems_by_what_they_are(self):
        self.assertEqual([system["ductility"][1] for system in probabilities.systems_of(self.CURVES, ["r=0.10", "device=LIR 10 cm|LIR 2 cm"])], [0.09, 0.08])
        for named, said in (["r=0.2"], "no system with r=0.2"), (["gap=2"], "no key gap"):
            with self.assertRaisesRegex(DataError, said):
                probabilities.systems_of(self.CURVES, named)

    def test_every_curve_of_the_systems_is_drawn(self):
        class Runs:
            summary = staticmethod(lambda name: self.CURVES)
        panel = {"of": "small", "y": "ductility", "systems": ["case=stiff"], "colour": "device", "dashes": "r"}
        _, ax = plt.subplots()
        self.assertTrue(probabilities.draw_probabilities(ax, panel, Runs))
        np.testing.assert_allclose([line.get_ydata()[-1] for line in ax.get_lines()[:3]], [0.10, 0.09, 0.08])
        self.assertEqual(ax.get_legend_handles_labels()[1], ["DCFP", "LIR 2 cm", "LIR 10 cm", "r 0.1"])
        plt.close()

    def test_a_hazard_is_the_rate_of_its_return_periods(self):
        class Runs:
            @staticmethod
            def summary(name):
                return {"of": name, "hazard": [[0.1, 100.0], [0.4, 2000.0]]}
        _, ax = plt.subplots()
        self.assertTrue(probabilities.draw_hazard(ax, {"of": "small"}, Runs))
        np.testing.assert_allclose(ax.get_lines()[0].get_xydata(), [[0.1, 0.01], [0.4, 0.0005]])
        plt.close()

    def test_verdicts(self):
        self.assertEqual(Number("", printed=2, within=0.1, apart="an input").verdict(2.0), "apart")
        self.assertEqual(Number("", printed=2, within=0.1).verdict(2.09), "met")
        self.assertEqual(Number("", printed=2, within=0.1).verdict(1.8), "not met")
        self.assertEqual(Number("", at_least=1).verdict(0.99), "not met")
        self.assertEqual(Number("", printed=2, why="no").verdict(2.0), "not comparable")
        self.assertEqual(Number("", printed=2, within=1).verdict(None), "not run")

    def test_a_catalogue_that_makes_no_sense_is_refused(self):
        for text, needle in (('[[entry]]\nid = "x"\ntitle = "t"\nstate = "odd"\n', "odd"),
                             ('[[entry]]\nid = "x"\ntitle = "t"\nstate = "done"\n[[entry.number]]\nwhat = "n"\nprinted = 1\n', "says why not"),
                             ('[[entry]]\nid = "x"\ntitle = "t"\nstate = "done"\n[[entry.number]]\nwhat = "n"\nours = "r:v"\n', "the run r"), ("[", "TOML")):
            self.write("c.toml", text)
            with self.assertRaisesRegex(DataError, needle):
                catalogues.load(self.folder)

    def test_a_cause_of_no_number_and_a_second_one_are_refused(self):
        table = ('[[entry]]\nid = "x"\ntitle = "t"\nstate = "done"\n[[entry.table]]\ncolumns = ["force"]\npaths = ["peak"]\n'
                 '[[entry.table.row]]\nlabel = "a"\nrun = "r"\nprinted = [1]\n[run.r]\ncommand = ["run"]\n')
        cause = '[[entry.table.cause]]\nof = "{}"\nrows = ["{}"]\nrun = "r"\ncause = "c"\n'
        head, runs = table[:table.index("[run.r]")], table[table.index("[run.r]"):]
        for causes, needle in ((cause.format("depth", "a"), "depth, a, which the table has not"), (cause.format("force", "b"), "force, b, which"),
                               (2 * cause.format("force", "a"), "force, a has two causes")):
            self.write("c.toml", head + causes + runs)
            with self.assertRaisesRegex(DataError, needle):
                catalogues.load(self.folder)

    def test_spectrum_of_a_step_and_of_a_slow_record(self):
        periods = np.array([0.2, 1.0])
        step = pseudo_acceleration(0.01, np.ones(1000), periods, 1e-6)  # an undamped oscillator under a step: twice the static
        np.testing.assert_allclose(step, 2.0, rtol=2e-3)
        slow = pseudo_acceleration(0.01, np.sin(2 * np.pi * np.arange(4001) * 0.01 / 20), np.array([0.2]))
        np.testing.assert_allclose(slow, 1.0, rtol=5e-3)


class Listing(InFolder):
    def test_text_and_json_count_the_same(self):
        text = command("report.thesis", "list", "--program", "none", "--output", self.folder)
        self.assertEqual(text.returncode, 0, text.stderr)
        data = json.loads(in_process("report.thesis", "list", "--program", "none", "--output", self.folder, "--json").stdout)
        counts = data["counts"]
        self.assertIn(f"{counts['met']} met, {counts['not met']} not met", text.stdout)
        self.assertEqual(sum(counts.values()) > 900, True)
        self.assertIn("Mitigating the adverse effects", text.stdout)

    def test_a_place_that_cannot_be_written_or_read_is_a_sentence(self):
        file = self.write("taken", "")
        run = in_process("report.thesis", "fig-2-3", "--program", "/bin/false", "--output", file)
        self.assertEqual(run.returncode, 6, run.stderr)
        self.assertIn(file, run.stderr)
        self.assertNotIn("Traceback", run.stderr)
        run = in_process("report.thesis", "fig-2-3", "--program", "/bin/false", "--output", self.folder, "--records", os.path.join(self.folder, "nowhere"))
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("nowhere is no folder", run.stderr)

    def test_a_law_of_the_rims_replaces_the_assumed_one(self):
        catalogue = catalogues.load()
        rigid = [name for name, run in catalogue.runs.items() if run.has_two_dishes]
        self.assertGreater(len(rigid), 20)
        self.write("calibration.json", "{}")
        runs, assumed = (Runs(catalogue, "none", self.folder, self.folder, calibration=law) for law in (self.folder, ""))
        for name in catalogue.runs:
            words = runs.words(name)
            if name not in rigid:
                self.assertEqual(words, assumed.words(name))
                continue
            self.assertEqual(words[-2:], ["--calibration", self.folder])
            self.assertFalse([word for word in words if word.startswith(("reduced.impact_law", "reduced.k_i", "reduced.restitution"))])
            lost = [word for word in assumed.words(name) if word not in words]
            self.assertEqual(len(words), len(assumed.words(name)) + 2 - 2 * len(lost), "each setting goes with its --set")
            self.assertEqual(words.count("--set"), sum(word == "--set" for word in assumed.words(name)) - len(lost))

    def test_a_law_made_anew_makes_its_runs_anew(self):
        catalogue = catalogues.load()
        name = next(name for name, run in catalogue.runs.items() if run.has_two_dishes and not run.records)
        def runs() -> Runs:
            return Runs(catalogue, "/bin/true", self.folder, self.folder, quiet=True, calibration=self.folder)
        self.write("calibration.json", "{}")
        self.assertTrue(runs()._is_wanted(name))
        self.assertTrue(runs().make(name))
        self.assertFalse(runs()._is_wanted(name))
        self.write("calibration.json", '{"answer": 1}')
        self.assertTrue(runs()._is_wanted(name))

    def test_numbers_of_the_two_kinds_of_rims_are_kept_apart(self):
        entry = catalogues.load().find("fig-4-4")
        assumed, found = Ours(self.folder), Ours(self.folder, refitted=True)
        found.put(entry, [9.0] * len(entry.numbers), [])
        again = Ours(self.folder)
        self.assertEqual([again.of(entry, number) for number in entry.numbers], [assumed.of(entry, number) for number in entry.numbers])
        self.assertEqual(Ours(self.folder, refitted=True).of(entry, entry.numbers[0]), 9.0)

    def test_what_takes_no_law_says_so(self):
        run = in_process("report.thesis", "fig-4-4", "--program", "/bin/false", "--output", self.folder, "--calibration", os.path.join(self.folder, "none"))
        self.assertEqual((run.returncode, "holds no calibration.json" in run.stderr), (2, True), run.stderr)
        self.write("calibration.json", "{}")
        run = in_process("report.thesis", "fig-2-3", "--program", "/bin/false", "--output", self.folder, "--calibration", self.folder)
        self.assertEqual((run.returncode, "fig-2-3 has no bearing of two dishes" in run.stderr), (2, True), run.stderr)

    def test_the_page_has_what_the_found_rims_change(self):
        catalogue, assumed = catalogues.load(), Ours("/nonexistent")
        page = "\n".join(refitted.document(catalogue, assumed))
        numbers = read_any_json(refitted.KEPT)["numbers"]
        self.assertGreater(sum(map(len, numbers.values())), 300)
        changed, hardly = "base x, Newhall, DCFP", "ductility, DCFP 25 cm"
        before, after = assumed.values["table-3-10"][changed], numbers["table-3-10"][changed]
        self.assertIn(f"| table-3-10 | {changed} | 0.8600 g | {before:.3g} | {after:.3g} | {100 * (after / before - 1):+.0f} % |", page)
        self.assertNotIn(hardly, page)
        self.assertLess(abs(numbers["fig-4-4"][hardly] / assumed.values["fig-4-4"][hardly] - 1), refitted.NOTABLE)

    def test_what_is_missing_is_named(self):
        run = in_process("report.thesis", "table-3-2", "--program", "/bin/false", "--output", self.folder, "--records", self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("RSN1044_NORTHR_NWH360.AT2", run.stdout)
        run = in_process("report.thesis", "fig-3-5", "--program", "/bin/false", "--output", self.folder)
        self.assertIn("stages ended with 1", run.stdout)
