"""What `rimpact export` writes is read back: Python compiled and run on a recorder, Tcl run on stubs, tables parsed; hostile text stays comment."""
import csv
import json
import math
import os
import py_compile
import re
import shutil
import subprocess
import tempfile
import unittest

from command import rimpact

ELEMENT = {"lateral_capacity_m": 0.4, "reference_speed_m_per_s": 0.5, "k_i": {"value": 1085500, "unit": "kN/m"}, "yield_force": {"value": 455.24, "unit": "kN"},
           "hardening": {"value": 0.38454, "unit": "-"}, "hardening_exponent": {"value": 0.39266, "unit": "-"},
           "unloading_gain": {"value": 0.2928, "unit": "-"}, "unloading_exponent": {"value": 0.54265, "unit": "-"}}
HOSTILE = ["x\nimport os; os.system('touch OWNED')\n", "\\n]; exec touch OWNED; #", "[exec touch OWNED] $env(HOME) \\", '"""\nopen("OWNED", "w")\n"""', "'''\nopen('OWNED', 'w')",
           "Lager Süd – 300 ™ \u2028 exec touch OWNED", "a}\nexec touch OWNED\nproc b {} {", "\r\nexec touch OWNED\x00\x1b[2J", "end\\"]


class Recorder:
    """Takes the place of openseespy.opensees: keeps what it is asked for."""

    def __init__(self):
        self.calls = []

    def nodeCoord(self, node):
        self.calls.append(("nodeCoord", node))
        return [1.0, 2.0, 3.0]

    def __getattr__(self, name):
        return lambda *arguments: self.calls.append((name, *arguments))


def calibration(text="plain", identity="0" * 16, **law):
    """A calibration.json; `text` stands wherever text may stand."""
    parameters = {"k_i": {"value": 1085500, "unit": text, "interval_95": [1.06e6, 1.1e6], "identifiable": True}, text: {"value": 1, "unit": text}}
    return {"answer": {"bearing": text, "rim_identity": identity, "rung": text, "mesh": [text, 1], "mass_kg": 86952.0, "vertical_kN": 853.0, "gravity_m_per_s2": 9.81, "source": text,
                       "law": {"name": "elastoplastic", "chosen_by": text, "remark": text, "belongs_to": "rim", "parameters": parameters, "element": ELEMENT, "fitted_from_m_s": 0.1,
                               "fitted_to_m_s": 0.7, "valid_from_m_s": 0.1, "valid_to_m_s": 0.7, "tolerance": 0.05,
                               "worst_left_out": {"peak_force": 0.02, "rebound": 0.04, "inside_valid_range": True}, "sentence": text, **law},
                       "pair": None, "no_pair": text, "strain": {"sentence": text}, "mesh_error": {"sentence": text}, "assumptions": [{"key": text, "value": text}],
                       "doubts": [text, text], "validity": text}}


def write(folder, content):
    with open(os.path.join(folder, "calibration.json"), "w") as file:
        json.dump(content, file)


def identity():
    """Of the built-in bearing, from the refusal that names both."""
    with tempfile.TemporaryDirectory() as folder:
        write(folder, calibration())
        run = rimpact("export", folder, "--csv", "--scene", "shfps-225")
        assert run.returncode == 2, run.stderr
        return re.search(r"its rim is ([0-9a-f]{16})", run.stderr).group(1)


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rim = identity()

    def exported(self, folder, *arguments, text="plain", **law):
        write(folder, calibration(text, self.rim, **law))
        run = rimpact("export", folder, "--scene", "shfps-225", *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def python(self, folder):
        path = os.path.join(folder, "impact.py")
        py_compile.compile(path, doraise=True, cfile=os.path.join(folder, "compiled"))
        values = {}
        with open(path) as file:
            exec(compile(file.read(), path, "exec"), values)
        return values

    def tcl(self, folder, script):
        """Lines that the stubs of OpenSees' commands print."""
        if not shutil.which("tclsh"):
            self.skipTest("tclsh is not here: the Tcl file was not run")
        stubs = "".join(f"proc {name} {{args}} {{puts \"{name} $args\"}}\n" for name in ("uniaxialMaterial", "element", "frictionModel", "node", "equalDOF"))
        run = subprocess.run(["tclsh"], input=stubs + "proc nodeCoord {n} {return {1.0 2.0 3.0}}\n" + f"source {folder}/impact.tcl\n{script}\n", capture_output=True, text=True, cwd=folder)
        self.assertEqual(run.stderr, "")
        return run.stdout.splitlines()

    def test_python_makes_the_calls_of_the_bearing(self):
        with tempfile.TemporaryDirectory() as folder:
            self.exported(folder, "--opensees")
            values, ops = self.python(folder), Recorder()
            values["rim_springs"](ops, 7, 100, 1, 2)
            gaps = [call for call in ops.calls if call[1] == "ElasticPPGap"]
            self.assertEqual([call[2] for call in gaps], [8, 9, 10, 11])
            for call, E, Fy, eta in zip(gaps, values["rim_stiffness"], values["rim_yield_force"], values["rim_hardening"]):
                self.assertEqual(call[3:], (E, -Fy, -0.4, eta, "damage"))
            self.assertEqual(ops.calls[4], ("uniaxialMaterial", "Parallel", 7, 8, 9, 10, 11))
            self.assertEqual([call[2] for call in ops.calls[5:]], [100, 101])
            self.assertEqual([call[10] for call in ops.calls[5:]], [-1.0, 1.0])  # local x: shortened by motion along +x, -x
            ops = Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            self.assertEqual(ops.calls[1], ("node", 99, 1.0, 2.0, 2.999))
            elements = [call for call in ops.calls if call[0] == "element"]
            self.assertEqual([call[1] for call in elements], ["flatSliderBearing", "corotTruss", "corotTruss"])
            self.assertEqual(len({call[2] for call in elements}), 3)
            tags = [call[2] for call in ops.calls if call[0] == "uniaxialMaterial"]
            self.assertEqual(len(tags), len(set(tags)))
            # the round rim closes where the truss has the length of the capacity, and is as stiff as the springs along x
            gap = next(call for call in ops.calls if call[1] == "ElasticPPGap")
            self.assertAlmostEqual((1 + gap[5]) * 0.001, math.hypot(0.4, 0.001))
            self.assertAlmostEqual(gap[3] / 0.001 / values["rim_stiffness"][0], 1)
            # and the dish's truss pulls W h'(r) horizontally: 853 kN, ellipse R0 = 2.25, a = 0.5625
            table = next(call for call in ops.calls if call[1] == "ElasticMultiLinear")
            half = table.index("-stress")
            strain, force = table[4:half], table[half + 1:]
            for e, f in list(zip(strain, force))[2:]:
                r = math.sqrt(((1 + e) * 0.001) ** 2 - 1e-6)
                if r < 0.45:
                    self.assertAlmostEqual(f * r / ((1 + e) * 0.001) / (853e3 * r / 2.25 / math.sqrt(1 - (r / 0.5625) ** 2)), 1, places=6)

    def test_tcl_and_python_make_the_same_bearing(self):
        with tempfile.TemporaryDirectory() as folder:
            self.exported(folder, "--opensees")
            values, ops = self.python(folder), Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            values["rim_springs"](ops, 70, 100, 1, 2)
            lines = self.tcl(folder, "rimpact_bearing 1000 1 2 99\nrim_springs 70 100 1 2")
            expected = [call for call in ops.calls if call[0] != "nodeCoord"]
            self.assertEqual(len(lines), len(expected))
            for line, call in zip(lines, expected):
                words = line.split()
                self.assertEqual(len(words), len(call), line)
                for word, value in zip(words, call):
                    if isinstance(value, (int, float)):
                        self.assertAlmostEqual(float(word), value, delta=1e-6 * abs(value) + 1e-12)
                    else:
                        self.assertEqual(word, value)

    def test_hostile_text_stays_comment(self):
        for text in HOSTILE:
            with self.subTest(text=text), tempfile.TemporaryDirectory() as folder:
                here = os.getcwd()
                self.exported(folder, "--opensees", "--sap2000", "--etabs", "--csv", text=text)
                os.chdir(folder)
                try:
                    self.python(folder)
                    if shutil.which("tclsh"):
                        self.tcl(folder, "rimpact_bearing 1000 1 2 99")
                finally:
                    os.chdir(here)
                self.assertNotIn("OWNED", os.listdir(folder))
                for name, mark in (("impact.tcl", "#"), ("impact.py", "#"), ("bearing.s2k", "$"), ("bearing.e2k", "$"), ("rim-link.csv", "#"), ("law.csv", "#")):
                    with open(os.path.join(folder, name), "rb") as file:
                        content = file.read()
                    self.assertTrue(all(byte == 10 or 32 <= byte < 127 for byte in content), name)
                    for line in content.decode().splitlines():
                        if "OWNED" in line:
                            self.assertTrue(line.startswith(mark + " "), (name, line))

    def test_hostile_folder_and_command(self):
        with tempfile.TemporaryDirectory() as base:
            folder = os.path.join(base, "a\nexec touch OWNED\n[exec touch OWNED] \"\"\"")
            os.mkdir(folder)
            self.exported(folder, "--opensees")
            self.python(folder)

    def test_without_the_dish_only_the_rim(self):
        with tempfile.TemporaryDirectory() as folder:
            write(folder, calibration("acme"))
            run = rimpact("export", folder, "--opensees", "--sap2000")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("--scene", run.stderr)
            self.assertNotIn("rimpact_bearing", self.python(folder))
            with open(os.path.join(folder, "bearing.s2k")) as file:
                self.assertNotIn("Link=DISH", file.read())

    def test_in_opensees_where_it_is_installed(self):
        try:
            import openseespy.opensees as ops
        except ImportError:
            self.skipTest("openseespy is not here: the exported springs were flown by rimpact's own integrator only")
        with tempfile.TemporaryDirectory() as folder:
            checks = json.loads(self.exported(folder, "--opensees", "--json").stdout)["self_checks"][0]
            values = self.python(folder)
            for row in checks["rows"]:
                expected, speed = row["spring"], row["speed_m_s"]
                step = expected["contact_time_ms"] / 1e3 / 2000
                ops.wipe()
                ops.model("basic", "-ndm", 3, "-ndf", 6)
                ops.node(1, 0.0, 0.0, 0.0), ops.node(2, 0.0, 0.0, 0.0)
                ops.fix(1, 1, 1, 1, 1, 1, 1), ops.fix(2, 0, 1, 1, 1, 1, 1)
                ops.mass(2, *[values["m1"]] * 6)
                values["rim_springs"](ops, 7, 100, 1, 2)
                ops.setNodeDisp(2, 1, values["lateral_capacity"] - speed * step, "-commit"), ops.setNodeVel(2, 1, speed, "-commit")
                ops.constraints("Plain"), ops.numberer("Plain"), ops.system("BandGeneral"), ops.test("NormUnbalance", 1e-3, 50)
                ops.algorithm("Newton"), ops.integrator("Newmark", 0.5, 0.25), ops.analysis("Transient")
                force = depth = 0.0
                for _ in range(2100):
                    self.assertEqual(ops.analyze(1, step), 0)
                    force = max(force, -values["m1"] * ops.nodeAccel(2, 1))
                    depth = max(depth, ops.nodeDisp(2, 1) - values["lateral_capacity"])
                self.assertAlmostEqual(force / 1e3 / expected["peak_force_kN"], 1, delta=0.01)
                self.assertAlmostEqual(1e3 * depth / expected["penetration_mm"], 1, delta=0.01)
                self.assertAlmostEqual(-ops.nodeVel(2, 1) / speed, expected["rebound"], delta=0.01)

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
            points = sorted((-float(row["displacement_m"]), -float(row["force_kN"]) * 1e3) for row in csv.DictReader(lines) if row["link"] == "RIM" and float(row["displacement_m"]) <= 0)
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

    def test_beyond_ten_per_cent_is_said(self):
        # a law from 0.02 to 3 m/s: four springs cannot follow two decades
        with tempfile.TemporaryDirectory() as folder:
            run = self.exported(folder, "--opensees", "--quiet", valid_from_m_s=0.02, valid_to_m_s=3.0)
            self.assertIn("Self-check of the four ElasticPPGap", run.stderr)
            with open(os.path.join(folder, "impact.tcl")) as file:
                self.assertIn("DOUBT: Self-check", file.read())

    def test_refusals(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(rimpact("export", folder, "--csv").returncode, 3)  # no calibration.json
            write(folder, calibration(identity=self.rim))
            for code, needle, arguments in ((2, "--sap2000", []), (2, "--mass", ["--csv", "--mass", "-1"]), (2, "not among the laws", ["--csv", "--law", "signed"]),
                                            (2, "no constant pair", ["--csv", "--law", "pair"]), (2, "another bearing", ["--csv", "--scene", "fps-225"])):
                run = rimpact("export", folder, *arguments)
                self.assertEqual(run.returncode, code, (arguments, run.stderr))
                self.assertIn(needle, run.stderr)
            for change, needle in ((lambda c: c.pop("answer"), "no answer"), (lambda c: c["answer"].update(mass_kg="86952; exec rm"), "mass_kg"),
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
            content["answer"]["pair"] = {"law": "no-tension", "k_i_kN_per_m": 450000.0, "e": 0.5, "c_i_kN_s_per_m": 1.0, "mass_kg": 86952.0, "from_m_s": 0.2, "to_m_s": 0.4, "tolerance": 0.1,
                                         "worst_peak_force_error": 0.08, "worst_rebound_error": 0.05, "parameters": {}, "sentence": "A pair."}
            write(folder, content)
            run = rimpact("export", folder, "--opensees", "--law", "pair", "--mass", "203900")
            self.assertEqual(run.returncode, 2)
            self.assertIn("86952 kg only", run.stderr)
            run = rimpact("export", folder, "--opensees", "--sap2000", "--etabs", "--csv", "--law", "pair", "--mass", "86952", "--scene", "shfps-225")
            self.assertEqual(run.returncode, 0, run.stderr)
            values, ops = self.python(folder), Recorder()
            values["rimpact_bearing"](ops, 1000, 1, 2, 99)
            gap = next(call for call in ops.calls if call[1] == "ViscoelasticGap")
            self.assertEqual(gap[3:], (values["k_i"], values["c_i"], -0.4))
            self.assertAlmostEqual(values["k_i"], 4.5e8)


if __name__ == "__main__":
    unittest.main()
