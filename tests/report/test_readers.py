"""Reading what runs leave, thinning series, writing numbers."""
import os
import unittest

import numpy as np
import synthetic
from support import InFolder

from report import bearing, calibration_file, numbers
from report.errors import DataError
from report.markup import sentence
from report.run_folder import load_run
from report.scene_text import commented_keys
from report.sections.common import errors_of, short_name, title_of
from report.sections.inputs import split_unit
from report.series import contact_stretches, impact_curve


class Numbers(unittest.TestCase):
    def test_digits(self):
        self.assertEqual(numbers.sig(0.0123456, 3), "0.0123")
        self.assertEqual(numbers.sig(-1234.6, 3), "−1230")
        self.assertEqual(numbers.sig(86952, 5), "86\u202f952")
        self.assertEqual(numbers.sig(9.996, 3), "10.0")
        self.assertEqual(numbers.power(4.5e5, 3), "4.50 × 10⁵")
        self.assertEqual(numbers.interval(398e3, 422e3), "3.98 to 4.22 × 10⁵")
        self.assertEqual(numbers.interval(9.8e4, 1.02e5), "9.80 × 10⁴ to 1.02 × 10⁵")
        self.assertEqual(numbers.percent(-0.0345), "−3.5\u202f%")
        self.assertEqual(numbers.percent(-1e-9), "0.0\u202f%")
        self.assertEqual(numbers.duration(402.4), "6 min 42 s")
        self.assertEqual(numbers.duration(8e-4), "0.80 ms")

    def test_what_is_not_there(self):
        for value in (None, float("nan"), float("inf"), "text", True):
            self.assertEqual(numbers.sig(value), numbers.DASH)
            self.assertEqual(numbers.percent(value), numbers.DASH)

    def test_values_of_files_keep_their_digits(self):
        self.assertEqual([numbers.plain(x) for x in (70.19, 0.5625, 9.81, 0.05, 3, True, None)],
                         ["70.19", "0.5625", "9.81", "0.05", "3", "yes", numbers.DASH])

    def test_subscripts_escape_first(self):
        self.assertEqual(str(sentence("k_i < L_c, mass_kg")),
                         "<i>k</i><sub>i</sub> &lt; <i>L</i><sub>c</sub>, mass_kg")

    def test_backticks_signs_and_exponents(self):
        self.assertEqual(str(sentence("law `k_i < +-1`, +-8.7 % of v^-0.80")), "law <code>k_i &lt; +-1</code>, ±8.7 % of v<sup>-0.80</sup>")
        self.assertEqual(str(sentence("it`s one")), "it`s one")
        self.assertEqual(str(sentence("`a` and `b")), "<code>a</code> and `b")

    def test_numbers_too_large_for_a_float_are_none(self):
        self.assertEqual(numbers.sig(10**400), numbers.DASH)


class Runs(InFolder):
    def run_folder(self, **options):
        return synthetic.run(self.path("run"), "ricker-0.78g-1.0s", 'kind = "ricker"\nscale = 1.0\namplitude_g = 0.78',
                             synthetic.ricker(0.9, 1.0), synthetic.Rim(4e8, 0.6), "reduced", **options)

    def test_run_folder(self):
        summary = self.run_folder()
        run = load_run(self.path("run"))
        self.assertAlmostEqual(run.lateral_capacity, 0.4)
        self.assertTrue(run.is_planar())
        self.assertEqual(run.problems, [])
        parts = contact_stretches(run)
        self.assertEqual(len(parts), summary["n_impacts"])
        time, force, depth = impact_curve(run, parts[0])
        self.assertEqual((time[0], force[0], force[-1]), (0.0, 0.0, 0.0))
        self.assertAlmostEqual(force.max(), summary["impacts"][0]["peak_force_N"], delta=1e-6)
        self.assertAlmostEqual(depth.max(), summary["impacts"][0]["peak_penetration_m"])
        contact = summary["impacts"][0]["release_time_s"] - summary["impacts"][0]["touch_time_s"]
        self.assertAlmostEqual(time[-1], contact, delta=3e-4)  # the next sample is at the rim too, and closes the curve

    def test_csv_stands_in_for_hdf5(self):
        self.run_folder()
        full = load_run(self.path("run"))
        os.remove(self.path("run", "response.h5"))
        table = load_run(self.path("run"))
        for name in ("time", "displacement_x", "force_x", "impact_x", "gap"):
            np.testing.assert_allclose(table.signals[name], full.signals[name], rtol=1e-12, atol=1e-15)

    def test_direction_of_the_motion(self):
        self.run_folder()
        run = load_run(self.path("run"))
        u = run.signals["displacement_x"].copy()
        angle = np.radians(37)
        run.signals["displacement_x"], run.signals["displacement_y"] = u * np.cos(angle), u * np.sin(angle)
        run.scene["excitation"].pop("direction_deg")
        self.assertTrue(run.is_planar())
        self.assertAlmostEqual(np.degrees(np.arctan2(*run.direction()[::-1])), 37, places=6)
        run.signals["displacement_y"] = run.signals["displacement_y"] + 0.05 * np.sin(run.time)
        self.assertFalse(run.is_planar())

    def test_what_cannot_be_read_is_said(self):
        self.run_folder()
        with open(self.path("run", "response.h5"), "r+b") as file:
            file.truncate(900)
        with self.assertRaisesRegex(DataError, "response.h5 is not readable HDF5"):
            load_run(self.path("run"))
        os.remove(self.path("run", "response.h5"))
        self.write("run/summary.json", "{")
        with self.assertRaisesRegex(DataError, "summary.json is not readable JSON"):
            load_run(self.path("run"))

    def test_not_a_number_is_refused(self):
        self.run_folder()
        run = load_run(self.path("run"))
        run.signals["force_x"][7] = np.nan
        synthetic.write_signals(self.path("run"), run.signals)
        with self.assertRaisesRegex(DataError, "signal force_x"):
            load_run(self.path("run"))

    def test_time_that_falls_is_refused(self):
        self.run_folder()
        run = load_run(self.path("run"))
        run.signals["time"][7] = run.signals["time"][3]
        synthetic.write_signals(self.path("run"), run.signals)
        with self.assertRaisesRegex(DataError, "time falls from .* at instant 7"):
            load_run(self.path("run"))


class Scenes(unittest.TestCase):
    def test_assumptions_are_found_by_their_comment(self):
        text = ("[bearing.rim]\nheight_mm = 60.0 # assumption: above\nthickness_mm = 40.0\n"
                "[bearing.pad] # assumption, but for its area\nrecess_mm = 20.0\n[load]\nmass_kg = 1 # given\n")
        self.assertEqual(commented_keys(text), {"bearing.rim.height_mm", "bearing.pad.recess_mm"})

    def test_units_come_off_keys(self):
        self.assertEqual(split_unit("k_i_kN_per_m"), ("k_i", "kN/m"))
        self.assertEqual(split_unit("density_kg_per_m3"), ("density", "kg/m³"))
        self.assertEqual(split_unit("R0_m"), ("R0", "m"))
        self.assertEqual(split_unit("nu"), ("nu", ""))

    def test_names(self):
        self.assertEqual(title_of("ricker-0.78g-1.0s-x1.05"), "Ricker pulse 0.78\u00a0g, 1.0\u00a0s, ×\u00a01.05")
        self.assertEqual(short_name("window-0.10"), "window 0.10 m/s")
        self.assertEqual(title_of("my-own-case"), "my-own-case")


class Geometry(unittest.TestCase):
    ELLIPSE = {"surface": {"kind": "ellipse", "R0_m": 2.25, "a_m": 0.5625, "planar_radius_mm": 520.0}, "slider": {"diameter_mm": 240.0}}

    def test_heights_of_the_surfaces(self):
        self.assertAlmostEqual(bearing.lateral_capacity(self.ELLIPSE), 0.4)
        np.testing.assert_allclose(bearing.height(self.ELLIPSE, [0.0, 0.4]), [0.0, 0.140625 * (1 - np.sqrt(1 - (0.4 / 0.5625) ** 2))])
        sphere = {"surface": {"kind": "sphere", "R0_m": 3.0}}
        self.assertAlmostEqual(float(bearing.height(sphere, 0.6)), 3 - np.sqrt(9 - 0.36))
        cone = {"surface": {"kind": "cone", "R0_m": 1.0, "slope": 0.1}}
        self.assertAlmostEqual(float(bearing.height(cone, 1e-4)), 1e-8 / 2, delta=1e-12)  # curvature 1 / R0 at the vertex
        table = {"surface": {"kind": "table", "radius_mm": [0, 100, 200], "height_mm": [0, 4, 16]}}
        self.assertAlmostEqual(float(bearing.height(table, 0.15)), 0.010)

    def test_two_dishes_are_drawn_where_the_program_has_them_touch(self):
        dcfp = {"surface": {"kind": "sphere", "concave": "double", "R0_m": 1.55, "planar_radius_mm": 303.35}, "rim": {"ledge_mm": 0.0},
                "slider": {"diameter_mm": 300.0, "height_mm": 100.0, "edge_radius_mm": 2.0}}
        capacity = 0.3000019207318123  # of a run's gap at the start
        two = bearing.TwoDishes(dcfp)
        self.assertAlmostEqual(2 * two.middle(0.2)[0], 0.2, delta=1e-12)  # what is carried has moved by both halves
        (whole,) = two.slider(capacity)
        reach = whole[:, 0].max()
        self.assertAlmostEqual(reach, 0.30335, delta=0.3e-3)  # its outline is drawn with a sharp edge
        self.assertIsNone(bearing.lateral_capacity(dcfp), "the program states it")
        dcfp["slider"]["mu_interface"] = 0.15
        low, high = bearing.TwoDishes(dcfp).slider(capacity)
        np.testing.assert_allclose(np.vstack([low[:81], high[2:]]), whole)
        np.testing.assert_allclose(low[:80:-1], high[:2])  # they meet in a plane
        del dcfp["slider"]["height_mm"]
        self.assertEqual(bearing.TwoDishes.missing(dcfp), ["slider.height_mm"])

    def test_what_cannot_be_drawn_is_said(self):
        with self.assertRaisesRegex(ValueError, "does not reach"):
            bearing.height(self.ELLIPSE, 0.6)
        with self.assertRaisesRegex(ValueError, "surface.a_m is not given"):
            bearing.height({"surface": {"kind": "ellipse", "R0_m": 2.0}}, 0.1)

    def test_a_key_is_assumed_by_its_comment_or_by_the_list(self):
        text = "[bearing.rim]\nheight_mm = 60.0 # assumption\nthickness_mm = 40.0\n"
        self.assertEqual(bearing.assumed_keys(text, {}), {"rim.height_mm"})
        self.assertEqual(bearing.assumed_keys("", {"bearing": {"assumed": ["rim.thickness_mm"]}}), {"rim.thickness_mm"})


class Calibration(unittest.TestCase):
    def test_the_file(self):
        found = calibration_file.read({
            "parameters": {"k_i": {"value": 4e5, "unit": "kN/m", "interval_95": [3.9e5, 4.1e5], "identifiable": True}, "e": {}},
            "derived": {"law": "signed"}, "answer": {"published_applies": True},
            "windows": {"rows": [{"speed_m_s": 0.5, "parameters": {"k_i": {"value": 3e5}}, "pair_force_error": 0.2},
                                 {"speed_m_s": 0.1, "restitution": 0.7}],
                        "valid_from_m_s": 0.05, "valid_to_m_s": 0.3, "tolerance": 0.1, "sentence": "holds"},
            "published": {"k_i": {"value": 4.6e5, "unit": "kN/m"}}})
        self.assertEqual([p.name for p in found.parameters], ["k_i"])
        self.assertEqual((found.parameter("k_i").published, found.parameter("k_i").interval), (4.6e5, (3.9e5, 4.1e5)))
        self.assertEqual([row.speed for row in found.windows], [0.1, 0.5])
        self.assertEqual((found.valid_to, found.validity, found.windows[1].k_i.value), (0.3, "holds", 3e5))

    def test_a_law_that_is_no_pair_has_no_pairs_range(self):
        found = calibration_file.read({"parameters": {"k_i": {"value": 9e5}}, "derived": {"law": "elastoplastic"},
                                       "windows": {"rows": [{"speed_m_s": 0.1}], "valid_from_m_s": 0.05, "valid_to_m_s": 1.0, "sentence": "The constant pair"}})
        self.assertEqual((found.validity, found.valid_from, found.pair("k_i")), ("", None, None))
        self.assertEqual(found.parameter("k_i").value, 9e5)

    def test_the_published_pair_is_of_the_published_bearing(self):
        data = {"parameters": {"k_i": {"value": 4e5}}, "published": {"k_i": {"value": 4.5e5}}, "fit": {"a/x": {"published_values": {"peak_force_error": 0.2}}}}
        self.assertIsNone(calibration_file.read(data).parameter("k_i").published)
        self.assertEqual(calibration_file.read(data | {"answer": {"published_applies": True}}).parameter("k_i").published, 4.5e5)

    def test_an_empty_file_gives_an_empty_calibration(self):
        self.assertEqual(calibration_file.read({}).parameters, [])

    def test_errors_are_relative_to_fe_and_of_the_run_alone(self):
        class Stub:
            pass
        fe, fitted, context, entry = Stub(), Stub(), Stub(), Stub()
        fe.summary, fe.impacts = {"peak_impact_force_N": 2e6, "peak_displacement_m": 0.41}, []
        fitted.summary, fitted.impacts = {"peak_impact_force_N": 2.2e6, "peak_displacement_m": 0.41}, []
        data = {"fit": {"a/b/x": {"peak_force_error": -0.5, "nrmse_force": 0.03, "published_values": {"peak_force_error": 0.25}}}, "derived": {"law": "signed"}}
        context.calibration = calibration_file.read(data | {"answer": {"published_applies": True}})
        entry.name, entry.fe, entry.fitted, entry.published, fitted.get = "x", fe, fitted, None, lambda *_: "signed"
        errors = errors_of(entry, "fitted")
        self.assertAlmostEqual(errors.pop("peak_force"), 0.1)
        self.assertEqual(errors, {"peak_displacement": 0.0})  # nothing that the file states of the fit's law, which need not be this run's
        self.assertEqual(errors_of(entry, "published"), {})
        self.assertEqual(context.calibration.role("x"), "fit")


if __name__ == "__main__":
    unittest.main()
