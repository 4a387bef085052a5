"""What `rimpact export` writes for other programs is read back: tables parsed and flown, doubts said, bad input refused."""
import csv
import json
import math
import os
import re
import tempfile
import unittest

from command import rimpact
from exported import Exported, Recorder, calibration, write


class Export(Exported):
    def test_tables_and_self_check(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as out:
            run = self.exported(folder, "--sap2000", "--csv", "--json", "-o", out)
            table = json.loads(run.stdout)
            self.assertEqual(sorted(os.listdir(out)), ["bearing.s2k", "law.csv", "rim-link.csv"])
            check = table["self_checks"][0]
            self.assertEqual(len(check["rows"]), 5)
            self.assertLess(check["peak_force_difference"], 0.01)
            # the pasted table, flown here once more: a third integrator of gap and kinematic link in series
            with open(os.path.join(out, "rim-link.csv")) as file:
                lines = [line for line in file if not line.startswith("#")]
            rows = [row for row in csv.DictReader(lines) if row["link"] == "RIM" and float(row["displacement_m"]) <= 0]
            points = sorted((-float(row["displacement_m"]), -float(row["force_kN"]) * 1e3) for row in rows)
            with open(os.path.join(out, "bearing.s2k")) as file:
                gap = 1e3 * float(re.search(r"Link=RIM_GAP .* TransK=(\S+)", file.read()).group(1))
            points = [(d + f / gap, f) for d, f in points]
            unloading = 1 / (1 / (points[1][1] / (points[1][0] - points[1][1] / gap)) + 1 / gap)
            for row in check["rows"]:
                speed, work, depth = row["speed_m_s"], 0.0, 0.0
                energy = 86952 * speed ** 2 / 2
                for (d0, f0), (d1, f1) in zip(points, points[1:]):
                    area = (d1 - d0) * (f0 + f1) / 2
                    if work + area >= energy:
                        slope, left = (f1 - f0) / (d1 - d0), energy - work
                        step = (-f0 + math.sqrt(f0 * f0 + 2 * slope * left)) / slope
                        depth, force = d0 + step, f0 + slope * step
                        break
                    work += area
                self.assertAlmostEqual(force / 1e3 / row["spring"]["peak_force_kN"], 1, places=3)
                self.assertAlmostEqual(1e3 * depth / row["spring"]["penetration_mm"], 1, places=3)
                self.assertAlmostEqual(force / math.sqrt(unloading * 86952) / speed, row["spring"]["rebound"], places=3)

    def test_pulses_and_second_hits_carry_their_numbers(self):
        with tempfile.TemporaryDirectory() as folder:
            run = self.exported(folder, "--opensees", "--sap2000", "--json")
            checks = json.loads(run.stdout)["self_checks"]
            heads = []
            for name in ("impact.py", "bearing.s2k"):
                with open(os.path.join(folder, name)) as file:
                    heads.append(" ".join(line.lstrip("#$ ").rstrip() for line in file if line[0] in "#$"))
            for check, head in zip(checks, heads):
                self.assertEqual(len(check["second_hits"]), 5)
                self.assertEqual({row["pulse"] for row in check["pulses"]["rows"]}, {"ricker-0.78g-1.0s", "ricker-0.38g-1.5s"})
                for row in check["pulses"]["rows"]:
                    model, own = row["model"], row["exported"]
                    doubted = [doubt for doubt in check["doubts"] if f"{row['name']}:" in doubt]
                    self.assertEqual(len(doubted), check["pulses"]["written"] and row["peak_force_difference"] > 0.1, row)
                    for side in (model, own):
                        if side["touch_speed_m_s"]:
                            self.assertIn(f"{side['touch_speed_m_s']:.3f} m/s, {side['peak_force_kN']:.0f} kN", head)
                for doubt in check["doubts"]:
                    self.assertRegex(doubt, r"[0-9.]+ m/s.* kN|mm")
                    self.assertIn(doubt.replace(";", ","), head)  # as comments have it
                    self.assertIn(doubt, run.stderr)
            rides, flat = (check["pulses"] for check in checks)
            # a slider that rides arrives as the model does; one that stays in its plane faster, and says by how much
            for row in rides["rows"]:
                if (row["model"]["touch_speed_m_s"] or 0) > 0.3:
                    self.assertAlmostEqual(row["exported"]["touch_speed_m_s"] / row["model"]["touch_speed_m_s"], 1, delta=0.06)
            self.assertGreater(flat["peak_force_difference"], 2 * rides["peak_force_difference"])
            for pulses in (rides, flat):  # under a load that varies, too
                self.assertEqual([row["vertical_g"] for row in pulses["rows"]].count(0.3), 2)
            # a slider in its plane hits half as hard again: it is refused, not doubted, and the links of the rim stay
            self.assertTrue(rides["written"])
            self.assertFalse(flat["written"])
            with open(os.path.join(folder, "bearing.s2k")) as file:
                text = file.read()
            self.assertNotIn("Link=DISH", text)
            self.assertIn("Link=RIM_GAP", text)
            self.assertIn("the whole bearing is refused", run.stderr)
            anyway = json.loads(self.exported(folder, "--sap2000", "--json", "--anyway").stdout)
            self.assertTrue(anyway["whole_bearing"])
            self.assertTrue(any("DOUBT: the exported bearing differs" in doubt for doubt in anyway["self_checks"][0]["doubts"]))
            with open(os.path.join(folder, "bearing.s2k")) as file:
                self.assertIn("Link=DISH", file.read())

    def test_heads_carry_the_errors_and_what_pad_and_socket_do(self):
        with tempfile.TemporaryDirectory() as folder:
            content = calibration(identity=self.rim)
            content["answer"]["stack"] = {"finite_pad": True, "socket_friction": True, "friction": "park-wen", "elastic_slip_mm": 0.14, "elastic_slip_from": "fit"}
            write(folder, content)
            run = rimpact("export", folder, "--opensees", "--etabs", "--csv", "--anyway", "--scene", "shfps-225")
            self.assertEqual(run.returncode, 0, run.stderr)
            for name, needles in (("impact.tcl", ["the socket's friction in the coefficient"]), ("bearing.e2k", ["the socket's friction in the coefficient"]), ("law.csv", [])):
                with open(os.path.join(folder, name)) as file:
                    head = " ".join(line.lstrip("#$ ").rstrip() for line in file if line[0] in "#$")
                for needle in ["Error of the answer: Peak force: within about 28 %", "without them the model has", "with them", *needles]:
                    self.assertIn(needle, head, name)

    def test_beyond_ten_per_cent_is_said(self):
        # a law from 0.02 to 3 m/s: four springs cannot follow two decades
        with tempfile.TemporaryDirectory() as folder:
            run = self.exported(folder, "--opensees", "--quiet", valid_from_m_s=0.02, valid_to_m_s=3.0)
            self.assertIn("Self-check of the four ElasticPPGap", run.stderr)
            with open(os.path.join(folder, "impact.tcl")) as file:
                self.assertIn("DOUBT: Self-check", file.read())

    def test_mass_and_load_go_together(self):
        for arguments, said in ((["--mass", "40000"], "Load 392.4 kN, mass 40000 kg"), (["--load", "392.4"], "Load 392.4 kN, mass 40000 kg"),
                                (["--load", "500", "--mass", "40000"], "Load 500 kN, mass 40000 kg")):
            with tempfile.TemporaryDirectory() as folder:
                self.exported(folder, "--csv", *arguments)
                with open(os.path.join(folder, "law.csv")) as file:
                    self.assertIn(said, file.read())
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.toml")
            with open(scene, "w") as file:
                file.write("[load]\nvertical_kN = 400\n")
            write(folder, calibration(identity=self.rim))
            run = rimpact("export", folder, "--csv", "--scene", scene)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("carries 400 kN", run.stderr)  # the files stay for the calibration's

    def test_refusals(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(rimpact("export", folder, "--csv").returncode, 3)  # no calibration.json
            write(folder, calibration(identity=self.rim))
            for code, needle, arguments in ((2, "--sap2000", []), (2, "--mass", ["--csv", "--mass", "-1"]), (2, "not among the laws", ["--csv", "--law", "signed"]),
                                            (2, "no constant pair", ["--csv", "--law", "pair"]), (2, "another bearing", ["--csv", "--scene", "fps-225"])):
                run = rimpact("export", folder, *arguments)
                self.assertEqual(run.returncode, code, (arguments, run.stderr))
                self.assertIn(needle, run.stderr)
            for change, needle in ((lambda c: c.pop("answer"), "has no answer"), (lambda c: c["answer"].update(mass_kg="86952; exec rm"), "mass_kg"),
                                   (lambda c: c["answer"]["law"].update(name="magic"), "magic"), (lambda c: c["answer"]["law"].update(element={"k_i": []}), "k_i"),
                                   (lambda c: c["answer"]["law"].update(element=[1]), "calibration.json"), (lambda c: c["answer"].update(law=None), "law"),
                                   (lambda c: c["answer"]["law"].update(valid_from_m_s=-1), "speeds")):
                content = calibration(identity=self.rim)
                change(content)
                write(folder, content)
                run = rimpact("export", folder, "--csv")
                self.assertEqual(run.returncode, 3, run.stderr)
                self.assertIn(needle, run.stderr)
                self.assertNotIn("law.csv", os.listdir(folder))

    def test_a_pair_holds_for_its_mass(self):
        with tempfile.TemporaryDirectory() as folder:
            content = calibration(identity=self.rim)
            content["answer"]["pair"] = {"law": "no-tension", "k_i_kN_per_m": 450000.0, "e": 0.5, "c_i_kN_s_per_m": 1.0, "mass_kg": 86952.0,
                                         "from_m_s": 0.2, "to_m_s": 0.4, "tolerance": 0.1,
                                         "worst_peak_force_error": 0.08, "worst_rebound_error": 0.05, "parameters": {}, "sentence": "A pair."}
            write(folder, content)
            run = rimpact("export", folder, "--opensees", "--law", "pair", "--mass", "203900")
            self.assertEqual(run.returncode, 2)
            self.assertIn("86952 kg only", run.stderr)
            run = rimpact("export", folder, "--opensees", "--sap2000", "--etabs", "--csv", "--law", "pair", "--mass", "86952", "--scene", "shfps-225")
            self.assertEqual(run.returncode, 0, run.stderr)
            values, ops = self.python(folder), Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            gap = next(call for call in ops.calls if call[1] == "ElasticPPGap")  # it never pulls, as ViscoelasticGap does
            self.assertEqual(gap[5], -0.4)
            self.assertGreaterEqual(gap[3], 1000 * values["k_i"])
            self.assertIn(("uniaxialMaterial", "Elastic", gap[2] + 1, values["k_i"], values["c_i"]), ops.calls)
            self.assertAlmostEqual(values["k_i"], 4.5e8)
            joints = [call[1] for call in ops.calls if call[0] == "node"][-2:]
            self.assertEqual(joints, [106, 107])


if __name__ == "__main__":
    unittest.main()
