"""Reports of laboratory tables by their mapping files. The command reads the table: RIMPACT_PROGRAM says where it is."""
import math
import os
import shutil
import unittest

import synthetic_calibration
from small_results import first_page
from support import SOURCE, InFolder, in_process, text_of, unpainted

from report import mapping_file, measured_page
from report.build import build
from report.errors import InputError

EXAMPLE = os.path.join(SOURCE, "examples", "laboratory-curve")
KNOWN = shutil.which("rimpact") or os.environ.get("RIMPACT_PROGRAM")


class Mapping(InFolder):
    def test_which_files_are_mappings(self):
        self.assertTrue(mapping_file.is_mapping(os.path.join(EXAMPLE, "test-07.toml")))
        for content in ("[bearing]\nname = \"a\"\n", "columns = 3\n", "not toml", ""):
            self.assertFalse(mapping_file.is_mapping(self.write("a.toml", content)))
        self.assertFalse(mapping_file.is_mapping(self.path("absent.toml")))

    def test_a_report_inside_the_file_is_refused(self):
        path = os.path.join(EXAMPLE, "test-07.toml")
        with self.assertRaisesRegex(InputError, "-o FILE.html"):
            measured_page.build(path, os.path.join(path, "report.html"))


@unittest.skipUnless(KNOWN, "the command rimpact is not built")
class Page(InFolder):
    def test_the_table_is_drawn(self):
        w, mass, speed = 71.94, 86952.0, 0.1  # half a swing against a spring
        swing = [math.sin(w * 2e-4 * i) for i in range(220)]
        rows = [f"{0.2 * i:.1f};{400 + 1e3 * speed / w * s:.5f};{1e-3 * mass * speed * w * max(0.0, s):.3f}".replace(".", ",") for i, s in enumerate(swing)]
        rows.insert(0, "t;travel;cell")
        self.write("a.csv", "\n".join(rows) + "\n")
        mapping = self.write("a.toml", 'scene = "impact-window"\nset = ["excitation.speed_m_per_s=0.1", "excitation.duration_s=0.044"]\nfile = "a.csv"\n'
                             '[columns.time]\ncolumn = "t"\nunit = "ms"\n[columns.displacement_x]\ncolumn = "travel"\nunit = "mm"\n'
                             '[columns.impact_x]\ncolumn = "cell"\nunit = "kN"\nfactor = -1.0\n')
        done = in_process("report", mapping, "--output", self.path("a.html"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.path("a.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("Measured curve a", page)
        self.assertIn("220 instants, one every 0.200 ms", page)
        self.assertIn("625.5", page)
        self.assertEqual(page.count('class="curves"'), 2)

    def test_the_commands_own_sentence(self):
        self.write("a.csv", "t;travel\n0;1\n1;2\n")
        mapping = self.write("a.toml", 'scene = "impact-window"\nfile = "a.csv"\n[columns.time]\ncolumn = "zeit"\nunit = "ms"\n')
        done = in_process("report", mapping, "--output", self.path("a.html"))
        self.assertEqual(done.returncode, 3)
        self.assertIn("zeit", done.stderr)


class Laboratory(InFolder):
    def test_measured_curves_are_headed_and_drawn_as_such(self):
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer(source="measured", rung="measured", mesh=None, strain=None, published_applies=False,
                                                                 mesh_error={"peak_force": None, "sentence": ""}))
        synthetic_calibration.curves(self.path("calibration"))
        path, problems = build(self.folder)
        page, text = text_of(path)
        self.assertIn("Impact law fitted to measured curves", first_page(path)[1])
        self.assertIn("Measured curves and their fit", text)
        self.assertRegex(text, r"test-04 0\.200 800 776 −3\.0\u202f% 2\.00")
        for name in ("law", "measured-1-test-04", "measured-2-test-07", "bearing"):
            self.assertTrue(os.path.exists(self.path("figures", f"{name}.png")), name)
        for chapter in ("histories", "rim", "stack", "comparison", "energy", "speed", "building"):
            self.assertNotIn(f'id="{chapter}"', page)
            self.assertNotIn(f'href="#{chapter}"', page)
        for absent in ("inite-element reference", "finite-element runs", "hardening hardening", "published", "hardest impact"):
            self.assertNotIn(absent, text)
        self.assertEqual([problem for problem in problems if "drawn" in problem], [])

    @unpainted
    def test_without_the_curves_it_says_so(self):
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer(source="measured"))
        text = text_of(build(self.folder)[0])[1]
        self.assertIn("the measured curves are not drawn", text)


if __name__ == "__main__":
    unittest.main()
