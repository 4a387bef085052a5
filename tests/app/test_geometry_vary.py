"""geometry --vary: the designer's question, with a stand-in for the finite elements whose curves are a formula."""
import csv
import json
import os
import shutil
import tempfile
import unittest

from command import rimpact

HERE = os.path.dirname(os.path.abspath(__file__))
STAND_IN = os.path.join(HERE, "stand_in_fe.py")
LOAD = ("--set", "load.mass_kg=86952")
ASKED = ("--vary", "rim.thickness_mm=20:80", "--at", "speed=0.4")
POWER, MASS, SPEED = 0.4, 86952, 0.4


def force_kN(thickness: float) -> float:
    """Of the stand-in's rim: K d^n takes m v^2 / 2."""
    scale = 6e6 * (thickness / 50) ** 0.5
    return 1e-3 * scale * ((POWER + 1) * MASS * SPEED**2 / 2 / scale) ** (POWER / (POWER + 1))


class Vary(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder, self.log = os.path.join(temporary.name, "study"), os.path.join(temporary.name, "calls")

    def geometry(self, *arguments, bearing="shfps-225", **more):
        return rimpact("geometry", bearing, "-o", self.folder, *arguments, RIMPACT_FE_PROGRAM=STAND_IN, STAND_IN_LOG=self.log, **more)

    def calls(self, verb):
        if not os.path.exists(self.log):
            return 0
        with open(self.log) as file:
            return sum(line.startswith(verb + " ") for line in file)

    def test_which_thickness_keeps_the_force_below_a_target(self):
        most = force_kN(50)
        run = self.geometry(*LOAD, *ASKED, "--target", f"peak_kN={most}", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        study = json.loads(run.stdout)
        for row, thickness in zip(study["points"], (20, 50, 80)):
            self.assertEqual(row["at"], [thickness])
            self.assertAlmostEqual(row["peak_kN"] / force_kN(thickness), 1, places=3)
        (design,) = study["answer"]["design"]
        self.assertAlmostEqual(design, 50 * (1 + study["answer"]["force_error"]) ** -2.8, delta=1.0)  # F goes as t^(1/2.8)
        self.assertRegex(study["sentence"], r"is met by rim.thickness_mm from 20 to (49|50); take rim.thickness_mm = ")
        self.assertIn("Its solid run", study["sentence"])
        self.assertGreater(study["answer"]["proof"]["peak_kN"], 0)
        self.assertEqual((self.calls("curve"), self.calls("run")), (3, 1))
        with open(os.path.join(self.folder, "geometry.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["rim.thickness_mm"] for row in rows], ["20", "50", "80"])
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "geometry.png")), 1000)
        again = self.geometry(*LOAD, *ASKED, "--target", f"peak_kN={most}", "--json")  # nothing is run twice
        self.assertEqual(json.loads(again.stdout)["answer"]["design"], [design])
        self.assertEqual((self.calls("curve"), self.calls("run")), (3, 1))
        lower = self.geometry(*LOAD, *ASKED, "--target", f"peak_kN={0.9 * most}", "--no-proof", "--json")  # another target, the same curves
        self.assertLess(json.loads(lower.stdout)["answer"]["design"][0], design)
        self.assertEqual(self.calls("curve"), 3)

    def test_a_rim_pushed_last_and_alone_has_all_cores(self):
        for n, jobs, expected in ((3, 2, ["1", "1", "all"]), (2, 2, ["1", "1"])):
            with self.subTest(n=n, jobs=jobs):
                self.geometry(*LOAD, "--vary", f"rim.thickness_mm=20:80:{n}", "--at", "speed=0.4", "--no-proof", "--jobs", str(jobs), "--force")
                with open(self.log) as file:
                    self.assertEqual(sorted(line.split()[-1] for line in file), expected)
                os.remove(self.log), shutil.rmtree(self.folder)

    def test_a_lower_force_is_a_liners(self):
        run = self.geometry(*LOAD, *ASKED, "--target", "peak_kN=600", "--crush", "0.7", "--no-proof", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        liner = json.loads(run.stdout)["liner"]
        self.assertTrue(liner["works"], liner["sentence"])
        self.assertAlmostEqual(liner["crush_stress_MPa"] * liner["band_mm"] * liner["chord_mm"], 600e3, delta=1)  # N
        self.assertAlmostEqual(liner["stroke_mm"] / liner["thickness_mm"], 0.7)
        energy = MASS * SPEED**2 / 2
        self.assertGreater(liner["stroke_mm"] / 1e3 * 600e3, energy)  # a chord that grows takes 2/3 of force times stroke
        self.assertLess(liner["stroke_mm"] / 1e3 * 600e3, 1.6 * energy)
        self.assertLess(liner["wall"]["strain"], 0.2)
        self.assertIn("Or a sacrificial liner on the wall of rim.thickness_mm = 20:", liner["sentence"])
        self.assertIn("a liner", self.geometry("--crush", "0.5").stderr)

    def test_an_answer_far_from_its_solid_run_is_doubted(self):
        """The stand-in's solid runs follow another law than its curves."""
        run = self.geometry(*LOAD, *ASKED)
        self.assertIn("from its solid run: ask with more rims", run.stderr)
        self.assertIn("At 0.4 m/s under 86952 kg, rim.thickness_mm = 50: peak force", run.stdout)

    def test_a_load_is_never_assumed(self):
        for words in ([], ["--dry-run"]):
            run = self.geometry(*ASKED, *words)
            self.assertEqual(run.returncode, 2)
            self.assertIn("load.mass_kg", run.stderr)
            self.assertIn("--set load.vertical_kN=", run.stderr)
        self.assertEqual(self.calls("curve"), 0)

    def test_a_dry_run_names_runs_and_time(self):
        run = self.geometry(*LOAD, *ASKED, "--dry-run", "--jobs", "2", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        plan = json.loads(run.stdout)
        self.assertEqual([each["name"] for each in plan["runs"]], ["thickness_mm-20", "thickness_mm-50", "thickness_mm-80"])
        self.assertGreater(plan["expected_seconds"], max(each["expected_seconds"] for each in plan["runs"]))
        self.assertFalse(os.path.exists(self.folder))
        samples = self.geometry("--samples", "4", "--dry-run", "--mesh", "0", "--json")
        self.assertEqual(len(json.loads(samples.stdout)["runs"]), 4)
        self.assertEqual(self.calls("run"), 0)

    def test_a_steel_that_knows_its_rate_is_doubted(self):
        rate = ("--set", 'bearing.material.steel.rate="cowper-symonds"', "--set", "bearing.material.steel.rate_D_per_s=40", "--set", "bearing.material.steel.rate_q=5")
        run = self.geometry(*LOAD, *rate, *ASKED, "--no-proof", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue(any("infinitely slowly" in each for each in json.loads(run.stdout)["warnings"]))

    def test_parts_add_up(self):
        first = self.geometry(*LOAD, *ASKED, "--shard", "1/2")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertIn("2 of 3 curves are pushed", first.stderr)
        second = self.geometry(*LOAD, *ASKED, "--shard", "2/2", "--json")
        self.assertEqual(len(json.loads(second.stdout)["points"]), 3, second.stderr)
        self.assertEqual(self.calls("curve"), 3)

    def test_a_rim_that_fails_does_not_lose_the_others(self):
        run = self.geometry(*LOAD, *ASKED, "--no-proof", "--json", STAND_IN_FAIL="thickness_mm-20")
        self.assertEqual(run.returncode, 4)
        self.assertIn("the test asked for it", run.stderr)
        study = json.loads(run.stdout)
        self.assertEqual([row["at"] for row in study["points"]], [[50], [80]])
        self.assertIn("thickness_mm-20", study["failures"])
        self.assertIn("thickness_mm-20 has no result.", study["sentence"])

    def test_two_keys_are_combined(self):
        run = self.geometry(*LOAD, "--vary", "rim.thickness_mm=30:60:2", "--vary", "bearing.rim.height_mm=60:70:2", "--at", "speed=0.4",
                            "--target", "peak_kN=1e5", "--no-proof", "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        study = json.loads(run.stdout)
        self.assertEqual([row["at"] for row in study["points"]], [[30, 60], [60, 60], [30, 70], [60, 70]])
        self.assertIn("rim.height_mm = 70", study["sentence"])
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "geometry.png")), 1000)

    def test_bad_words_are_refused(self):
        for words, said in ((["--vary", "rim.thickness_mm=20"], "KEY=LOW:HIGH"), (["--vary", "rim.thickness_mm=80:20"], "0 < LOW < HIGH"),
                            (["--vary", "rim.thickness_mm=20:80:1"], "2 to 20"), (["--vary", "rim.thicknes_mm=20:80"], "did you mean"),
                            (["--vary", "rim.thickness_mm=a:80"], "KEY=LOW:HIGH"), (["--vary", "pad.thickness_mm=20:80"], "does not feel"),
                            (["--vary", "material.steel.strain_limit=0.1:0.3"], "does not feel")):
            run = self.geometry(*LOAD, *words, "--at", "speed=0.4")
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)
        for words, said in ((["--at", "sped=0.4"], "did you mean"), (["--at", "speed=99"], "from 0.01 to 10"), ([], "--at speed="),
                            (["--at", "speed=0.4", "--target", "peak=3"], "peak_kN"), (["--at", "speed=0.4", "--target", "peak_kN=-3"], "> 0"),
                            (["--at", "speed=0.4", "--samples", "9"], "--samples"), (["--at", "speed=0.4", "--vary", "rim.thickness_mm=30:40"], "twice")):
            run = self.geometry(*LOAD, "--vary", "rim.thickness_mm=20:80", *words)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)
        self.assertIn("--vary", self.geometry("--at", "speed=0.4").stderr)


if __name__ == "__main__":
    unittest.main()
