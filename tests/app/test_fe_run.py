"""Rung rim from the command line: a light window, its ledger, interruption and resumption."""
import csv
import json
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest

import numpy as np
from command import RIMPACT, on_two_ranks, rimpact
from test_checkpoints import steps_kept

from report import vtu

WINDOW = ["run", "impact-window", "--set", "excitation.speed_m_per_s=0.05", "--quiet"]
MILD = ["--set", "bearing.material.steel.rate=cowper-symonds"]


def summary(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


class Threads(unittest.TestCase):
    """Of a run: the program rules what its libraries take, whatever the environment asks."""

    @staticmethod
    def most(**environment):
        """The largest number of threads, and processor time over wall time."""
        with tempfile.TemporaryDirectory() as folder:
            begin, before = time.monotonic(), os.times()
            process = subprocess.Popen([RIMPACT, *WINDOW, "--mesh", "0", "--no-fields", "-o", folder + "/run"], stderr=subprocess.DEVNULL,
                                       env={**os.environ, "RIMPACT_THREADS": "1", **environment})
            most = 0
            while process.poll() is None:
                try:
                    with open(f"/proc/{process.pid}/status") as file:
                        most = max(most, int(re.search(r"Threads:\s*(\d+)", file.read()).group(1)))
                except (OSError, AttributeError):
                    pass  # it has just ended
                time.sleep(0.02)
            after = os.times()
            return process.returncode, most, (after.children_user - before.children_user) / (time.monotonic() - begin)

    def test_the_libraries_take_one_whatever_the_environment_asks(self):
        code, alone, _ = self.most()
        self.assertEqual(code, 0)
        code, asked, share = self.most(OMP_NUM_THREADS="7", OPENBLAS_NUM_THREADS="7")
        self.assertEqual(code, 0)
        self.assertEqual(asked, alone)
        self.assertLess(alone, 7)  # its own and those of MPI
        self.assertLess(share, 1.1)  # nobody spins beside it

    def test_version_names_them(self):
        for environment in ({}, {"OMP_NUM_THREADS": "7", "OPENBLAS_NUM_THREADS": "7"}):
            said = json.loads(rimpact("version", "--json", **environment).stdout)
            self.assertEqual((said["BLAS threads"], said["OpenMP threads"]), ("1", "1"))


class RimWindow(unittest.TestCase):
    def test_light_window_and_resumption(self):
        with tempfile.TemporaryDirectory() as folder:
            whole, halves = os.path.join(folder, "whole"), os.path.join(folder, "halves")
            run = rimpact(*WINDOW, "-o", whole)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = summary(whole)
            energy = result["energy"]
            self.assertLess(abs(energy["imbalance_relative"]), 1e-3)
            self.assertLess(abs(energy["integrator_J"]), 0.01 * 0.5 * 86952 * 0.05**2)
            self.assertEqual(result["n_impacts"], 1)
            self.assertIsNone(result["min_normal_force_N"])  # a window without weight
            self.assertGreater(result["impacts"][0]["restitution"], 0.3)
            self.assertLess(result["impacts"][0]["restitution"], 1.0)
            # Impulse of the rim's force = change of momentum of the mass: independent of the solver.
            with open(os.path.join(whole, "response.csv")) as file:
                rows = list(csv.DictReader(file))
            impulse = sum(0.5 * (float(a["Ix_N"]) + float(b["Ix_N"])) * (float(b["time_s"]) - float(a["time_s"]))
                          for a, b in zip(rows, rows[1:]))
            change = -86952 * 0.05 * (1 + result["impacts"][0]["restitution"])
            self.assertAlmostEqual(impulse / change, 1, delta=0.005)

            process = subprocess.Popen([RIMPACT, *WINDOW, "-o", halves], stderr=subprocess.PIPE)
            while not steps_kept(halves, 20) and process.poll() is None:
                time.sleep(0.02)
            process.send_signal(signal.SIGINT)
            process.communicate()
            self.assertEqual(process.returncode, 130)
            self.assertEqual(summary(halves)["status"], "interrupted")
            run = rimpact(*WINDOW, "-o", halves, "--resume")
            self.assertEqual(run.returncode, 0, run.stderr)
            # Not bit for bit: the run that was not stopped keeps its factor there, and Newton stops at a residual of 1e-5.
            self.assertAlmostEqual(summary(halves)["peak_impact_force_N"] / result["peak_impact_force_N"], 1, delta=2e-5)
            other = rimpact(*WINDOW, "-o", halves, "--resume", "--set", "bearing.rim.height_mm=58")
            self.assertEqual(other.returncode, 3)  # another bearing's checkpoint is refused

    def test_killed_and_resumed_it_is_the_same_to_the_last_bit(self):
        for settings in ([], MILD):
            with self.subTest(settings=settings):
                self.killed_and_resumed(*settings)

    def killed_and_resumed(self, *settings):
        with tempfile.TemporaryDirectory() as folder:
            whole, killed = os.path.join(folder, "whole"), os.path.join(folder, "killed")
            words = [*WINDOW, *settings, "--mesh", "0", "--no-fields"]
            self.assertEqual(rimpact(*words, "-o", whole).returncode, 0)
            process = subprocess.Popen([RIMPACT, *words, "-o", killed], stderr=subprocess.PIPE)
            while not steps_kept(killed, 20) and process.poll() is None:
                time.sleep(0.02)
            process.kill()
            process.communicate()
            self.assertFalse(os.path.exists(os.path.join(killed, "summary.json")))
            run = rimpact(*words, "-o", killed, "--resume")
            self.assertEqual(run.returncode, 0, run.stderr)
            responses = []
            for one in (whole, killed):
                with open(os.path.join(one, "response.csv"), "rb") as file:
                    responses.append(file.read())
            self.assertEqual(*responses)

    def test_steel_that_knows_its_rate_is_pressed_less_and_harder(self):
        runs = {}
        with tempfile.TemporaryDirectory() as folder:
            for name, settings in (("static", []), ("fast", MILD), ("hardly", [*MILD, "--set", "bearing.material.steel.rate_D_per_s=1e9"])):
                run = rimpact(*WINDOW, *settings, "--mesh", "0", "--no-fields", "-o", os.path.join(folder, name))
                self.assertEqual(run.returncode, 0, run.stderr)
                runs[name] = summary(os.path.join(folder, name))
        static, fast, hardly = (run["impacts"][0] for run in runs.values())
        self.assertGreater(fast["peak_force_N"], 1.05 * static["peak_force_N"])
        self.assertLess(fast["peak_penetration_m"], 0.98 * static["peak_penetration_m"])
        self.assertGreater(fast["restitution"], static["restitution"])
        self.assertAlmostEqual(hardly["peak_force_N"] / static["peak_force_N"], 1, delta=0.03)  # the overstress falls with D to the fifth root
        for run in runs.values():
            self.assertLess(abs(run["energy"]["imbalance_relative"]), 1e-3)
        self.assertNotIn("steel_rate", runs["static"])
        self.assertEqual(runs["fast"]["steel_rate"], "cowper-symonds, D = 40 1/s, q = 5")

    def test_a_scene_that_ends_on_the_rim_has_its_rebound_doubted(self):
        with tempfile.TemporaryDirectory() as folder:
            for resumed in ([], ["--resume"]):
                run = rimpact(*WINDOW, "--mesh", "0", "--set", "excitation.duration_s=0.01", "-o", folder, *resumed)
                self.assertEqual(run.returncode, 0, run.stderr)
                result = summary(folder)
                self.assertEqual(result["n_impacts"], 1)
                self.assertEqual(result["impacts"][0]["peak_force_N"], result["peak_impact_force_N"])
                self.assertIn("while the rim still bears", " ".join(result["warnings"]))
                self.assertIn("while the rim still bears", run.stderr)
                os.remove(os.path.join(folder, "summary.json"))  # the resumed run goes on from the last checkpoint, which is the end

    def test_fields_of_an_impact_as_often_as_asked(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact(*WINDOW, "--mesh", "0", "--set", "excitation.duration_s=0.01", "--fields-every", "2", "-o", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(folder, "fields.pvd"), encoding="utf-8") as file:
                times = [float(time) for time in re.findall(r'timestep="([^"]*)"', file.read())]
            for k in range(1, 5):  # at the end of the step that passes it
                self.assertTrue(any(0 <= time - 2e-3 * k < 1e-3 for time in times), (k, times))
            first = os.path.join(folder, "fields", sorted(os.listdir(os.path.join(folder, "fields")))[0])
            with open(first, "rb") as file:
                points, cells = (int(number) for number in re.search(rb'NumberOfPoints="(\d+)" NumberOfCells="(\d+)"', file.read(3000)).groups())
            self.assertEqual(points, 27 * cells, "cells are as curved as they are")
            self.fields_are_what_they_say(first)
        self.assertEqual(rimpact(*WINDOW, "--fields-every", "0").returncode, 2)

    def fields_are_what_they_say(self, name):
        fields = vtu.read(name).point_data
        xx, yy, zz, xy, yz, zx = (fields[f"stress_{part}_MPa"] for part in ("xx", "yy", "zz", "xy", "yz", "zx"))
        mises = np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * (xy**2 + yz**2 + zx**2))
        np.testing.assert_allclose(fields["von_mises_MPa"], mises, rtol=1e-4, atol=1e-3)
        known = np.isfinite(fields["gap_mm"])
        self.assertTrue(0 < known.mean() < 0.2, "the gap is that of the touching surfaces")
        self.assertTrue(np.all(fields["contact_pressure_MPa"][~known] == 0))

    def test_a_slider_that_passes_the_rim_is_no_result(self):
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("run", "impact-window", "--quiet", "--mesh", "0", "--set", "bearing.rim.thickness_mm=0.1", "--set",
                          "excitation.speed_m_per_s=0.2", "-o", folder)
            self.assertEqual(run.returncode, 4, run.stderr)
            self.assertIn("passes through or over the rim", run.stderr)
            result = summary(folder)
            self.assertEqual((result["status"], result["n_impacts"]), ("stopped", 1))
            open_impact = result["impacts"][0]  # it never let go: no release, no rebound
            self.assertEqual([open_impact[key] for key in ("release_time_s", "rebound_speed_m_s", "restitution")], [None] * 3)

    def test_contact_gives_back_no_more_than_it_took(self):
        """An elastic window returns the speed it came with: before multipliers were carried on by their rate it returned 1.013."""
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact(*WINDOW, "--mesh", "0", "--set", "bearing.material.steel.yield_MPa=inf", "--no-fields", "-o", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            result = summary(folder)
            self.assertLess(abs(result["energy"]["contact_J"]), 0.01 * result["energy"]["initial_J"])
            self.assertAlmostEqual(result["impacts"][0]["restitution"], 1, delta=0.004)
            created = -result["energy"]["contact_J"] / result["energy"]["initial_J"]
            self.assertEqual("contact has given back" in run.stderr, created > 3e-3)

    def test_progress_is_told_in_words_and_the_machine_is_timed(self):
        with tempfile.TemporaryDirectory() as folder:
            window = [word for word in WINDOW if word != "--quiet"]
            run = rimpact(*window, "--mesh", "0", "--no-fields", "-o", os.path.join(folder, "run"), XDG_CACHE_HOME=folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertRegex(run.stderr, r"pressing, (at the rim|\d+\.\d mm into the rim), \d+ kN")
            self.assertNotIn(" of 0.2", run.stderr)  # a window ends at its release
            with open(os.path.join(folder, "rimpact", "machine.json")) as file:
                (machine,) = json.load(file).values()
            result = summary(os.path.join(folder, "run"))
            spent = sum(seconds for part, seconds in result["time_split_s"].items() if part != "output")
            self.assertAlmostEqual(machine["rim-mesh0-half"]["seconds_per_iteration_and_unknown"] * result["n_dofs"] * result["n_newton_iterations"], spent, places=6)

    def test_what_this_build_cannot_run_is_said(self):
        run = rimpact(*WINDOW, "--rung", "full")
        self.assertEqual(run.returncode, 2)
        self.assertIn("rim", run.stderr)

    def test_under_mpirun_the_first_rank_speaks(self):
        run = on_two_ranks("run", "no-such-scene")
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr.count("error: "), 1, run.stderr)

    def test_version_names_the_blas(self):
        table = json.loads(rimpact("version", "--json").stdout)
        self.assertEqual(set(table) & {"deal.II", "PETSc", "MUMPS", "SUNDIALS", "BLAS"}, {"deal.II", "PETSc", "MUMPS", "SUNDIALS", "BLAS"})

    def test_a_run_on_its_own_needs_no_folder_of_mpi(self):
        if " 4." not in subprocess.run(["mpirun", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]:
            self.skipTest("Open MPI 5 makes a folder, and removes none that others use")
        with tempfile.TemporaryDirectory() as folder:
            run = rimpact("version", TMPDIR=folder)
            self.assertEqual((run.returncode, os.listdir(folder)), (0, []), run.stderr)


class Plan(unittest.TestCase):
    def plan(self, *arguments):
        told = rimpact("check", "impact-window", "--json", *arguments)
        self.assertEqual(told.returncode, 0, told.stderr)
        return json.loads(told.stdout)

    def test_rung_and_mesh_as_for_run(self):
        plan = self.plan("--rung", "rigid-dish", "--mesh", "2", "--set", 'excitation.with=["weight","friction"]')
        self.assertEqual((plan["rung"], plan["mesh"]), ("rigid-dish", 2))


class OwnMesh(unittest.TestCase):
    """The built-in mesh, written and read back as a user's own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.mesh = os.path.join(self.folder.name, "drawn.msh")
        made = rimpact("mesh", "shfps-225", "--mesh", "0", "--curved", "-o", self.mesh)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.scene = os.path.join(self.folder.name, "scene.toml")
        with open(self.scene, "w") as file:
            file.write('[excitation]\nkind = "push"\ntravel_mm = 0.5\nreturn = false\n'
                       '[model]\nmesh = 0\n[model.own_mesh]\nfile = "drawn.msh"\n')

    def tearDown(self):
        self.folder.cleanup()

    def test_gives_the_force_of_the_built_in_mesh(self):
        forces = []
        for name, own in (("own", []), ("built-in", ["--set", 'model.own_mesh.file=""'])):
            out = os.path.join(self.folder.name, name)
            run = rimpact("run", self.scene, "-o", out, "--quiet", *own)
            self.assertEqual(run.returncode, 0, run.stderr)
            forces.append(summary(out)["peak_impact_force_N"])
        self.assertAlmostEqual(forces[0] / forces[1], 1, delta=2e-5)
        with open(os.path.join(self.folder.name, "own", "scene.toml")) as resolved:
            self.assertIn(self.mesh, resolved.read())  # by its absolute name

    def test_check_reads_it(self):
        told = rimpact("check", self.scene)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("it fits the bearing", told.stdout)
        table = json.loads(rimpact("check", self.scene, "--json").stdout)
        self.assertEqual(table["own_mesh"]["components"], 2)
        for change, needle in (('model.own_mesh.unit="mm"', "0.001 times as much"), ('model.own_mesh.groups.rim="ring"', '"ring" is not known'),
                               ("bearing.slider.diameter_mm=236", "402.00 and 200.51 mm at first touch"), ('model.own_mesh.file="other.msh"', "no such mesh file")):
            told = rimpact("check", self.scene, "--set", change)
            self.assertEqual(told.returncode, 3, told.stderr)
            self.assertIn(needle, told.stderr)

    def test_a_study_over_meshes_is_refused(self):
        told = rimpact("study", self.scene, "--axes", "mesh")
        self.assertEqual(told.returncode, 2)
        self.assertIn("--axes mesh", told.stderr)

    def test_the_mesh_of_a_run_can_be_written(self):
        out = os.path.join(self.folder.name, "run.msh")
        told = rimpact("mesh", "--scene", self.scene, "-o", out, "--json")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertEqual(json.loads(told.stdout)["components"], 2)
        self.assertGreater(os.path.getsize(out), 3e4)

    def test_the_mesh_of_a_scene_follows_mesh_and_whole(self):
        def cells(*arguments):
            told = rimpact("mesh", "--scene", "impact-window", "-o", os.path.join(self.folder.name, "of.msh"), "--json", *arguments)
            self.assertEqual(told.returncode, 0, told.stderr)
            return json.loads(told.stdout)["cells"]

        draft = cells("--mesh", "0")
        self.assertLess(draft, cells())
        self.assertEqual(cells("--mesh", "0", "--whole"), 2 * draft)
        told = rimpact("mesh", "shfps-225", "--rung", "full", "-o", os.path.join(self.folder.name, "of.msh"))
        self.assertEqual(told.returncode, 2)
        self.assertIn("--scene", told.stderr)


if __name__ == "__main__":
    unittest.main()
