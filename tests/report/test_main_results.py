"""The whole report of a results folder as `rimpact main` leaves it, every picture painted."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import unittest

import numpy as np
import synthetic_results
from PIL import Image
from support import text_of

from report import pdf
from report.build import build


def filled(page: pathlib.Path) -> float:
    """The share of a printed page's height above its last ink; its foot line does not count."""
    dark = np.asarray(Image.open(page).convert("L")) < 180
    rows = np.flatnonzero(dark[:int(0.95 * len(dark))].any(axis=1))
    return (rows[-1] + 1) / len(dark) if len(rows) else 0.0


class MainResults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.folder = cls.holder.name
        synthetic_results.main_folder(cls.folder, pulses=synthetic_results.PULSES[:1], speeds=(0.1, 0.3, 1.0))
        start = time.process_time()
        cls.path, cls.problems = build(cls.folder)
        cls.seconds = time.process_time() - start
        cls.page, cls.text = text_of(cls.path)

    @classmethod
    def tearDownClass(cls):
        cls.holder.cleanup()

    def test_nothing_is_missing(self):
        self.assertEqual(self.problems, [])
        self.assertNotIn("not run", self.text)
        self.assertNotIn("could not be drawn", self.text)

    def test_one_file_and_no_links_out(self):
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:image/webp;base64,|#)', self.page), [])
        self.assertNotRegex(self.page, r"https?://|<script[^>]* src|@import|url\(|fetch\(")
        self.assertLess(len(self.page), 12e6)

    @unittest.skipIf(pdf.browser() is None or not shutil.which("pdftoppm"), "no Chromium or no pdftoppm (poppler-utils): the report is not printed")
    def test_no_printed_page_is_half_empty(self):
        printed = os.path.join(self.folder, "printed.pdf")
        self.assertIsNone(pdf.print_to(self.path, printed))
        subprocess.run(["pdftoppm", "-r", "30", "-gray", printed, os.path.join(self.folder, "sheet")], check=True)
        shares = [filled(page) for page in sorted(pathlib.Path(self.folder).glob("sheet-*.pgm"))]
        self.assertGreater(len(shares), 5)
        self.assertEqual([(n, share) for n, share in enumerate(shares[:-1], 1) if share < 0.5], [])  # the last one ends where it ends

    def test_the_answer_comes_first(self):
        answer = self.text.index("The answer")
        self.assertLess(answer, self.text.index("Behind the first page"))
        self.assertLess(self.text.index("Behind the first page"), self.text.index("1 Inputs and assumptions"))

    def test_every_rung_of_both_pulses_is_shown_with_time_and_error(self):
        speed = self.text[self.text.rindex("Speed beside error"):]
        for pulse in ("ricker-0.78g-1.0s", "ricker-0.38g-1.5s"):
            self.assertIn(f"Every rung on {pulse}", speed)
            self.assertTrue(os.path.exists(os.path.join(self.folder, "figures", f"speed-rungs-{pulse}.png")))
        for rung in ("reduced", "rim-mesh1", "rigid-dish-mesh1", "full-mesh1"):
            self.assertIn(rung, speed)

    def test_errors_belong_to_the_forces_beside_them(self):
        forces = {}
        for place in ("runs", "reduced"):
            with open(os.path.join(self.folder, place, "ricker-0.78g-1.0s", "summary.json"), encoding="utf-8") as file:
                forces[place] = json.load(file)["peak_impact_force_N"]
        error = 100 * (forces["reduced"] / forces["runs"] - 1)
        self.assertIn(f"reduced, pair (signed) {forces['reduced'] / 1e3:.0f} {error:+.1f}\u202f%", self.text)
        self.assertIn("0.78\u00a0g, 1.0\u00a0s predicted, not fitted +3.1\u202f%", self.text)  # of `prediction`, for the law fitted by itself

    def test_assumptions_are_marked(self):
        self.assertEqual(self.page.count('class="assumed"'), 8)
        self.assertRegex(self.text, r"thickness of the rim 40 mm assumption")

    def test_pictures_lie_beside(self):
        names = set(os.listdir(os.path.join(self.folder, "figures")))
        for name in ("law", "bearing", "response-ricker-0.78g-1.0s", "impacts-ricker-0.78g-1.0s-x1.10", "ki-and-e-over-speed",
                     "windows-force", "calibration-errors", "calibration-residuals", "calibration-parameters",
                     "critical-amplitudes", "energy", "speed-time-split", "rim-ricker-0.78g-1.0s-x1.10"):
            self.assertIn(name + ".png", names)
        self.assertFalse([name for name in names if name.endswith(".part")])

    def test_every_section_and_scene_is_there(self):
        for section in ("inputs", "histories", "rim", "windows", "calibration", "laws", "comparison", "critical", "energy",
                        "speed", "reproducibility", "conventions"):
            self.assertRegex(self.page, f'<section id="{section}"( class="appendix")?>')
        self.assertEqual(self.page.count("<details>"), 6)
        self.assertIn("deal.II", self.text)

    def test_the_published_pair_is_beside_ours(self):
        # synthetic windows: k_i = 5.2e5 (1 - 0.5 v), so that 0.3 m/s is nearest to 4.5e5
        for said in ("The published values beside this fit", "The rim softens with speed", "the one at 0.30 m/s comes nearest"):
            self.assertIn(said, self.text)

    def test_laws_are_ranked(self):
        for said in ("elastoplastic the answer 3.0\u202f% 3.0\u202f% 3.0\u202f% 6.0\u202f% 6.0\u202f% 0.10 to 0.50",
                     "signed 20.0\u202f% 20.0\u202f% 20.0\u202f% 40.0\u202f% 40.0\u202f% nowhere",
                     "The law that leaves least unexplained", "(v / 1 m/s) −0.80", "A constant pair serves from 0.1 to 0.2 m/s only.",
                     "inside, fitted 0.100 +3.1\u202f% −2.0\u202f%"):
            self.assertIn(said, self.text)

    def test_quick_enough(self):
        self.assertLess(self.seconds, 60)  # processor time, about 4 s


if __name__ == "__main__":
    unittest.main()
