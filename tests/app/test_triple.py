"""Triple pendulums as a user asks for them: a run and its report, sweeps, bounds, comparison, buildings; what is refused, and why."""
import csv
import html
import json
import os
import re
import tempfile
import unittest

import h5py
import numpy as np
from command import Refusals, rimpact


class Scratch(unittest.TestCase):
    def setUp(self) -> None:
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name + "/triple"

    def done(self, *words: str) -> str:
        run = rimpact(*words)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout


class Runs(Scratch):
    def test_faces_of_a_run_and_their_report(self) -> None:
        self.done("reduced", "tfp-pulse", "-o", self.folder, "--quiet")
        with open(self.folder + "/summary.json") as file:
            summary = json.load(file)
        faces = summary["isolator"]["faces"]
        with h5py.File(self.folder + "/response.h5") as file:
            signal = {name: file["response"][name][()] for name in file["response"]}
        self.assertEqual([face["face"] for face in faces], [1, 2, 3, 4])
        for face in faces:
            travel, force = (signal[f"face_{face['face']}_{what}"] for what in ("travel_x", "rim_force"))
            self.assertGreater(face["rim_peak_force_N"], 0)
            self.assertGreater(face["rim_peak_penetration_m"], 0)
            self.assertLess(abs(face["peak_travel_m"] / np.abs(travel).max() - 1), 0.01)
            self.assertLess(abs(face["rim_touched_s"] - signal["time"][np.argmax(force > 0)]), 0.02)
        # A slide plate pressed against its rim turns a little on the springs of its contacts.
        sum_of_faces = sum(signal[f"face_{i}_travel_x"] for i in range(1, 5))
        self.assertLess(np.abs(sum_of_faces - signal["displacement_x"]).max(), 0.01)
        self.assertLess(signal["gap"].min(), 0)
        hardest = max(summary["impacts"], key=lambda impact: impact["peak_force_N"])
        self.assertAlmostEqual(hardest["peak_penetration_m"], signal["face_4_rim_penetration"].max(), 6)
        self.assertLess(abs(hardest["peak_penetration_m"] / faces[3]["rim_peak_penetration_m"] - 1), 0.01)
        self.done("report", self.folder)
        with open(self.folder + "/report.html", encoding="utf-8") as file:
            page = html.unescape(re.sub(r"[ \n]+", " ", re.sub(r"<[^>]+>", " ", file.read())))
        self.assertIn("tfp-kim-2023", page)
        self.assertIn("What each face of the triple pendulum adds to the displacement", page)
        self.assertIn("Triple friction pendulum name tfp-kim-2023", page)
        self.assertNotIn("Assumed, not given", page)  # of a dish, of which nothing is read

    def test_each_stop_has_its_own_law(self) -> None:
        for stop, k in (("outer", 3e5), ("inner", 2e6)):
            os.makedirs(f"{self.folder}/{stop}")
            law = {"name": "bilinear", "belongs_to": "rim", "element": {"k_i": {"value": k / 2, "unit": "kN/m"}, "yield_force": {"value": 500.0, "unit": "kN"},
                                                                        "hardening": {"value": 0.1, "unit": "-"}}}
            with open(f"{self.folder}/{stop}/calibration.json", "w") as file:
                json.dump({"answer": {"bearing": stop, "rims_in_series": 2, "law": law}}, file)
        run = rimpact("reduced", "tfp-pulse", "--calibration", self.folder + "/outer", "--inner-calibration", self.folder + "/inner", "-o", self.folder + "/run")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stdout, "impact element: bilinear, k_i = 300000 kN/m.*outer")
        self.assertRegex(run.stdout, "of the inner rims: bilinear, k_i = 2e[+]06 kN/m.*inner")
        again = rimpact("reduced", self.folder + "/run/scene.toml", "-o", self.folder + "/again", "--quiet")
        self.assertEqual(again.returncode, 0, again.stderr)
        with open(self.folder + "/run/response.csv") as one, open(self.folder + "/again/response.csv") as other:
            self.assertEqual(one.read(), other.read(), "a run needs the folders no more")
        self.done("report", self.folder + "/run")
        with open(self.folder + "/run/report.html", encoding="utf-8") as file:
            self.assertIn("inner rims: impact stiffness", html.unescape(file.read()))

    def test_what_was_run_runs_again(self) -> None:
        self.done("reduced", "tfp-stages", "-o", self.folder, "--quiet")
        again = rimpact("reduced", self.folder + "/scene.toml", "-o", self.folder + "-again", "--json")
        self.assertEqual((again.returncode, again.stderr.count("warning:")), (0, 0), again.stderr)
        with open(self.folder + "/response.csv") as one, open(self.folder + "-again/response.csv") as other:
            self.assertEqual(one.read(), other.read())

    def test_a_case_of_ones_own(self) -> None:
        said = rimpact("new", self.folder, "--scene", "tfp-stages")
        self.assertIn("rimpact reduced " + self.folder + "/scene.toml", said.stderr)
        self.assertEqual(os.listdir(self.folder), ["scene.toml"])
        run = rimpact("reduced", self.folder, "-o", self.folder + "/run", "--json")
        self.assertEqual((run.returncode, run.stderr.count("warning:")), (0, 0), run.stderr)
        self.assertGreater(json.loads(run.stdout)["peak_displacement_m"], 0.139)

    def test_bounds(self) -> None:
        table = json.loads(self.done("reduced", "tfp-pulse", "--bounds", "lower,upper", "-o", self.folder, "--json", "--set", "excitation.scale=0.8"))
        rows = {row["quantity"]: row["values"] for row in table["rows"]}
        self.assertGreater(rows["peak displacement"]["lower"], rows["peak displacement"]["upper"])
        self.assertGreater(rows["peak displacement"]["upper"], 100)

    def test_a_sweep_in_shards_gathered_and_kept(self) -> None:
        words = ("reduced", "tfp-pulse", "--sweep", "isolator.inner.mu_fast=0.01:0.03:2", "--sweep", "isolator.inner.travel_mm=80:90:2", "-o", self.folder, "--set",
                 "excitation.duration_s=8", "--json", "--quiet")
        self.assertEqual([json.loads(self.done(*words, "--shard", f"{i}/2"))["n_runs"] for i in (1, 2)], [2, 2])
        whole = json.loads(self.done(*words))
        self.assertEqual((whole["n_runs"], whole["kept"], whole["done"]), (4, 4, 4))
        with open(whole["table"], newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["isolator.inner.travel_mm"] for row in rows}, {"80", "90"})
        self.assertEqual(len({row["peak_displacement_m"] for row in rows}), 4)

    def test_two_runs_compared(self) -> None:
        for name, more in (("one", ()), ("other", ("--set", "isolator.inner.travel_mm=80"))):
            self.done("reduced", "tfp-pulse", "-o", f"{self.folder}/{name}", "--quiet", *more)
        words = ("compare", f"{self.folder}/one", f"{self.folder}/other", "-o", self.folder + "/compared")
        apart = rimpact(*words)
        self.assertEqual(apart.returncode, 2)
        self.assertIn("isolator.inner.travel_mm (101.6 against 80)", apart.stderr)
        self.assertIn("isolator.inner.travel_mm", self.done(*words, "--anyway"))

    def test_a_building_by_name_and_its_fleet(self) -> None:
        os.makedirs(self.folder)
        frame = self.folder + "/frame.toml"
        with open(frame, "w") as file:
            file.write('name = "own"\nx_m = [0.0, 8.0]\ny_m = [0.0, 8.0]\nstoreys_m = [3.5]\n[bearings]\n1 = "tfp-fenz-2008"\n2 = "tfp"\n')
        words = ("building", "ricker-0.78g-1.0s", "--frame", frame, "--set", "excitation.scale=0.1", "--set", "excitation.duration_s=3", "--set",
                 'isolator.space="spatial"', "--set", "isolator.points=4", "--quiet")
        self.done(*words, "-o", self.folder + "/run")
        with open(self.folder + "/run/summary.json") as file:
            summary = json.load(file)
        self.assertEqual(summary["status"], "done")
        self.assertEqual(len(summary["building"]["bearings"]), 4)
        export = rimpact("export", self.folder + "/run", "--opensees", "--quiet")
        self.assertEqual(export.returncode, 2, export.stderr)
        self.assertIn('the bearing under node 1 is of rigid bodies ("tfp"): only dishes are exported', export.stderr)
        whole = json.loads(self.done(*words, "-o", self.folder + "/fleet", "--sweep", "excitation.scale=0.05:0.1:2", "--json"))
        self.assertEqual((whole["n_runs"], whole["done"]), (2, 2))


class UnderAFrame(Scratch):
    def test_an_inelastic_frame_stands_on_triple_pendulums(self) -> None:
        self.done("building", "tfp-pulse", "--frame", "thesis-2.5", "--set", 'isolator.space="spatial"', "--set", "isolator.points=4", "--set",
                  "excitation.duration_s=1.2", "--quiet", "-o", self.folder)
        with open(self.folder + "/summary.json") as file:
            summary = json.load(file)
        self.assertEqual(summary["status"], "done", summary.get("reason"))
        self.assertLess(abs(summary["energy"]["imbalance_relative"]), 1e-3)


class Refused(Refusals):
    def test_by_finite_elements_and_what_is_of_one_dish(self) -> None:
        for verb, *words in (["check"], ["run"], ["study"], ["main", "--dry-run"], ["geometry", "--dry-run"]):
            self.refused(2, '"tfp"', "[bearing]", "its stops", "`rimpact reduced`", arguments=[verb, "tfp-pulse", *words])
        for setting, needle in (('reduced.integrator="cvode"', "cvode"), ('excitation.kind="window"', "rim element of the physical model"),
                                ('reduced.normal_force="pad"', "follow from the motion"), ("reduced.socket_friction=true", "its slider is rigid"),
                                ("excitation.direction_deg=30", "needs \"spatial\""), ('reduced.impact_law="curve"', "impact_curve")):
            self.refused(2, needle, arguments=["reduced", "tfp-pulse", "-o", "nowhere", "--set", setting])
        self.refused(2, "one dish", arguments=["reduced", "tfp-pulse", "-o", "nowhere", "--nodes", "0,100"])

    def test_a_law_of_inner_rims_elsewhere(self) -> None:
        for verb, *words in (["geometry", "shfps-225", "--dry-run"], ["mesh", "shfps-225", "-o", "nowhere.msh"], ["reduced", "impact-window", "-o", "nowhere"]):
            self.refused(2, "inner", arguments=[verb, *words, "--inner-calibration", "/nowhere"])

    def test_a_bearing_of_bearing_beside_rigid_bodies(self) -> None:
        self.refused(2, "--bearing dcfp-155", "[isolator]", arguments=["new", "/proc/nowhere", "--scene", "tfp-stages", "--bearing", "dcfp-155"])

    def test_the_catalogues_name_where_a_scene_is_asked_for(self) -> None:
        for words in (["reduced", "tfp-kim-2023", "-o", "nowhere"], ["main", "tfp-kim-2023", "--dry-run"], ["new", "nowhere", "--bearing", "tfp-kim-2023"],
                      ["mesh", "tfp-kim-2023", "-o", "nowhere.msh"]):
            self.refused(2, 'isolator.name = "tfp-kim-2023" beside reduced.model = "tfp"', arguments=words)

    def test_under_a_building_in_the_plane(self) -> None:
        self.refused(2, "isolator.space", arguments=["building", "tfp-pulse", "-o", "nowhere"])
        self.refused(2, "isolator.space", arguments=["building", "tfp-pulse", "--frame", "thesis-2.5", "-o", "nowhere"])


if __name__ == "__main__":
    unittest.main()
