"""The page with sliders over the rims of `geometry --vary`: its numbers in a real browser, against a law with a closed form."""
import json
import math
import os
import pathlib
import re
import subprocess
import unittest

from support import InFolder, in_process

from report import pdf
from report.design_page import build, is_design
from report.errors import DataError, InputError

POWER, MASS, LIMIT = 0.4, 80000.0, 0.2


def scale(thickness):
    return 6e6 * (thickness / 50) ** 0.5


def rim(thickness, severity):
    """K d^n takes m v^2 / 2; a quarter of the work comes back."""
    work = severity**2 / 2
    depth = ((POWER + 1) * work / scale(thickness)) ** (1 / (POWER + 1))
    return {"peak_kN": 1e-3 * scale(thickness) * depth**POWER, "depth_mm": 1e3 * depth, "rebound_m_per_s_sqrt_kg": severity / 2, "strain": 2 * depth * 50 / thickness}


def study(thicknesses, **more):
    severities = [250.0 * k / 80 for k in range(81)]
    points = [{"name": f"thickness_mm-{t}", "at": [t],
               "over_severity": {"severity_m_per_s_sqrt_kg": severities, **{name: [rim(t, s)[name] for s in severities] for name in rim(t, 1.0)}}} for t in thicknesses]
    answer = {"design": [thicknesses[0]], "reached": True, "force_error": 0.02, "sentence": "", "proof": None}
    return {"vary": [{"key": "rim.thickness_mm", "values": thicknesses}], "points": points, "speed_m_per_s": 0.5, "mass_kg": MASS, "strain_limit": LIMIT,
            "targets": {"peak_kN": 2000.0}, "curve_error": {"force": 0.0198, "restitution": 0.0149}, "answer": answer, "sentence": "Take </script> 30 mm.",
            "bearing": {"name": "own"}, "load": {"vertical_kN": 785, "vertical_from": "test"}, "mesh": 1, "warnings": ["a doubt"], "command": "rimpact geometry", **more}


class DesignPage(InFolder):
    def write(self, name, content):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        return super().write(name, content)

    def page(self, made):
        self.write("study/geometry.json", json.dumps(made))
        path, problems = build(self.path("study"))
        self.assertEqual(problems, [])
        return path

    def shown(self, path, **state):
        """The page's text by element, as a browser has it."""
        program = pdf.browser()
        if program is None:
            self.skipTest("no Chromium is installed")
        words = "&".join(f"{key}={value}" for key, value in state.items())
        done = subprocess.run([program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.path('profile')}", "--dump-dom",
                               pathlib.Path(path).resolve().as_uri() + "#" + words], capture_output=True, text=True, timeout=110)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def number(self, page, name):
        return float(re.search(rf'<td id="{name}">([\d.]+)', page)[1])

    def test_a_browser_shows_what_the_rims_do(self):
        path = self.page(study([30, 45, 60]))
        for thickness, speed, mass in ((45, 0.5, MASS), (38, 0.3, MASS), (52, 0.61, 1.2 * MASS)):
            page = self.shown(path, x=thickness, speed=speed, mass=mass, target=2500)
            law = rim(thickness, speed * math.sqrt(mass))
            for name in ("peak_kN", "depth_mm", "strain"):
                self.assertAlmostEqual(self.number(page, name) / law[name], 1, delta=6e-3, msg=(name, thickness))  # three figures are shown
            self.assertAlmostEqual(self.number(page, "rebound") / (speed / 2), 1, delta=6e-3)

    def test_limits_are_judged_with_the_error_on_top(self):
        path = self.page(study([30, 45, 60]))
        force = rim(45, 0.5 * math.sqrt(MASS))["peak_kN"]
        for share, said in ((0.97, "not met"), (1.01, "met but for its error"), (1.05, "met")):
            self.assertRegex(self.shown(path, x=45, speed=0.5, mass=MASS, target=round(share * force, 3)), rf'id="peak_kN">.*?{said}</td></tr>')

    def test_one_rim_has_no_values_beside_it_and_two_no_error(self):
        self.assertIn("not known", self.shown(self.page(study([30, 60])), x=45, speed=0.5, mass=MASS))
        self.assertAlmostEqual(self.number(self.shown(self.page(study([45])), x=45, speed=0.5, mass=MASS), "peak_kN"), rim(45, 0.5 * math.sqrt(MASS))["peak_kN"], delta=10)

    def test_the_page_is_whole(self):
        with open(self.page(study([30, 45, 60])), encoding="utf-8") as file:
            page = file.read()
        self.assertIsNone(re.search(r"(src|href)=\"(https?:)?//|fetch\(|XMLHttpRequest|import\(", page))
        self.assertEqual(page.count("</script>"), 2)
        self.assertIn("a doubt", page)

    def test_other_folders_are_refused_with_what_makes_one(self):
        with self.assertRaisesRegex(InputError, "geometry CASE --vary"):
            build(self.path("nothing"))
        self.write("samples/geometry.json", '{"rows": []}')
        with self.assertRaisesRegex(InputError, "--samples"):
            build(self.path("samples"))
        self.assertFalse(is_design(self.path("samples")))
        old = study([30])
        del old["points"][0]["over_severity"]
        self.write("old/geometry.json", json.dumps(old))
        with self.assertRaisesRegex(DataError, "older version"):
            build(self.path("old"))
        self.assertEqual(in_process("report.design_page", self.path("nothing")).returncode, 2)


if __name__ == "__main__":
    unittest.main()
