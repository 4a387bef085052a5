"""Buildings, reliability, spectra, the thesis's items and measured curves from Python, and what a law says of its range."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import numpy as np
import rimpact

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]
STUDY = """scene = "frame-four-dof"
[set]
excitation.duration_s = 6.0
[intensity]
period_s = 3.0
levels_g = [0.1, 0.2, 0.4]
[motions]
folders = ["records"]
[hazard]
points = [[0.1129, 475], [0.26227, 2475]]
[[limit]]
quantity = "peak_displacement_m"
values = [0.1, 0.3]
[grid]
bearing.surface.a_m = [2.25, 0.5625]
[bootstrap]
replicates = 20
"""


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def command(self, *words):
        done = subprocess.run([os.environ["RIMPACT"], *words], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


class Buildings(Folder):
    def test_a_building_is_the_commands(self):
        short = {"excitation.duration_s": 2.5, "excitation.scale": 1.05}
        made = rimpact.building("ricker-0.78g-1.0s", self.folder / "here", settings=short)
        self.assertIsInstance(made, rimpact.Building)
        self.command("building", "ricker-0.78g-1.0s", "-o", "there", "--quiet", *(word for key, value in short.items() for word in ("--set", f"{key}={value}")))
        there = rimpact.load(self.folder / "there")
        np.testing.assert_array_equal(made.run.response.displacement_x, there.response.displacement_x)
        self.assertEqual(len(made.bearings), 6)
        # the building stands on its bearings: their static loads are its weight, and none travels farther than the summary's peak
        self.assertAlmostEqual(made.bearings.static_normal_force_N.sum() / made.run.response.force_z.iloc[0], 1, places=6)
        self.assertAlmostEqual(made.bearings.peak_displacement_m.max(), made.run.summary["peak_displacement_m"], delta=1e-3)
        self.assertIn("<table", made._repr_html_())
        with self.assertRaisesRegex(rimpact.InputError, "thesis-2.4"):
            rimpact.building("ricker-0.78g-1.0s", self.folder / "none", frame="thesis-2.44")


class Studies(Folder):
    def setUp(self):
        super().setUp()
        (self.folder / "records").mkdir()
        time = np.arange(0, 6, 0.01)
        (self.folder / "more").mkdir()
        for name, period in (("records/RSN1_A000", 1.0), ("more/RSN2_B000", 1.7)):
            values = "\n".join(f"{a:.6e}" for a in 0.25 * np.sin(2 * np.pi * time / period) * (time < 4))
            (self.folder / f"{name}.AT2").write_text(f"PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {len(time)}, DT= .01 SEC\n{values}\n")
        (self.folder / "study.toml").write_text(STUDY, encoding="utf-8")

    def test_a_study_is_read_whole(self):
        told = []
        made = rimpact.reliability(self.folder / "study.toml", self.folder / "out", records=[self.folder / "more"], progress=told.append)
        self.assertIsInstance(made, rimpact.Reliability)
        self.assertEqual((made.data["n_systems"], made.data["levels"][0]["n_records"]), (2, 2))
        self.assertEqual(len(made.rates), 2 * 2)
        self.assertEqual(set(made.fragility.level_g), {0.1, 0.2, 0.4})
        # probability over the study's years of a Poisson process of that rate
        for row in made.rates.itertuples():
            self.assertAlmostEqual(row.probability, 1 - math.exp(-row.rate_per_year * row.years), places=9)
        self.assertEqual(rimpact.Reliability.load(self.folder / "out").data, made.data)
        self.assertIn("<table", made._repr_html_())
        self.assertTrue(told)
        with self.assertRaisesRegex(rimpact.DataError, "has no table fragilities; there are difference, fragility|has no table fragilities; there are fragility"):
            made.table("fragilities")
        with self.assertRaisesRegex(rimpact.DataError, "no folder with a reliability.json"):
            rimpact.Reliability.load(self.folder)


class Spectra(Folder):
    def test_a_sine_resonates_by_its_damping(self):
        """Under a long sine of period 1 s an oscillator of period T near it has A / sqrt((1 - T^2)^2 + (2 zeta T)^2)."""
        time = np.arange(0, 40, 0.005)
        rimpact.write_record(self.folder / "sine.csv", time, 0.1 * np.sin(2 * np.pi * time), "g")
        found = rimpact.spectrum(self.folder / "sine.csv", target="asce7,S_DS=1.0,S_D1=0.6,T_L=8")
        near = found.iloc[(found.period_s - 1).abs().argmin()]
        T = near.period_s
        self.assertAlmostEqual(near.sa_g, 0.1 / math.hypot(1 - T**2, 2 * 0.05 * T), delta=0.005)
        self.assertAlmostEqual(near.target_g, 0.6 / T, delta=1e-6)  # S_D1 / T
        with self.assertRaises(rimpact.DataError):
            rimpact.spectrum(self.folder / "none.csv")


class Thesis(Folder):
    def test_its_items_are_tables(self):
        listed = rimpact.thesis("list", self.folder)
        self.assertIn("table-3-4", listed.index)
        item = rimpact.thesis("table-3-4", self.folder)
        kept = json.loads(self.command("thesis", "table-3-4", "-o", str(self.folder), "--json"))["entries"][0]["numbers"]
        self.assertEqual(list(item.ours), [each["ours"] for each in kept])
        self.assertEqual(len(item), listed.n_numbers["table-3-4"])
        self.assertIn("verdict", rimpact.thesis("headlines", self.folder))
        with self.assertRaises(rimpact.InputError):
            rimpact.thesis("fig-99-1", self.folder)


class Arrays(Folder):
    """Arrays with a known answer: the reduced model's own motion, of k_i 3e5 kN/m and e 0.4."""
    KNOWN = {"reduced.impact_law": "signed", "reduced.k_i_kN_per_m": 3e5, "reduced.restitution": 0.4, "reduced.output_step_ms": 0.2}

    def scene(self, speed, **more):
        return rimpact.Scene("impact-window", {**self.KNOWN, "excitation.speed_m_per_s": speed, "excitation.duration_s": 0.1, **more})

    def measured(self, speed, name, late=0.0, **more):
        flown = rimpact.run_reduced(self.scene(speed)).response
        time = flown.index.to_numpy()
        before = np.arange(-0.02, -1e-9, 2e-4)  # what a record holds before touch
        u = np.concatenate([flown.displacement_x.iloc[0] + speed * before, flown.displacement_x])
        time, force = np.concatenate([before, time]) + 0.02, np.concatenate([0 * before, flown.impact_x])
        if late:
            kept = np.concatenate([[True], np.diff(time) > 0])
            time, u, force = time[kept], u[kept], force[kept]
            force = np.interp(time - late, time, force)
        return rimpact.Measured(self.scene(speed), time, u, force, name=name, **more)

    def test_arrays_are_calibrated_as_files_are(self):
        tests = [self.measured(speed, f"test-{number}", uncertainty={"gain": 0.01}) for number, speed in enumerate((0.2, 0.4))]
        made = rimpact.calibrate(tests, self.folder / "fit", law="signed", laws="none")
        self.assertAlmostEqual(made.parameters.value["k_i"] / 3e5, 1, delta=0.01)
        self.assertAlmostEqual(made.parameters.value["e"], 0.4, delta=0.01)
        self.assertEqual(sorted(path.name for path in (self.folder / "fit/asked").glob("*.toml")),
                         ["test-0-scene.toml", "test-0.toml", "test-1-scene.toml", "test-1.toml"])
        self.command("calibrate", *(f"fit/asked/test-{number}.toml" for number in (0, 1)), "--law", "signed", "--laws", "none", "-o", "again", "--quiet")
        self.assertEqual(rimpact.Calibration.load(self.folder / "again").parameters.value.tolist(), made.parameters.value.tolist())
        self.assertIn("<table", made._repr_html_())

    def test_so_are_runs_of_this_process(self):
        made = rimpact.calibrate([rimpact.run_reduced(self.scene(speed)) for speed in (0.1, 0.2, 0.4)], self.folder / "fit", law="signed", laws="none",
                                 predict=[rimpact.run_reduced(self.scene(0.3))])
        self.assertAlmostEqual(made.parameters.value["k_i"] / 3e5, 1, delta=1e-3)
        self.assertAlmostEqual(made.known_speeds[0], 0.1, delta=1e-3)
        self.assertAlmostEqual(made.known_speeds[1], 0.4, delta=1e-3)

    def test_a_lag_is_taken_off(self):
        stiffness = {}
        for lag in (False, True):
            made = rimpact.calibrate(self.measured(0.4, f"late-{lag}", late=5e-4, estimate_lag=lag), self.folder / str(lag), law="signed", laws="none")
            stiffness[lag] = made.parameters.value["k_i"] / 3e5
        self.assertAlmostEqual(stiffness[True], 1, delta=0.02)
        self.assertGreater(abs(stiffness[False] - 1), 2 * abs(stiffness[True] - 1))

    def test_arrays_that_are_no_record_are_refused(self):
        with self.assertRaisesRegex(rimpact.DataError, "impact_x has the shape .3,., time .2,."):
            rimpact.Measured("impact-window", [0, 1], [0, 1], [0, 1, 2])
        with self.assertRaisesRegex(rimpact.DataError, "not finite"):
            rimpact.Measured("impact-window", [0, 1], [0, 1], [0, math.nan])
        with self.assertRaisesRegex(rimpact.InputError, "the name of its files"):
            rimpact.Measured("impact-window", [0, 1], [0, 1], [0, 1], name="a/b")


class Ranges(Folder):
    def test_a_calibrations_law_says_its_speeds_and_warns_beyond(self):
        runs = [rimpact.run_reduced(rimpact.Scene("impact-window", {"reduced.impact_law": "hunt-crossley", "excitation.speed_m_per_s": v})) for v in (0.1, 0.2, 0.4)]
        made = rimpact.calibrate(runs, self.folder / "fit", law="hunt-crossley", laws="none")
        law = rimpact.law(made)
        self.assertAlmostEqual(law.known_speeds[1], 0.4, delta=2e-3)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            law(1e-4, 0.399), law(1e-4, -0.399)
        with self.assertWarnsRegex(UserWarning, "a rate of 0.6 m/s lies beyond 0.3999 m/s, the fastest approach"):
            law(1e-4, [0.1, -0.6])
        self.assertIn("fitted to approaches of", law._repr_html_())
        # four times the mass brings the same energy at half the speed
        heavy = rimpact.law(law.scene.with_settings({"load.mass_kg": 4 * law.scene.mass}))
        self.assertAlmostEqual(heavy.known_speeds[1], law.known_speeds[1] / 2, delta=1e-9)
        self.assertIsNone(rimpact.law(rimpact.Scene("impact-window")).known_speeds)

    def test_a_run_beyond_warns(self):
        fitted = {"reduced.fitted_from_m_per_s": 0.05, "reduced.fitted_to_m_per_s": 0.3}
        with self.assertWarnsRegex(UserWarning, "an impact at 0.5 m/s outside the speeds the impact element was fitted to, 0.05 to 0.3 m/s") as told:
            rimpact.run_reduced(rimpact.Scene("impact-window", {**fitted, "excitation.speed_m_per_s": 0.5}))
        self.assertEqual(told.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            rimpact.run_reduced(rimpact.Scene("impact-window", {**fitted, "excitation.speed_m_per_s": 0.2}))


class Names(unittest.TestCase):
    def test_built_in_scenes_use_built_in_bearings(self):
        self.assertIn(rimpact.Scene("impact-window").bearing, rimpact.bearing_names())
        self.assertIn("impact-window", rimpact.scene_names())

    def test_rigid_bodies_have_a_bearing_of_their_own(self):
        self.assertEqual(rimpact.Scene("tfp-pulse").bearing, "tfp tfp-kim-2023")
        self.assertEqual(rimpact.Scene("lir-dcfp-specimen").bearing, "lir-dcfp of [isolator]")


if __name__ == "__main__":
    unittest.main()
