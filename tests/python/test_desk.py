"""Scenes as values, motions from arrays, sweeps, exports, geometry questions and finite-element runs from Python, and what a notebook shows."""
import concurrent.futures
import copy
import json
import multiprocessing
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np
import rimpact

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
REFERENCES, STAND_IN = SOURCE / "data/references", SOURCE / "tests/app/stand_in_fe.py"
os.environ["RIMPACT_PROGRAM"] = os.environ["RIMPACT"]
HARD = {"excitation.scale": 1.05}


class Desk(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)


class Scenes(Desk):
    def test_a_key_is_read_in_its_unit(self):
        scene = rimpact.Scene("impact-window", {"bearing.rim.thickness_mm": 35, "excitation.with": ["weight"]})
        self.assertEqual(scene["bearing.rim.thickness_mm"], 35)
        self.assertEqual(scene["excitation.with"], ["weight"])
        self.assertEqual(scene["bearing.rim"]["thickness_mm"], 35)
        self.assertIn("load.mass_kg", scene)
        self.assertNotIn("load.mass", scene)
        with self.assertRaisesRegex(rimpact.InputError, 'no key "bearing.rim.thicknes_mm"; did you mean "bearing.rim.thickness_mm"'):
            scene["bearing.rim.thicknes_mm"]

    def test_scenes_are_equal_by_what_they_say(self):
        a, b = rimpact.Scene("ricker-0.78g-1.0s", HARD), rimpact.Scene("ricker-0.78g-1.0s").with_settings(HARD)
        self.assertEqual(a, b)
        self.assertEqual(len({a, b}), 1)
        self.assertNotEqual(a, a.with_settings({"excitation.scale": 1.1}))
        self.assertNotEqual(a, "ricker-0.78g-1.0s")

    def test_a_scene_is_pickled_whole(self):
        calibrated = rimpact.Scene("ricker-0.78g-1.0s", {**HARD, "reduced.impact_law": "elastoplastic", "load.vertical_kN": 900.0})
        for name in rimpact.scene_names():
            try:
                rimpact.Scene(name)
            except rimpact.Error:
                continue  # one that needs the user's own records
            self.assertEqual(pickle.loads(pickle.dumps(rimpact.Scene(name))), rimpact.Scene(name), name)
        for again in (pickle.loads(pickle.dumps(calibrated)), copy.deepcopy(calibrated)):
            self.assertEqual(again, calibrated)
            self.assertEqual(rimpact.summarise(again)["impacts"], rimpact.summarise(calibrated)["impacts"])
            self.assertEqual(again.with_settings({"load.vertical_kN": 1800.0}).mass, calibrated.with_settings({"load.vertical_kN": 1800.0}).mass)
        path = self.folder / "scene.toml"
        path.write_text(calibrated.toml(), encoding="utf-8")
        kept = pickle.dumps(rimpact.Scene(path))
        path.unlink()  # a worker elsewhere needs no file
        self.assertEqual(pickle.loads(kept), calibrated)

    def test_and_flown_in_other_processes(self):
        scenes = [rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": scale}) for scale in (1.0, 1.05)]
        with concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
            peaks = [summary["peak_displacement_m"] for summary in pool.map(rimpact.summarise, scenes)]
        self.assertEqual(peaks, [rimpact.summarise(scene)["peak_displacement_m"] for scene in scenes])


class Motions(Desk):
    def test_a_motion_from_arrays_is_the_pulse_it_samples(self):
        """The built-in Ricker pulse, sampled and given back as a record, moves the mass as the pulse does."""
        pulse = rimpact.Scene("ricker-0.78g-1.0s", HARD)
        time = np.arange(0, 8.0005, 0.001)
        x = np.pi * (time - 2)  # pulse (2-25): T_p = 1 s, at 2 s
        sampled = 1.05 * 0.78 * 9.81 * (1 - 2 * x**2) * np.exp(-(x**2))
        sign = -1 if rimpact.run_reduced(pulse).response.displacement_x.abs().idxmax() < 0 else 1
        scene = rimpact.with_record(pulse.with_settings({"excitation.scale": 1.0}), self.folder / "motion", time, sign * sampled)
        self.assertEqual(scene["excitation.kind"], "record")
        peak = rimpact.summarise(scene)["peak_impact_force_N"]
        self.assertAlmostEqual(peak / rimpact.summarise(pulse)["peak_impact_force_N"], 1, delta=0.01)
        harder = rimpact.with_record(pulse.with_settings({"excitation.scale": 1.0}), self.folder / "motion", time, 1.1 * sign * sampled)
        self.assertNotEqual(harder, scene)  # in the same folder, yet another motion
        self.assertEqual(rimpact.summarise(scene.with_settings({}))["peak_impact_force_N"], peak)
        in_g = rimpact.write_record(self.folder / "g.csv", time, sampled / 9.80665, "g")
        self.assertAlmostEqual(rimpact.motion(in_g)["pga_g"][0], np.abs(sampled).max() / 9.80665, delta=1e-3)
        both = rimpact.with_record(pulse, self.folder / "two", time, sampled, 0.5 * sampled)
        self.assertIn("excitation.y", both)

    def test_arrays_that_are_no_record(self):
        for time, values, said in (([0, 1], [1, 2, 3], "same length"), ([0, 1], [1, np.nan], "finite"), ([0, 1, 1], [1, 2, 3], "sample 2 does not")):
            with self.assertRaisesRegex(rimpact.DataError, said):
                rimpact.write_record(self.folder / "none.csv", time, values)
        with self.assertRaisesRegex(rimpact.InputError, "units"):
            rimpact.write_record(self.folder / "none.csv", [0, 1], [1, 2], "gal")


class Work(Desk):
    def test_a_sweep_is_a_table(self):
        over = {"excitation.scale": np.linspace(0.9, 1.1, 3), "reduced.restitution": [0.4, 0.65]}
        fleet = rimpact.sweep(rimpact.Scene("ricker-0.78g-1.0s"), over, self.folder / "fleet")
        self.assertEqual(len(fleet.runs), 6)
        row = fleet.runs[(fleet.runs["excitation.scale"] == 1.1) & (fleet.runs["reduced.restitution"] == 0.4)].iloc[0]
        own = rimpact.summarise(rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": 1.1, "reduced.restitution": 0.4, "reduced.mu_slow": 0.07}))
        self.assertAlmostEqual(row.peak_impact_force_N / own["peak_impact_force_N"], 1, places=6)
        self.assertIn("<table", fleet._repr_html_())
        again = rimpact.sweep(rimpact.Scene("ricker-0.78g-1.0s"), over, self.folder / "fleet")
        self.assertTrue(again.runs.equals(fleet.runs), "what the folder holds is kept")
        self.assertEqual(len(again.runs), 6)
        with self.assertRaises(rimpact.InputError):
            rimpact.sweep("impact-window", {"excitation.sped": [1]}, self.folder / "none")
        with self.assertRaisesRegex(rimpact.InputError, "one value or more"):
            rimpact.sweep("impact-window", {}, self.folder / "none")

    def test_a_calibration_is_exported(self):
        made = rimpact.calibrate([REFERENCES / f"window-{speed}" for speed in ("0.20", "0.35", "0.50")], self.folder / "fit", law="elastoplastic", laws="none")
        files = rimpact.export(made, self.folder / "out", ["csv"])
        self.assertEqual([file.name for file in files], ["law.csv"])
        with self.assertRaises(rimpact.InputError):
            rimpact.export(made, self.folder / "out", ["excel"])

    def stand_in(self):
        os.environ["RIMPACT_FE_PROGRAM"] = str(STAND_IN)
        self.addCleanup(os.environ.pop, "RIMPACT_FE_PROGRAM")

    def test_the_designers_question(self):
        self.stand_in()
        found = rimpact.geometry("shfps-225", {"rim.thickness_mm": (20, 80)}, 0.4, self.folder / "study", targets={"peak_kN": 900}, settings={"load.mass_kg": 86952.0}, proof=False)
        self.assertEqual([row["at"] for row in found["points"]], [[20], [50], [80]])
        self.assertLess(found["answer"]["design"][0], 50)
        self.assertEqual(json.loads((self.folder / "study/geometry.json").read_text())["sentence"], found["sentence"])
        with self.assertRaisesRegex(rimpact.InputError, "load.mass_kg"):
            rimpact.geometry("shfps-225", {"rim.thickness_mm": (20, 80)}, 0.4, self.folder / "none")

    @unittest.skipUnless(os.path.exists(os.path.join(os.path.dirname(os.environ["RIMPACT"]), "rimpact-fe")), "this build has no finite elements")
    def test_a_finite_element_run_tells_its_progress(self):
        lines = []
        scene = rimpact.Scene("impact-window", {"excitation.speed_m_per_s": 0.1})
        solid = rimpact.run(scene, self.folder / "solid", mesh=0, progress=lines.append)
        self.assertEqual((solid.summary["status"], solid.summary["rung"], solid.summary["mesh"]), ("done", "rim", 0))
        self.assertTrue(any("ms" in line or " s" in line for line in lines), lines)
        with self.assertRaisesRegex(rimpact.InputError, "holds a run"):
            rimpact.run(scene.with_settings({"excitation.speed_m_per_s": 0.2}), self.folder / "solid", mesh=0)


class Shown(Desk):
    def test_what_a_notebook_shows(self):
        scene = rimpact.Scene("ricker-0.78g-1.0s", HARD)
        run = rimpact.run_reduced(scene)
        for shown, said in ((scene, "86952 kg"), (run, f"{run.summary['peak_impact_force_N']:.6g}")):
            self.assertIn(said, shown._repr_html_())
        odd = rimpact.Scene("ricker-0.78g-1.0s", {"name": "<script>"})
        self.assertIn("&lt;script&gt;", odd._repr_html_())

    def test_pictures(self):
        run = rimpact.run_reduced(rimpact.Scene("ricker-0.78g-1.0s", HARD))
        figure = run.plot(self.folder / "run.png")
        self.assertGreater((self.folder / "run.png").stat().st_size, 1000)
        line = figure.axes[0].lines[0]
        self.assertAlmostEqual(max(abs(line.get_ydata())), 1e3 * run.response.displacement_x.abs().max())
        law = rimpact.law(rimpact.Scene("impact-window", {"reduced.impact_law": "elastoplastic"}))
        drawn = law.plot(self.folder / "law.png").axes[0].lines
        self.assertEqual(len(drawn), 6)
        self.assertLessEqual(max(drawn[0].get_xdata()), 1e3 * law.known_depth[0] * (1 + 1e-9))


if __name__ == "__main__":
    unittest.main()
