"""rimpact building: the run folder, the tables, ParaView's series, the picture, refusals with their exit codes."""
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import numpy as np

RIMPACT = os.environ["RIMPACT"]
SHORT = ["--set", "excitation.duration_s=3", "--set", "excitation.scale=1.05", "--set", "reduced.elastic_slip_mm=1", "--set", "reduced.tolerance=1e-7", "--quiet"]


def rimpact(*arguments):
    return subprocess.run([RIMPACT, *arguments], capture_output=True, text=True)


def rows(path):
    with open(path) as file:
        return list(csv.DictReader(file))


class Run:
    """One building, run once, and what any of them leaves."""
    WORDS: list[str] = []

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = os.path.join(cls.scratch.name, "run")
        cls.run_ = rimpact("building", "ricker-0.78g-1.0s", "-o", cls.folder, "--json", "--vtk-step", "500", *cls.WORDS, *SHORT)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_its_tables_are_a_frame(self):
        again = os.path.join(self.scratch.name, "again")
        run = rimpact("building", "ricker-0.78g-1.0s", "--frame", self.folder, "-o", again, "--json", *SHORT)
        self.assertEqual(run.returncode, 0, run.stderr)
        first, second = json.loads(self.run_.stdout), json.loads(run.stdout)
        self.assertAlmostEqual(second["peak_lateral_force_N"] / first["peak_lateral_force_N"], 1, places=6)


    def test_is_not_compared_with_one_bearing(self):
        alone = os.path.join(self.scratch.name, "alone")
        run = rimpact("reduced", "ricker-0.78g-1.0s", "-o", alone, *SHORT)
        self.assertEqual(run.returncode, 0, run.stderr)
        run = rimpact("compare", alone, self.folder)
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stderr, r"building \(one bearing against \d bearings under \d+ kN, frame \w{8}\)")
        self.assertEqual(rimpact("compare", alone, self.folder, "--anyway").returncode, 0)
        self.assertEqual(rimpact("compare", self.folder, self.folder).returncode, 0)
        self.assertEqual(rimpact("compare", self.folder, os.path.join(self.folder, "response.h5")).returncode, 0)  # a file does not tell


class Building(Run, unittest.TestCase):
    WORDS = ["--png"]

    def file(self, name):
        return os.path.join(self.folder, name)

    def test_summary_on_the_screen_and_in_the_folder(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stderr)
        said = json.loads(self.run_.stdout)
        with open(self.file("summary.json")) as kept:
            kept = json.load(kept)
        self.assertEqual(said["peak_lateral_force_N"], kept["peak_lateral_force_N"])
        building = kept["building"]
        self.assertEqual((len(building["bearings"]), len(building["floors"])), (6, 3))
        worst = building["bearings"][building["worst_bearing"] - 1]
        self.assertEqual(worst["peak_impact_force_N"], max(b["peak_impact_force_N"] for b in building["bearings"]))
        self.assertAlmostEqual(sum(b["static_normal_force_N"] for b in building["bearings"]), 5120e3, delta=1)
        self.assertLess(abs(kept["energy"]["imbalance_relative"]), 1e-5)

    def test_signals_add_up(self):
        with h5py.File(self.file("response.h5")) as file:
            signal = {name: file[f"response/{name}"][:] for name in file["response"]}
        total = sum(signal[f"bearing_{b}_force_x"] for b in range(1, 7))
        np.testing.assert_allclose(total, signal["force_x"], atol=1e-6 * np.abs(total).max())
        np.testing.assert_allclose(signal["floor_2_displacement_x"] - signal["floor_1_displacement_x"], signal["floor_2_drift_x"], atol=1e-12)
        self.assertEqual(len(signal["time"]), len(signal["overturning_y"]))

    def test_members_and_elevation(self):
        members = rows(self.file("members.csv"))
        self.assertEqual(len(members), 2 * 46)
        for row in members:
            self.assertLessEqual(float(row["least_M_y_N_m"]), float(row["at_rest_M_y_N_m"]))
            self.assertGreaterEqual(float(row["largest_M_y_N_m"]), float(row["at_rest_M_y_N_m"]))
        elevation = rows(self.file("elevation.csv"))
        self.assertEqual(len(elevation), 24)
        self.assertGreater(max(float(row["rim_force_N"] or 0) for row in elevation), 0)

    def test_series_for_paraview(self):
        sets = xml.parse(self.file("fields.pvd")).findall(".//DataSet")
        self.assertEqual(len(sets), 7)  # 0, 0.5, ... 3 s
        piece = xml.parse(self.file(sets[-1].get("file"))).find(".//Piece")
        self.assertEqual((piece.get("NumberOfPoints"), piece.get("NumberOfCells")), ("24", "52"))
        moved = piece.find("PointData/DataArray").text.split()
        self.assertEqual(len(moved), 3 * 24)

    def test_picture(self):
        self.assertGreater(os.path.getsize(self.file("building.png")), 20000)

    def test_bearings_of_their_own(self):
        frame = os.path.join(self.scratch.name, "mixed.toml")
        with open(frame, "w") as file:
            file.write('name = "mixed"\nx_m = [0.0, 8.0]\ny_m = [0.0, 8.0]\nstoreys_m = [3.5]\n[bearings]\n1 = "fps-225"\n')
        run = rimpact("building", "ricker-0.78g-1.0s", "--frame", frame, "-o", os.path.join(self.scratch.name, "mixed"), "--json", *SHORT)
        self.assertEqual(run.returncode, 0, run.stderr)
        bearings = json.loads(run.stdout)["building"]["bearings"]
        self.assertNotAlmostEqual(bearings[0]["peak_force_N"], bearings[3]["peak_force_N"], delta=1000)

    def test_bearings_for_opensees(self):
        out = os.path.join(self.scratch.name, "opensees")
        run = rimpact("export", self.folder, "--opensees", "-o", out)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(len(run.stdout.split()), 14)
        self.assertIn("normal force", run.stderr)
        calls = []

        class Recorder:  # stands for openseespy.opensees
            def __getattr__(self, name):
                return lambda *arguments: calls.append((name, arguments)) or (0.0, 0.0, 0.0)
        sys.path.insert(0, out)
        try:
            import bearings
            bearings.place(Recorder())
        finally:
            sys.path.remove(out)
        plates = [arguments for name, arguments in calls if name == "fix" and arguments[0] < 200000]
        self.assertEqual([p[0] for p in plates], [100001 + i for i in range(6)])
        nodes = [arguments[0] for name, arguments in calls if name == "node"]
        self.assertEqual(len(nodes), len(set(nodes)))  # no bearing's own nodes are another's
        loads = []
        for node in range(1, 7):
            with open(os.path.join(out, f"bearing_{node}.py")) as file:
                loads += [float(line.split("=")[1].split("#")[0]) for line in file if line.startswith("dead_load")]
        self.assertAlmostEqual(sum(loads), 5120e3, delta=10)

    def test_sweep(self):
        out = os.path.join(self.scratch.name, "sweep")
        command = ["building", "ricker-0.78g-1.0s", "--sweep", "excitation.scale=0.3:1.05:2", "-o", out, "--json", *SHORT]
        run = rimpact(*command)
        self.assertEqual(run.returncode, 0, run.stderr)
        table, single = rows(os.path.join(out, "table.csv")), json.loads(self.run_.stdout)
        self.assertEqual([row["status"] for row in table], ["done", "done"])
        building = single["building"]
        for column, value in (("peak_lateral_force_N", single["peak_lateral_force_N"]), ("peak_impact_force_N", single["peak_impact_force_N"]),
                              ("peak_overturning_N_m", building["peak_overturning_N_m"]), ("worst_bearing", building["worst_bearing"]),
                              ("n_bearings_hit", sum(b["impacts"] > 0 for b in building["bearings"])),
                              ("floor_3_peak_acceleration_m_s2", building["floors"][2]["peak_acceleration_m_s2"])):
            self.assertAlmostEqual(float(table[1][column]) / value, 1, places=6, msg=column)
        self.assertEqual(float(table[0]["n_bearings_hit"]), 0)
        run = rimpact(*[word for word in command if word != "--quiet"])
        again = json.loads(run.stdout)
        self.assertEqual((again["kept"], again["done"]), (2, 2))
        self.assertIn("first run:", run.stderr)
        self.assertNotIn("load", run.stderr)  # a building's bearings carry what stands on them
        other = rimpact(*command, "--frame", "thesis-3.5")
        self.assertEqual(other.returncode, 2, other.stderr)
        self.assertIn("another scene or other values", other.stderr)

    def frame_with(self, name, table, column, cell):
        """A copy of the run's frame with another cell in the last row of a table."""
        folder = os.path.join(self.scratch.name, name)
        os.makedirs(folder)
        for each in ("nodes.csv", "elements.csv", "diaphragms.csv"):
            shutil.copy(self.file(each), folder)
        lines = rows(os.path.join(folder, table))
        lines[-1][column] = cell
        with open(os.path.join(folder, table), "w", newline="") as file:
            writer = csv.DictWriter(file, lines[0].keys())
            writer.writeheader()
            writer.writerows(lines)
        return folder

    def test_a_slip_of_units_is_doubted_before_the_run(self):
        frame = self.frame_with("heavy", "diaphragms.csv", "inertia_kg_m2", "1e20")
        run = rimpact("building", "ricker-0.78g-1.0s", "--frame", frame, "-o", os.path.join(self.scratch.name, "none"), *SHORT)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("inertia over that of its plan", run.stderr)
        self.assertIn("far too heavy for what does", run.stderr)

    def test_a_member_of_no_node_is_refused_before_it_is_doubted(self):
        frame = self.frame_with("loose", "elements.csv", "j", "99")
        for sweep in ([], ["--sweep", "excitation.scale=0.3:1.05:2"]):
            run = rimpact("building", "ricker-0.78g-1.0s", "--frame", frame, *sweep, "-o", os.path.join(self.scratch.name, "none"), *SHORT)
            self.assertEqual(run.returncode, 3, run.stderr)
            self.assertIn("the frame has nodes 1 to 24", run.stderr)

    def test_a_changed_bearing_file_makes_a_sweep_anew(self):
        self.assertEqual(rimpact("new", os.path.join(self.scratch.name, "own")).returncode, 0)
        bearing, frame = (os.path.join(self.scratch.name, name) for name in ("own/bearing.toml", "own-frame.toml"))
        with open(frame, "w") as file:
            file.write(f'name = "own"\nx_m = [0.0, 8.0]\ny_m = [0.0, 8.0]\nstoreys_m = [3.5]\n[bearings]\n1 = "{bearing}"\n')
        short = [word for word in SHORT if word != "--quiet"]
        for changed in (False, True):
            if changed:
                with open(bearing, "a") as file:
                    file.write("# another batch\n")
            run = rimpact("building", "ricker-0.78g-1.0s", "--frame", frame, "--sweep", "excitation.scale=0.5:1.05:2", "--json",
                          "-o", os.path.join(self.scratch.name, "own-sweep"), *short)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(json.loads(run.stdout)["kept"], 0)
            self.assertEqual("every run is made again" in run.stderr, changed, run.stderr)

    def test_refusals(self):
        folder = os.path.join(self.scratch.name, "refused")
        broken = os.path.join(self.scratch.name, "broken.toml")
        with open(broken, "w") as file:
            file.write('x_m = [0.0, 8.0]\ny_m = [8.0, 0.0]\n')
        for code, needle, arguments in (
                (2, "no such file", ["--frame", "nowhere.toml"]),
                (2, "broken.toml:2:", ["--frame", broken]),
                (2, "normal_force", ["--set", "reduced.normal_force=\"static\""]),
                (2, "isolator.space", ["--set", "reduced.model=\"dcfp\""])):
            run = rimpact("building", "ricker-0.78g-1.0s", "-o", folder, *arguments)
            self.assertEqual(run.returncode, code, run.stderr)
            self.assertIn(needle, run.stderr)
            self.assertEqual(run.stdout, "")


class InelasticFrame(Run, unittest.TestCase):
    WORDS = ["--frame", "thesis-2.5"]

    def test_summary(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stderr)
        said = json.loads(self.run_.stdout)
        inelastic = said["building"]["inelastic"]
        self.assertEqual([s["name"] for s in inelastic["sections"]], ["column", "beam"])
        self.assertIn("column.yield_kN_m by [design]", inelastic["assumed"])
        self.assertGreater(inelastic["sections"][0]["yielded_ends"], 0)
        self.assertGreater(said["energy"]["plastic_J"], 0)
        self.assertLess(abs(said["energy"]["imbalance_relative"]), 1e-3)
        self.assertAlmostEqual(said["building"]["weight_N"], 2560e3, delta=1)

    def test_what_its_dishes_stand_on_is_said_read_and_kept(self):
        springs = json.loads(self.run_.stdout)["building"]["dish_springs"]
        self.assertEqual(springs, {"stiffness_N_per_m": 4e9, "restitution": 0.65, "assumed": True})
        folder, again = (os.path.join(self.scratch.name, name) for name in ("soft", "soft-again"))
        key = "isolator.contact_stiffness_kN_per_m"
        run = rimpact("building", "ricker-0.78g-1.0s", *self.WORDS, "-o", folder, "--set", f"{key}=500000", *SHORT)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("not read", run.stderr)
        self.assertIn("every dish stands on a spring of 1e+06 kN/m", run.stdout)
        run = rimpact("building", os.path.join(folder, "scene.toml"), *self.WORDS, "-o", again, "--json", *SHORT)
        self.assertEqual(json.loads(run.stdout)["building"]["dish_springs"], {"stiffness_N_per_m": 1e9, "restitution": 0.65, "assumed": False})
        linear = rimpact("building", "ricker-0.78g-1.0s", "-o", os.path.join(self.scratch.name, "linear"), "--json", "--set", f"{key}=500000", *SHORT)
        self.assertIn(f"{key} is not read by this scene", linear.stderr)
        self.assertNotIn("dish_springs", json.loads(linear.stdout)["building"])

    def test_hinges_and_signals(self):
        hinges = rows(os.path.join(self.folder, "hinges.csv"))
        self.assertEqual(len(hinges), 2 * 17)
        with h5py.File(os.path.join(self.folder, "response.h5")) as file:
            signal = {name: file[f"response/{name}"][:] for name in file["response"]}
        for row in hinges:
            moment = signal[f"member_{row['element']}_moment_{row['end']}"]
            self.assertLessEqual(np.abs(moment).max(), float(row["peak_moment_N_m"]) * (1 + 1e-5))
        self.assertTrue((np.diff(signal["energy_plastic"]) >= 0).all())
        self.assertFalse(signal["floor_3_displacement_y"].any())

    def test_members_carry_the_weight(self):
        columns = [row for row in rows(os.path.join(self.folder, "members.csv")) if row["end"] == "i" and row["node"] in "123" and float(row["at_rest_N_x_N"]) > 3e5]
        self.assertEqual(len(columns), 3)
        self.assertAlmostEqual(sum(float(row["at_rest_N_x_N"]) for row in columns), 1920e3, delta=3e3)

    def test_refusals(self):
        frame = os.path.join(self.scratch.name, "frame.toml")
        with open(frame, "w") as file:
            file.write("x_m = [0.0, 8.0]\nstoreys_m = [3.5]\nload_kN_per_m = 40.0\n[column]\nhinge_length_mm = 700.0\n")
        for needle, arguments in ((f"{frame}:5", ["--frame", frame]), ("direction_deg 30", ["--frame", "thesis-2.5", "--set", "excitation.direction_deg=30"]),
                                  ("isolator.space", ["--frame", "thesis-2.5", "--set", 'reduced.model="dcfp"'])):
            run = rimpact("building", "ricker-0.78g-1.0s", "-o", os.path.join(self.scratch.name, "refused"), *arguments)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(needle, run.stderr)


if __name__ == "__main__":
    unittest.main()
