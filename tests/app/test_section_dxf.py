"""export --dxf, read back by ezdxf: layers, the areas that its outlines enclose against closed forms, and where slider and rim meet."""
import math
import os
import tempfile
import unittest

import ezdxf
from command import rimpact
from ezdxf.math import bulge_to_arc


def area_of(polyline) -> float:
    """Enclosed by straight lines and arcs [mm^2]: the corners' polygon and a circle's segment for each bulge."""
    corners = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0.0)) for v in polyline.vertices]
    area = 0.0
    for (x, y, bulge), (x2, y2, _) in zip(corners, corners[1:] + corners[:1]):
        area += (x * y2 - x2 * y) / 2
        if bulge:
            angle, radius = 4 * math.atan(bulge), bulge_to_arc((x, y), (x2, y2), bulge)[3]
            area += radius ** 2 / 2 * (abs(angle) - math.sin(abs(angle))) * math.copysign(1, angle)
    return abs(area)


def extent(polyline) -> tuple[float, float, float, float]:
    points = [v.dxf.location for v in polyline.vertices]
    return min(p.x for p in points), max(p.x for p in points), min(p.y for p in points), max(p.y for p in points)


class Section(unittest.TestCase):
    def section(self, *words):
        with tempfile.TemporaryDirectory() as folder:
            done = rimpact("export", *words, "--dxf", "-o", os.path.join(folder, "drawn"))
            self.assertEqual(done.returncode, 0, done.stderr)
            drawing = ezdxf.readfile(done.stdout.strip())
        self.assertFalse(drawing.audit().errors)
        outlines = {}
        for each in drawing.modelspace().query("POLYLINE"):
            outlines.setdefault(each.dxf.layer, []).append(each)
        return drawing, outlines

    def test_one_dish(self):
        """The thesis's bearing: an ellipse of R0 2.25 m and a 0.5625 m to a planar radius of 520 mm."""
        drawing, outlines = self.section("shfps-225")
        self.assertEqual({name: len(each) for name, each in outlines.items()},
                         {"PLATE": 1, "RIM": 2, "SLIDER": 1, "FOOT": 1, "PAD": 2, "SLIDER_AT_TOUCH": 1, "AXIS": 1})
        self.assertEqual(drawing.layers.get("SLIDER_AT_TOUCH").dxf.linetype, "DASHED")
        a, R0, reach = 562.5, 2250.0, 520.0
        depth = a * a / R0
        edge = depth * (1 - math.sqrt(1 - (reach / a) ** 2))
        under = 2 * depth * reach - depth * (reach * math.sqrt(1 - (reach / a) ** 2) + a * math.asin(reach / a))  # between dish and vertex's height
        plate = 2 * 560 * 50 + under + 2 * 40 * edge
        self.assertAlmostEqual(area_of(outlines["PLATE"][0]) / plate, 1, places=5)  # chords within a micrometre
        for side in outlines["RIM"]:
            self.assertAlmostEqual(area_of(side), 40 * 60, places=3)
            self.assertAlmostEqual(extent(side)[2], edge, places=5)
        cap, low, e = 90.0, 58.25, 2.0
        half = math.acos(low / cap)
        slider = 240 * 100 - cap ** 2 * (half - math.sin(half) * math.cos(half)) - 2 * e ** 2 * (1 - math.pi / 4)
        for layer in ("SLIDER", "SLIDER_AT_TOUCH"):
            self.assertAlmostEqual(area_of(outlines[layer][0]) / slider, 1, places=8)
        left, right, low_now, _ = extent(outlines["SLIDER_AT_TOUCH"][0])
        self.assertAlmostEqual(right, reach, places=6)  # it stands at the wall
        lifted = depth * (1 - math.sqrt(1 - (400 / a) ** 2))
        self.assertAlmostEqual(low_now, low + lifted, places=5)
        inner, outer, face = 20.0, 70.19, 1400.0

        def below(r):  # int_0^r face - sqrt(face^2 - x^2) dx
            return face * r - (r * math.sqrt(face ** 2 - r ** 2) + face ** 2 * math.asin(r / face)) / 2

        for side in outlines["PAD"]:
            self.assertAlmostEqual(area_of(side) / ((outer - inner) * 40 - (below(outer) - below(inner))), 1, places=8)
        (words, *_), comments = drawing.modelspace().query("TEXT"), drawing.header["$ACADVER"]
        self.assertIn("L_c = 400 mm", words.dxf.text)
        self.assertEqual(comments, "AC1009")

    def test_two_dishes(self):
        _, outlines = self.section("dcfp-155")
        self.assertEqual(set(outlines), {"PLATE", "RIM", "UPPER_PLATE", "UPPER_RIM", "SLIDER", "AXIS"})
        self.assertAlmostEqual(area_of(outlines["PLATE"][0]), area_of(outlines["UPPER_PLATE"][0]), places=3)
        (slider,) = outlines["SLIDER"]
        self.assertAlmostEqual(extent(slider)[0], -extent(slider)[1], places=6)

    def test_a_sphere_is_one_arc(self):
        _, outlines = self.section("fps-225")
        plate, rim = outlines["PLATE"][0], extent(outlines["RIM"][0])
        (bulge,) = [v.dxf.bulge for v in plate.vertices if v.dxf.get("bulge", 0.0)]
        self.assertAlmostEqual(math.sin(2 * math.atan(-bulge)), 520 / 2250, places=8)
        outer, edge, base = rim[1], 2250 - math.sqrt(2250 ** 2 - 520 ** 2), -extent(plate)[2]
        angle = 2 * math.asin(520 / 2250)
        self.assertAlmostEqual(area_of(plate) / (2 * outer * (base + edge) - 2250 ** 2 / 2 * (angle - math.sin(angle))), 1, places=8)

    def test_what_has_no_section_is_refused(self):
        for words, said in ((["no-such-bearing"], "no-such-bearing"), (["shfps-225", "--csv"], "no calibration.json")):
            done = rimpact("export", *words, "--dxf")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
