"""The report printed: its first section is one page, and where no browser is found a sentence says how."""
import os
import re
import shutil
import unittest
from unittest import mock

import synthetic_calibration
from small_results import DOUBT, SmallResults
from support import in_process, text_of, unpainted

from report import pdf
from report.build import build
from report.errors import IoError


@unittest.skipIf(pdf.browser() is None, "no Chromium is installed: the page is not printed")
class Printed(SmallResults):
    def pages_of_the_first_section(self, path):
        """Prints the first page alone; gives the number of pages."""
        page, _ = text_of(path)
        alone = self.write("alone.html", page[:page.index("<nav")].replace("break-after: page", "") + "</body></html>")
        self.assertIsNone(pdf.print_to(alone, self.path("alone.pdf")))
        with open(self.path("alone.pdf"), "rb") as file:
            return len(re.findall(rb"/Type\s*/Page\b", file.read()))

    def test_one_page_with_few_and_with_many_doubts(self):
        long = "The law holds from 0.07 to 0.5 m/s, where runs fitted and left out one at a time are met within 2.7 % in peak force and 2.5 % in rebound. "
        for n in (0, 4, 12):
            shutil.rmtree(self.path("runs"), ignore_errors=True)
            warnings = [f"{DOUBT}; smaller steps, a finer mesh or a tighter tolerance may mend it ({i})" for i in range(n)]
            path, _ = build(self.results(warnings=warnings, assumptions=[{"key": f"foot.some_length_{i}_mm", "value": "33"} for i in range(20)], validity=2 * long,
                                            law=synthetic_calibration.answer()["law"] | {"sentence": 3 * long}, mesh_error={"peak_force": None, "sentence": 2 * long}))
            self.assertEqual(self.pages_of_the_first_section(path), 1, n)

    def test_a_run_is_one_page(self):
        self.results(warnings=[DOUBT])
        self.assertEqual(self.pages_of_the_first_section(build(self.path("runs/window-0.20"))[0]), 1)


@unpainted
class Pdf(SmallResults):
    def test_without_a_browser_the_html_is_made_and_a_sentence_says_how(self):
        self.results()
        self.write("report.pdf", "of other results")
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            done = in_process("report", self.folder, "--pdf")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^rimpact report: no PDF: none of chromium, .* is installed\. Open .*report\.html .*\n$")
        self.assertTrue(os.path.exists(self.path("report.html")))
        self.assertFalse(os.path.exists(self.path("report.pdf")))

    def test_a_browser_that_fails_is_an_error(self):
        self.results()
        os.makedirs(self.path("bin"))
        os.chmod(self.write("bin/chromium", "#!/bin/sh\necho no display >&2\nexit 1\n"), 0o755)
        with mock.patch.dict(os.environ, PATH=self.path("bin") + ":/bin"), self.assertRaisesRegex(IoError, "made no PDF of .*no display"):
            pdf.print_to(build(self.folder)[0], self.path("report.pdf"))


if __name__ == "__main__":
    unittest.main()
