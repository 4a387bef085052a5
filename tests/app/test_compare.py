"""compare: what differs between scenes comes first; what cannot be compared is refused."""
import json
import os
import tempfile
import unittest

from command import rimpact


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        for name, settings in {"a": [], "stiff": ["reduced.k_i_kN_per_m=5e5"], "faster": ["excitation.speed_m_per_s=0.2"],
                               "heavier": ["load.mass_kg=100000"], "other": ["bearing.rim.height_mm=58"]}.items():
            words = [word for setting in settings for word in ("--set", setting)]
            run = rimpact("reduced", "impact-window", "-o", cls.path(name), "--quiet", *words)
            assert run.returncode == 0, run.stderr

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.shared.name, name)

    def test_settings_of_the_model_may_differ(self):
        run = rimpact("compare", self.path("a"), self.path("stiff"))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("reduced.k_i_kN_per_m", run.stdout)
        self.assertLess(run.stdout.index("reduced.k_i_kN_per_m"), run.stdout.index("peak impact force"))
        self.assertRegex(run.stdout, r"peak impact force +\+5\.\d+ %")  # sqrt(5 / 4.5) = 1.054
        table = json.loads(rimpact("compare", self.path("a"), self.path("stiff"), "--json").stdout)
        self.assertEqual(table["differences"], [{"key": "reduced.k_i_kN_per_m", "a": "450000", "b": "500000", "comparable": True}])
        self.assertAlmostEqual(table["peak_force_error"], (5 / 4.5) ** 0.5 - 1, places=3)

    def test_other_motion_load_or_bearing_is_refused(self):
        for other, key in (("faster", "excitation.speed_m_per_s"), ("heavier", "load.mass_kg"), ("other", "bearing.rim.height_mm")):
            run = rimpact("compare", self.path("a"), self.path(other))
            self.assertEqual(run.returncode, 2, other)
            self.assertIn(key, run.stderr)
            self.assertIn("--anyway", run.stderr)
            run = rimpact("compare", self.path("a"), self.path(other), "--anyway", "--json")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(key, [each["key"] for each in json.loads(run.stdout)["differences"] if not each["comparable"]])

    def test_more_than_two_have_a_column_each(self):
        run = rimpact("compare", self.path("a"), self.path("stiff"), self.path("faster"), "--anyway")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("B against A", run.stdout)
        self.assertIn("C against A", run.stdout)

    def test_pictures_of_any_number_and_of_any_kind(self):
        drawn = self.path("drawn")
        arguments = [self.path("a"), self.path("stiff"), self.path("faster/response.h5"), self.path("heavier/response.csv")]
        run = rimpact("compare", *arguments, "--anyway", "-o", drawn)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("D against A", run.stdout)
        self.assertTrue(run.stdout.endswith("compare.html\n"))
        for name in ("compare.html", "figures/response.png", "figures/impacts.png"):
            self.assertGreater(os.path.getsize(os.path.join(drawn, name)), 1000, name)
        with open(os.path.join(drawn, "compare.html"), encoding="utf-8") as file:
            page = file.read()
        for text in ("reduced.k_i_kN_per_m", "excitation.speed_m_per_s", "peak impact force"):
            self.assertIn(text, page)
        table = json.loads(rimpact("compare", *arguments, "--anyway", "-o", drawn, "--json").stdout)
        self.assertEqual(table["page"], os.path.join(drawn, "compare.html"))

    def test_a_missing_column_is_named_with_its_file(self):
        path = self.path("bare.csv")
        with open(path, "w") as file:
            file.write("time_s,ux_m,Fx_N\n0,0,0\n0.1,0.01,5\n")
        for order in ((self.path("a"), path), (path, self.path("a"))):
            run = rimpact("compare", *order)
            self.assertEqual(run.returncode, 3)
            self.assertIn("bare.csv", run.stderr)
            self.assertIn("Ix_N", run.stderr)


if __name__ == "__main__":
    unittest.main()
