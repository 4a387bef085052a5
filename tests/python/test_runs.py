"""Runs in this process are those of the command; folders and fleets are read whole; failures are the command's sentences."""
import concurrent.futures
import inspect
import os
import pathlib
import subprocess
import tempfile
import threading
import typing
import unittest

import numpy as np
import rimpact
from rimpact.scene import toml_value

COMMAND = os.environ["RIMPACT"]
HARD = {"excitation.scale": 1.05}


def command(*words, cwd):
    return subprocess.run([COMMAND, *words], capture_output=True, text=True, cwd=cwd, check=False)


class Runs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_records_are_a_table(self):
        for name in ("A000.AT2", "A090.AT2", "B-UP.AT2"):
            with open(self.path(name), "w") as file:
                file.write("PEER\nMADE UP\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n .1 .2 .1\n")
        records = rimpact.motion(self.folder)
        self.assertEqual(list(records["pair"]), ["A090.AT2", "A000.AT2", None])
        self.assertEqual(list(records["kind"]), ["horizontal", "horizontal", "vertical"])
        self.assertAlmostEqual(records["pga_g"].max(), 0.2)
        with self.assertRaisesRegex(rimpact.DataError, "no such file"):
            rimpact.motion(self.path("none.AT2"))

    def test_a_run_here_is_the_commands_to_the_last_bit(self):
        done = command("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "-o", "run", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        stored, flown = rimpact.load(self.path("run")), rimpact.run_reduced(rimpact.Scene("ricker-0.78g-1.0s", HARD))
        self.assertEqual(sorted(stored.response), sorted(flown.response))
        for signal in stored.response:
            np.testing.assert_array_equal(stored.response[signal], flown.response[signal], signal)
        self.assertEqual(stored.summary["impacts"], flown.summary["impacts"])
        self.assertEqual(stored.scene, flown.scene)
        self.assertGreater(len(flown.impacts), 0)
        self.assertEqual(flown.impacts.peak_force_N.max(), flown.summary["peak_impact_force_N"])

    def test_units_and_descriptions_go_along(self):
        frame = rimpact.run_reduced("impact-window").response
        self.assertEqual(frame.index.name, "time")
        self.assertEqual(frame.attrs["units"]["impact_x"], "N")
        self.assertIn("rim", frame.attrs["descriptions"]["impact_x"])
        self.assertEqual(set(frame.attrs["units"]), set(frame.columns))

    def test_peaks_alone_are_the_same(self):
        scene = rimpact.Scene("ricker-0.78g-1.0s", HARD)
        alone, whole = rimpact.summarise(scene), rimpact.run_reduced(scene).summary
        for name in ("peak_displacement_m", "peak_impact_force_N", "n_impacts"):
            self.assertAlmostEqual(alone[name], whole[name], delta=1e-9 * abs(whole[name]), msg=name)

    def test_a_folder_written_here_is_the_commands(self):
        scene = rimpact.Scene("impact-window", {"excitation.speed_m_per_s": 0.3})
        flown = rimpact.run_reduced(scene, self.path("mine"))
        self.assertIsInstance(flown, rimpact.Run)
        self.assertEqual(flown.folder.name, "mine")
        np.testing.assert_array_equal(rimpact.load(self.path("mine")).response.impact_x, flown.response.impact_x)
        again = command("reduced", self.path("mine"), "-o", "again", "--json", cwd=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_table_is_read_where_there_is_no_h5(self):
        rimpact.run_reduced("impact-window", self.path("run"))
        both = rimpact.load(self.path("run")).response
        os.remove(self.path("run/response.h5"))
        table = rimpact.load(self.path("run")).response
        np.testing.assert_array_equal(table.impact_x, both.impact_x)
        self.assertNotIn("velocity_x", table)

    def test_fields_are_listed_with_their_times(self):
        rimpact.run_reduced("impact-window", self.path("run"))
        self.assertEqual(len(rimpact.load(self.path("run")).fields), 0)
        with open(self.path("run/fields.pvd"), "w", encoding="utf-8") as file:
            file.write('<?xml version="1.0"?>\n<VTKFile type="Collection"><Collection>\n'
                       '<DataSet timestep="2.486" file="fields/touch.vtu"/>\n</Collection></VTKFile>\n')
        fields = rimpact.load(self.path("run")).fields
        self.assertEqual(fields.time_s.tolist(), [2.486])
        self.assertEqual(fields.file.tolist(), [self.path("run/fields/touch.vtu")])

    def test_a_fleet_has_a_row_a_run(self):
        done = command("reduced", "ricker-0.78g-1.0s", "--sweep", "excitation.scale=0.9:1.1:5", "-o", "fleet", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        fleet = rimpact.load_fleet(self.path("fleet"))
        self.assertIsInstance(fleet, rimpact.Fleet)
        np.testing.assert_allclose(fleet.runs["excitation.scale"], [0.9, 0.95, 1.0, 1.05, 1.1])
        own = rimpact.summarise(rimpact.Scene("ricker-0.78g-1.0s", HARD))
        self.assertAlmostEqual(fleet.runs.peak_impact_force_N[3], own["peak_impact_force_N"], delta=1e-9 * own["peak_impact_force_N"])
        self.assertIsNone(fleet.fractiles)

    def test_a_fleet_has_each_run_once_and_says_what_is_missing(self):
        sweep = ["reduced", "impact-window", "--sweep", "excitation.speed_m_per_s=0.1:0.5:5", "-o", "fleet", "--shard"]
        for shard in ("1/2", "1/3"):
            self.assertEqual(command(*sweep, shard, cwd=self.folder).returncode, 0)
        with self.assertWarnsRegex(UserWarning, "4 of 5 runs are done"):
            fleet = rimpact.load_fleet(self.path("fleet"))
        self.assertEqual(fleet.runs.run.tolist(), [1, 3, 4, 5])

    def test_damaged_files_are_data_errors(self):
        rimpact.run_reduced("impact-window", self.path("run"))
        for name, text in (("summary.json", b"[1]"), ("summary.json", b"\xff\xfe{"), ("fields.pvd", b"<VTKFile>"), ("response.h5", b"none")):
            place = self.path(f"run/{name}")
            kept = pathlib.Path(place).read_bytes() if os.path.exists(place) else b""
            pathlib.Path(place).write_bytes(text)
            with self.assertRaises(rimpact.DataError, msg=name):
                rimpact.load(self.path("run"))
            pathlib.Path(place).write_bytes(kept) if kept else os.remove(place)
        os.remove(self.path("run/response.h5"))
        for text in (b"", b"time_s,ux_m,Fx_N\n0,word,1\n", b"\xff\xfe\x00"):
            pathlib.Path(self.path("run/response.csv")).write_bytes(text)
            with self.assertRaises(rimpact.DataError):
                rimpact.load(self.path("run"))

    def test_a_summary_alone_carries_its_doubts(self):
        scene = rimpact.Scene("impact-window", {"excitation.speed_m_per_s": 5})
        alone, whole = rimpact.summarise(scene), rimpact.run_reduced(scene).summary
        for name in ("beyond_rim", "beyond_fit", "strain_limit"):
            self.assertEqual(alone.get(name), whole.get(name), name)
        self.assertTrue(alone["beyond_rim"])
        self.assertEqual(alone["warnings"], whole["warnings"])

    def test_failures_are_the_commands_sentences(self):
        said = command("reduced", "ricker-0.78g-1.0s", "--set", "excitation.scal=1", cwd=self.folder).stderr
        with self.assertRaises(rimpact.InputError) as caught:
            rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scal": 1})
        self.assertIn(str(caught.exception), said)
        self.assertEqual(caught.exception.code, 2)
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaisesRegex(rimpact.DataError, "no such folder"):
            rimpact.load(self.path("nowhere"))
        with self.assertRaisesRegex(rimpact.DataError, "table.csv"):
            rimpact.load_fleet(self.folder)

    def test_settings_of_every_type_are_toml(self):
        for value, text in ((True, "true"), (3, "3"), (0.1, "0.1"), ("curve", '"curve"'), ([0.1, 0], "[0.1, 0]"), (np.float64(2.5), "2.5"),
                            (float("inf"), "inf")):
            self.assertEqual(toml_value(value), text)
        scene = rimpact.Scene("impact-window").with_settings({"excitation.with": ["weight"], "load.mass_kg": 1e5})
        self.assertEqual(scene.mass, 1e5)
        self.assertIn('with = ["weight"]', scene.toml())

    def test_the_interpreter_goes_on_while_a_model_flies(self):
        scene = rimpact.Scene("ricker-0.78g-1.0s", {**HARD, "excitation.duration_s": 4000, "reduced.output_step_ms": 1})
        ticks, over = [0], threading.Event()

        def count():
            while not over.is_set():
                ticks[0] += 1
                over.wait(1e-4)

        counter = threading.Thread(target=count)
        counter.start()
        before = ticks[0]
        rimpact._core.run(scene._core)
        during = ticks[0] - before
        over.set()
        counter.join()
        self.assertGreater(during, 3)  # the lock kept for the whole call would leave one

    def test_threads_get_what_one_gets(self):
        scenes = [rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": scale}) for scale in np.linspace(0.95, 1.15, 8)]
        alone = [rimpact.summarise(scene)["peak_displacement_m"] for scene in scenes]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            together = [found["peak_displacement_m"] for found in pool.map(rimpact.summarise, scenes)]
        self.assertEqual(alone, together)

    def test_everything_public_is_typed_and_described(self):
        for name in rimpact.__all__:
            item = getattr(rimpact, name)
            self.assertTrue(inspect.getdoc(item), name)
            if inspect.isfunction(item):
                hints = typing.get_type_hints(item, {**vars(inspect.getmodule(item))})
                self.assertIn("return", hints, name)
                self.assertEqual(set(inspect.signature(item).parameters) - set(hints), set(), name)


if __name__ == "__main__":
    unittest.main()
