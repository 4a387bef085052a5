"""Whatever a hand, a full disk or a strange name leaves in a results folder: a report, or one sentence with file and key."""
import copy
import json
import os
import re
import stat
import unittest
from unittest import mock

import synthetic
import synthetic_calibration
from support import InFolder, command, in_process, unpainted

from report import build as building
from report import shapes
from report.errors import IoError, ReportError
from report.files import write_whole

WRONG = ("X", 7, True, [], ["X"], {}, {"X": "X"}, [[]], None, 10**400)


def leaves(tree, path=()):
    """Every place in a tree, tables and lists among them."""
    yield path
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ():
        yield from leaves(value, (*path, key))


def changed(tree, path, value):
    if not path:
        return value
    copied = copy.deepcopy(tree)
    place = copied
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return copied


class Tampered(InFolder):
    """Nothing is drawn here (figures say themselves what they cannot draw); every number and sentence is made."""

    def setUp(self):
        super().setUp()
        patch = mock.patch("report.blocks.Pictures.figure", return_value=None)
        patch.start()
        self.addCleanup(patch.stop)

    def results(self):
        scene, quiet = 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0
        for place, rung in (("runs", "rim"), ("reduced", "reduced")):
            synthetic.run(self.path(place, "window-0.20"), "window-0.20", scene, quiet, synthetic.Rim(5e8, 0.7, 2e6), rung, 0.2,
                          warnings=["it swerves"])
        synthetic_calibration.calibration(self.folder, [{"speed_m_s": 0.2, "parameters": {"k_i": {"value": 3e5}}, "pair_force_error": 0.1}], synthetic_calibration.answer((0.2,)))
        synthetic_calibration.curves(self.path("calibration"))
        with open(self.path("main.json"), "w", encoding="utf-8") as file:
            json.dump({"runs": [{"name": "window-0.20", "role": "window", "fe": "runs/window-0.20"}], "totals": {"wall_time_s": 3.0},
                       "comparison": [{"name": "window-0.20", "doubts": ["d"]}], "load": {"mass_kg": 1.0}, "document": {"title": "t"},
                       "versions": {"rimpact": "1"}, "machine": {"cores": 2}, "warnings": ["w"]}, file)

    def try_all(self, name, seldom=1):
        with open(self.path(name), encoding="utf-8") as file:
            good = json.load(file)
        refused, total = 0, 0
        for i, path in enumerate(leaves(good)):
            for j, wrong in enumerate(WRONG):
                if (i + j) % seldom:
                    continue
                total += 1
                self.write(name, json.dumps(changed(good, path, wrong)))
                try:
                    building.build(self.folder)
                except ReportError as error:
                    refused += 1
                    self.assertEqual(error.code, 3, (path, wrong))
                    self.assertIn(os.path.basename(name), str(error), (path, wrong))
                except Exception as error:  # noqa: BLE001
                    self.fail(f"{name}: {path} = {wrong!r:.40}: {error!r}")
        self.write(name, json.dumps(good))
        self.assertGreater(refused, total // 4)

    def test_a_summary(self):
        self.results()
        self.try_all("runs/window-0.20/summary.json")

    def test_main(self):
        self.results()
        self.try_all("main.json")

    def test_a_calibration(self):
        self.results()
        self.try_all("calibration/calibration.json", seldom=7)

    def test_curves(self):
        synthetic_calibration.calibration(self.folder, [], synthetic_calibration.answer((0.2,)))
        synthetic_calibration.curves(self.path("calibration"), names=("a",))
        with open(self.path("calibration/curves.json"), encoding="utf-8") as file:
            short = json.load(file)
        for part in ("reference", "law"):
            short["impacts"][0][part] = {key: values[:3] for key, values in short["impacts"][0][part].items()}
        self.write("calibration/curves.json", json.dumps(short))
        self.try_all("calibration/curves.json")

    def test_a_scene(self):
        self.results()
        name = "runs/window-0.20/scene.toml"
        with open(self.path(name), encoding="utf-8") as file:
            lines = file.read().splitlines()
        refused = 0
        for i, line in enumerate(lines):
            if "=" not in line:
                continue
            for wrong in ('"X"', "-7", "true", "[]", "{}", "nan", "inf"):
                self.write(name, "\n".join([*lines[:i], f"{line.partition('=')[0]}= {wrong}", *lines[i + 1:]]))
                try:
                    building.build(self.folder)
                except ReportError as error:
                    refused += 1
                    self.assertEqual(error.code, 3)
                    self.assertIn("scene.toml", str(error))
        self.assertGreater(refused, 80)
        for table in ("bearing", "load", "excitation", "reduced", "model"):  # a value where a table is wanted
            self.write(name, f'{table} = "x"\n')
            with self.assertRaisesRegex(ReportError, f"scene.toml: {table} must be a table, got 'x'"):
                building.build(self.folder)


class Sentences(InFolder):
    def test_the_command_names_file_and_key(self):
        synthetic.run(self.path("run"), "w", 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0, synthetic.Rim(4e8, 0.6), "rim", 0.2)
        for change, said in (({"impacts": "X"}, "impacts must be a list, got 'X'"), ({"error_estimate": "X"}, "error_estimate must be a table, got 'X'"),
                             ({"impacts": [{"peak_force_N": "X"}]}, r"impacts\[0\].peak_force_N must be a number, got 'X'")):
            with open(self.path("run/summary.json"), encoding="utf-8") as file:
                good = json.load(file)
            self.write("run/summary.json", json.dumps(good | change))
            done = in_process("report", self.path("run"))
            self.write("run/summary.json", json.dumps(good))
            self.assertEqual(done.returncode, 3)
            self.assertRegex(done.stderr, rf"^rimpact report: .*/run/summary.json: {said}\n$")
        self.write("run/summary.json", '{"peak_displacement_m": NaN}')
        done = in_process("report", self.path("run"))
        self.assertEqual(done.returncode, 3)
        self.assertIn("NaN is no number", done.stderr)

    def test_shapes(self):
        for good in ({"impacts": []}, {"impacts": [{"peak_force_N": 3, "other": "free"}]}, {"unknown": 3}):
            shapes.check(good, shapes.SUMMARY, "f")
        with self.assertRaisesRegex(shapes.ShapeError, r"f: law.rung must be a text or a list, got 3"):
            shapes.check({"law": {"rung": 3}}, {"law": {"rung": (shapes.TEXT, [shapes.TEXT])}}, "f")


@unpainted
class Fields(InFolder):
    def test_only_what_the_run_lists_is_drawn(self):
        import synthetic_mesh

        from report.run_folder import load_run
        from report.stored_fields import instants
        synthetic.run(self.path("run"), "w", 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0, synthetic.Rim(4e8, 0.6), "rim", 0.2)
        os.makedirs(self.path("run/fields"))
        for name, dent in (("rim_001", 0.001), ("rim_002", 0.002), ("rim_003", 0.05)):  # the last is an earlier run's
            synthetic_mesh.write_vtu(self.path("run/fields", name + ".vtu"), dent)
        self.write("run/fields.pvd", '<?xml version="1.0"?>\n<VTKFile type="Collection"><Collection>\n'
                   '<DataSet timestep="0.01" part="0" file="fields/rim_001.vtu"/>\n<DataSet timestep="0.02" part="0" file="fields/rim_002.vtu"/>\n'
                   "</Collection></VTKFile>\n")
        run = load_run(self.path("run"))
        self.assertEqual([(os.path.basename(file), time) for file, time in instants(run)], [("rim_001.vtu", 0.01), ("rim_002.vtu", 0.02)])
        from report import rim_picture
        with mock.patch("report.rim_picture.draw", wraps=rim_picture.draw) as draw:
            building.build(self.path("run"))
        self.assertEqual(draw.call_count, 1)
        self.assertAlmostEqual(rim_picture.largest_strain(draw.call_args.args[0]), 0.004, delta=2e-4)
        self.write("run/fields.pvd", "<VTKFile")
        with self.assertRaisesRegex(ReportError, "fields.pvd is not readable"):
            building.build(self.path("run"))


class Files(InFolder):
    def test_a_device_is_written_into_and_stays_one(self):
        os.mkfifo(self.path("pipe"))
        reader = os.open(self.path("pipe"), os.O_RDONLY | os.O_NONBLOCK)
        write_whole(self.path("pipe"), lambda file: file.write(b"page"))
        self.assertEqual(os.read(reader, 10), b"page")
        os.close(reader)
        self.assertTrue(stat.S_ISFIFO(os.stat(self.path("pipe")).st_mode))
        before = os.stat("/dev/full")
        with self.assertRaisesRegex(IoError, "cannot write /dev/full: No space left"):
            write_whole("/dev/full", lambda file: file.write(b"page"))
        self.assertEqual(os.stat("/dev/full").st_rdev, before.st_rdev)

    def test_a_failure_leaves_the_earlier_file_and_nothing_else(self):
        self.write("page", "earlier")

        def full(file):
            file.write(b"half")
            raise OSError(28, "No space left on device")
        with self.assertRaisesRegex(IoError, "cannot write .*page: No space left"):
            write_whole(self.path("page"), full)
        with self.assertRaises(IoError):
            write_whole(self.path("missing/page"), lambda file: None)
        self.assertEqual(os.listdir(self.folder), ["page"])
        with open(self.path("page"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "earlier")

    @unpainted
    def test_the_command_on_a_device(self):
        synthetic.run(self.path("run"), "w", 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0, synthetic.Rim(4e8, 0.6), "reduced", 0.2)
        done = in_process("report", self.path("run"), "--output", "/dev/full")
        self.assertEqual(done.returncode, 6)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))
        self.assertEqual(in_process("report", self.path("run"), "--output", "/dev/null", "--pdf").returncode, 2)

    def test_names_that_are_no_text(self):
        folder = os.fsencode(self.folder) + b"/caf\xe9 <b>"
        synthetic.run(os.fsdecode(folder), "w", 'kind = "window"\nspeed_m_per_s = 0.2', lambda t: 0.0, synthetic.Rim(4e8, 0.6), "reduced", 0.2)
        done = command("report", os.fsdecode(folder))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(folder + b"/report.html", "rb") as file:
            self.assertNotRegex(file.read(), re.compile(rb"<b>[^!*]"))


if __name__ == "__main__":
    unittest.main()
