"""The client's two pages: every language has every word, says the same figures, and is printed where its letters can be."""
import csv
import os
import re
import shutil
import subprocess
import unittest
from unittest import mock

import synthetic_calibration
from small_results import SmallResults
from support import text_of

from report import client, pdf
from report.bearing import lateral_capacity
from report.client import facts, fonts, page, words
from report.context import Context
from report.errors import InputError

TRADE = {  # words that an engineer of the language looks for
    "es": ("aislador", "rigidez", "fluencia", "coeficiente de restitución"), "it": ("isolatore", "rigidezza", "snervamento", "coefficiente di restituzione"),
    "ja": ("支承", "剛性", "降伏", "反発係数"), "tr": ("izolatör", "rijitliği", "akma", "geri sıçrama")}


class Table(unittest.TestCase):
    def setUp(self):
        with open(words.TABLE, encoding="utf-8", newline="") as file:
            self.rows = list(csv.DictReader(file))

    def test_every_language_has_every_word(self):
        self.assertEqual(set(self.rows[0]), {"key", *words.LANGUAGES})
        self.assertEqual(len({row["key"] for row in self.rows}), len(self.rows))
        for row in self.rows:
            for language in words.LANGUAGES:
                self.assertTrue(row[language].strip(), f"{row['key']} has no word in {language}")
                self.assertEqual(row[language], row[language].strip())

    def test_no_language_is_another_left_as_it_was(self):
        alike = {"hunt-crossley", "mesh"}  # names, and a word that the trade has taken over
        for row in self.rows:
            for language in ("es", "ja", "tr"):
                if row["key"] not in alike | {"rebound"}:
                    self.assertNotEqual(row[language].lower(), row["en"].lower(), f"{row['key']} in {language}")

    def test_numbers_within_words_are_those_of_english(self):
        for row in self.rows:
            for language in words.LANGUAGES:
                self.assertEqual(re.findall(r"\d+", row[language]), re.findall(r"\d+", row["en"]), row["key"])

    def test_words_are_of_the_trade(self):
        for language, looked_for in TRADE.items():
            every = " ".join(row[language] for row in self.rows).lower()
            for word in looked_for:
                self.assertIn(word, every)

    def test_every_key_that_the_template_asks_for_is_there(self):
        known = {row["key"] for row in self.rows}
        template = os.path.join(os.path.dirname(page.page.__file__), "templates", "client.html.j2")
        with open(template, encoding="utf-8") as file:
            asked = set(re.findall(r'w\("([^"]+)"', file.read()))
        self.assertTrue(asked)
        self.assertEqual(asked - known, set())
        kept = set(facts.ORDER) | set(facts.QUANTITIES.values()) | {"of_law", "mesh", "step", "rung", "energy", "steel", "geometry", "left out", "fitted"}
        self.assertEqual(kept - known, set())
        laws = ("signed", "no-tension", "printed", "hunt-crossley", "elastoplastic", "bilinear", "curve")
        parameters = ("mu_fast", "mu_slow", "rate", "elastic_slip", "capacity_offset", "dent_spread")
        self.assertEqual({*laws, *parameters} - known, set())

    def test_an_unknown_language_is_named(self):
        with self.assertRaisesRegex(InputError, 'language "de" is not known; known are en, es, it, ja, tr'):
            words.Words("de")


class Pages(SmallResults):
    def made(self, language, **answer):
        """The page's text in a folder of its own, as it is read."""
        path, problems = client.build(self.results(**answer), language)
        self.assertEqual(problems, ["no main.json: totals and versions are not known"])
        return text_of(path)[1]

    def test_figures_are_equal_over_languages(self):
        shown = {language: self.made(language) for language in words.LANGUAGES}
        figures = {language: words.figures_of(text) for language, text in shown.items()}
        self.assertGreater(len(figures["en"]), 60)
        for language in words.LANGUAGES:
            self.assertEqual(figures[language], figures["en"], language)
            self.assertEqual("0,540" in shown[language], language in words.COMMA)
        for said in ("600\u202f000\u00a0kN/m", "0.400", "1600", "4.80", "18.0", "251\u202f000\u00a0kN/m", "86\u202f952\u00a0kg", "28\u202f%"):
            self.assertIn(said, shown["en"])

    def test_figures_are_those_of_the_record(self):
        answer = synthetic_calibration.answer()
        text = self.made("es")
        for row in answer["table"]:
            self.assertIn(f"{row['peak_force_kN']:.0f}", text)
            self.assertIn(f"{row['restitution']:.3f}".replace(".", ","), text)
        scene = Context(self.folder, self.folder, self.folder).scene
        self.assertIn(f"{1e3 * lateral_capacity(scene['bearing']):.1f}".replace(".", ","), text)

    def test_what_is_doubted_and_not_known_is_said(self):
        text = self.made("it")
        self.assertIn("Riserve del programma, in inglese", text)
        self.assertIn("The steel is strained beyond its limit at 1 m/s.", text)
        self.assertIn("passo temporale", text)  # a part of the error that is not known
        self.assertIn("Il limite è superato", text)
        bare = self.made("it", pair=None, strain=None, errors=[])
        self.assertIn("Non è data una coppia costante", bare)
        self.assertIn("Non nota: nessuna analisi", bare)

    def test_a_folder_without_a_law_is_refused(self):
        folder = self.results()
        shutil.rmtree(self.path("calibration"))
        with self.assertRaisesRegex(InputError, "holds no fitted law"):
            client.build(folder, "es")
        with self.assertRaisesRegex(InputError, "is no folder"):
            client.build("/nowhere", "es")

    def test_the_command_takes_a_language(self):
        folder, program = self.results(), os.environ["RIMPACT_PROGRAM"]
        done = subprocess.run([program, "report", folder, "--language", "it", "--client", "Acme"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, f"{self.path('client-it.html')}\n")
        self.assertIn("Committente Acme", text_of(self.path("client-it.html"))[1])
        refused = subprocess.run([program, "report", folder, "--language", "de"], capture_output=True, text=True, check=False)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("es", refused.stderr)

    def test_without_a_japanese_font_it_says_what_to_install(self):
        fonts.family_for.cache_clear()
        self.addCleanup(fonts.family_for.cache_clear)
        with mock.patch.object(fonts, "_has", lambda path, letter: False):
            self.assertIsNone(fonts.family_for("ja"))
            self.assertIn("apt-get install fonts-noto-cjk", fonts.missing("ja"))
            self.assertEqual(fonts.missing("tr"), "")
            self.assertIn("最大衝突力", self.made("ja"))

    def test_it_prints_on_two_pages(self):
        if pdf.browser() is None:
            self.skipTest("no Chromium is installed")
        for language in words.LANGUAGES:
            if fonts.missing(language):
                continue
            path, _ = client.build(self.results(), language)
            made = self.path(f"{language}.pdf")
            self.assertIsNone(pdf.print_to(path, made))
            with open(made, "rb") as file:
                self.assertEqual(len(re.findall(rb"/Type\s*/Page\b", file.read())), 2, language)

    def test_it_prints_japanese_letters(self):
        if pdf.browser() is None or fonts.missing("ja"):
            self.skipTest("no Chromium, or no font with Japanese letters, is installed")
        self.made("ja")
        with open(self.path("client-ja.html"), encoding="utf-8") as file:
            self.assertIn(f'font-family: "{fonts.family_for("ja")}"', file.read())


if __name__ == "__main__":
    unittest.main()
