"""What the page's scripts are given: curves to be zoomed, the model to be turned. Nothing here is solved."""
import base64
import json
import os
import re
import unittest

import numpy as np
import synthetic
import synthetic_mesh
from support import InFolder, unpainted

from report import interactive, view3d, vtu
from report.build import build
from report.run_folder import load_run


def floats(text, kind="<f4"):
    return np.frombuffer(base64.b64decode(text), kind)


class Curves(unittest.TestCase):
    def test_left_out_samples_lie_on_the_lines_between_the_kept(self):
        t = np.linspace(0, 10, 20001)
        y = np.sin(3 * t) + np.where(np.abs(t - 4) < 0.01, 5.0, 0.0)
        at = interactive.kept([t, y])
        self.assertLess(len(at), 4000)
        self.assertEqual((at[0], at[-1]), (0, len(t) - 1))
        self.assertEqual(y[at].max(), y.max())
        self.assertLess(np.abs(np.interp(t, t[at], y[at]) - y).max(), 1.01 * interactive.TOLERANCE * np.ptp(y))

    def test_a_constant_and_two_samples_are_borne(self):
        np.testing.assert_array_equal(interactive.kept([np.array([0.0, 1.0]), np.zeros(2)]), [0, 1])
        np.testing.assert_array_equal(interactive.kept([np.arange(9.0), np.ones(9)]), [0, 8])


@unpainted
class Page(InFolder):
    def test_the_page_holds_the_curves_and_needs_nothing_from_elsewhere(self):
        synthetic.run(self.path("a"), "a", 'kind = "ricker"', synthetic.ricker(0.9, 1.0), synthetic.Rim(4.5e8, 0.65), "reduced")
        path, problems = build(self.path("a"))
        self.assertEqual(problems, [])
        with open(path, encoding="utf-8") as file:
            page = file.read()
        self.assertIsNone(re.search(r"(src|href)=\"(https?:)?//|fetch\(|XMLHttpRequest|import\(", page))
        stores = re.findall(r'<script class="curves" type="application/json">(.*?)</script>', page)
        self.assertEqual(len(stores), 2)
        panels = json.loads(stores[0])
        run = load_run(self.path("a"))
        u = panels[0]["lines"][0]
        self.assertAlmostEqual(np.abs(floats(u["y"])).max(), 1e3 * np.abs(run.signals["displacement_x"]).max(), delta=0.2)
        self.assertEqual([p["y"] for p in panels[:2]], ["displacement u (mm)", "lateral force −F (kN)"])
        self.assertEqual(page.count("class Panel"), 1)
        self.assertNotIn("class View", page)

    def test_the_model_to_be_turned(self):
        synthetic.run(self.path("a"), "a", 'kind = "ricker"', synthetic.ricker(0.9, 1.0), synthetic.Rim(4.5e8, 0.65, 2e6), "rim")
        os.makedirs(self.path("a", "fields"))
        synthetic_mesh.write_vtu(self.path("a", "fields", "rim_000.vtu"), cell_type=72, curved=True, stress=True)
        path, problems = build(self.path("a"))
        self.assertEqual(problems, [])
        with open(path, encoding="utf-8") as file:
            page = file.read()
        model = json.loads(re.search(r'<script class="model" type="application/json">(.*?)</script>', page).group(1))
        self.assertEqual(set(model["parts"]), {"plate and rim", "upper slider"})
        self.assertEqual([f["unit"] for f in model["fields"]], ["MPa", "%", "MPa"])
        n = len(floats(model["points"])) // 3
        triangles = floats(model["triangles"], "<u2" if model["short"] else "<u4")
        self.assertLess(triangles.max(), n)
        self.assertEqual(sum(part["triangles"][1] for part in model["parts"].values()), len(triangles) // 3)
        for field in model["fields"]:
            self.assertEqual(len(floats(field["values"])), n)
        self.assertIn("class View", page)


class Surface(InFolder):
    def test_mirrored_and_deformed_as_the_file_has_it(self):
        synthetic_mesh.write_vtu(self.path("a.vtu"), dent=0.004, stress=True)
        grid = vtu.read(self.path("a.vtu"))
        model = view3d.surface(grid)
        self.assertTrue(model.half)
        self.assertAlmostEqual(np.abs(model.moved).max(), np.abs(grid.point_data["displacement"]).max(), delta=1e-6)
        edge = model.points[model.triangles]
        area = np.linalg.norm(np.cross(edge[:, 1] - edge[:, 0], edge[:, 2] - edge[:, 0]), axis=1).sum() / 2
        self.assertGreater(area, 0.1)


if __name__ == "__main__":
    unittest.main()
