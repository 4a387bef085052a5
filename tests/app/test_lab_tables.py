"""Laboratory files as they come: whatever the spelling of a table, the same law is fitted to it; what cannot be read is said with what there is."""
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

from command import RIMPACT, rimpact

MAPPING = """scene = "impact-window"
set = ["excitation.speed_m_per_s=0.3", "excitation.duration_s=0.08", "reduced.impact_law=elastoplastic"]
file = "{file}"
[columns.time]
column = "t"
unit = "ms"
[columns.displacement_x]
column = "LVDT 1"
unit = "{length}"
[columns.impact_x]
column = "cell"
unit = "{force}"
"""
LENGTHS = {"mm": 1e-3, "in": 0.0254, "cm": 1e-2}
FORCES = {"kN": 1e3, "kgf": 9.80665, "tf": 9806.65, "lbf": 4.4482216152605, "kip": 4448.2216152605}


class LabTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        made = rimpact("reduced", "impact-window", "--set", "excitation.speed_m_per_s=0.3", "--set", "excitation.duration_s=0.08", "--set",
                       "reduced.impact_law=hunt-crossley", "--set", "reduced.output_step_ms=0.2", "-o", "truth", "--quiet", cwd=cls.folder)
        assert made.returncode == 0, made.stderr
        with open(os.path.join(cls.folder, "truth", "response.csv"), encoding="utf-8") as file:
            names = file.readline().strip().split(",")
            rows = [line.strip().split(",") for line in file]
        where = [names.index(name) for name in ("time_s", "ux_m", "Ix_N")]
        cls.rows, last = [], -1.0
        for row in rows:
            values = [float(row[k]) for k in where]
            if values[0] > last:
                cls.rows.append(values)
                last = values[0]
        cls.plain = cls("test_quoted_cells").fitted("plain", cls("test_quoted_cells").table())

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def table(self, separator=",", comma=False, quotes=False, head="", length="mm", force="kN"):
        lines = [separator.join(f'"{name}"' if quotes else name for name in ("t", "LVDT 1", "cell"))]
        for time, travel, push in self.rows:
            cells = [f"{value:.9f}" for value in (1e3 * time, travel / LENGTHS[length], push / FORCES[force])]
            cells = [cell.replace(".", ",") if comma else cell for cell in cells]
            lines.append(separator.join(f'"{cell}"' if quotes else cell for cell in cells))
        return head + "\n".join(lines) + "\n"

    def calibrate(self, name, text, encoding="utf-8", length="mm", force="kN"):
        with open(os.path.join(self.folder, name + ".csv"), "wb") as file:
            file.write(text.encode(encoding) if isinstance(text, str) else text)
        with open(os.path.join(self.folder, name + ".toml"), "w", encoding="utf-8") as file:
            file.write(MAPPING.format(file=name + ".csv", length=length, force=force))
        return rimpact("calibrate", name + ".toml", "--law", "hunt-crossley", "--laws", "none", "-o", name, "--json", cwd=self.folder)

    def fitted(self, name, *rest, **more):
        run = self.calibrate(name, *rest, **more)
        assert run.returncode in (0, 5), run.stderr
        return json.loads(run.stdout)

    def same_as_plain(self, name, *rest, **more):
        found = self.fitted(name, *rest, **more)
        for parameter, entry in self.plain["parameters"].items():
            self.assertAlmostEqual(found["parameters"][parameter]["value"], entry["value"], delta=2e-3 * abs(entry["value"]), msg=f"{name}: {parameter}")
        return found

    def test_decimal_commas_are_read_and_said(self):
        found = self.same_as_plain("commas", self.table(";", comma=True))
        self.assertTrue(any("decimal comma" in note for note in found["notes"]), found["notes"])
        self.assertFalse(any("decimal comma" in note for note in self.plain["notes"]))

    def test_decimal_commas_between_tabs_and_in_quotes(self):
        self.same_as_plain("tabs", self.table("\t", comma=True))
        self.same_as_plain("quoted", self.table(",", comma=True, quotes=True))

    def test_quoted_cells(self):
        self.same_as_plain("quotes", self.table(";", quotes=True))

    def test_the_line_that_names_the_separator(self):
        self.same_as_plain("stated", self.table(";", head="sep=;\r\n"))

    def test_utf_16_of_both_orders(self):
        self.same_as_plain("little", self.table("\t"), encoding="utf-16")
        self.same_as_plain("big", b"\xfe\xff" + self.table("\t").encode("utf-16-be"))

    def test_units_of_the_workshop(self):
        for length, force in (("in", "kip"), ("cm", "tf"), ("mm", "kgf"), ("in", "lbf")):
            self.same_as_plain(f"{length}-{force}", self.table(length=length, force=force), length=length, force=force)

    def refused(self, sentence, text, code=3, **more):
        run = self.calibrate("refused", text, **more)
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertIn(sentence, run.stderr)

    def test_thousands_are_refused(self):
        lines = self.table(";", comma=True).splitlines()
        lines[5] = lines[5].replace(",", ".")
        self.refused("refused.csv:6: ", "\n".join(lines))
        self.refused("stands for thousands", "\n".join(lines))

    def test_what_there_is_is_listed(self):
        self.refused('names "t", "LVDT 2", "cell"', self.table().replace("LVDT 1", "LVDT 2"))
        self.refused("N, kN, MN, kgf, tf, lbf, kip", self.table(), code=2, force="ton")

    def test_a_workbook_is_named_with_what_to_do(self):
        with zipfile.ZipFile(os.path.join(self.folder, "test.xlsx"), "w") as book:
            book.writestr("xl/workbook.xml", "<workbook/>")
        with open(os.path.join(self.folder, "book.toml"), "w", encoding="utf-8") as file:
            file.write(MAPPING.format(file="test.xlsx", length="mm", force="kN"))
        run = rimpact("calibrate", "book.toml", "--laws", "none", "-o", "book", cwd=self.folder)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("test.xlsx: is an Excel workbook: save its sheet as CSV; a table is read from text", run.stderr)

    def test_a_broken_utf_16_is_named(self):
        self.refused("ends within a character", b"\xff\xfea")


class Campaign(unittest.TestCase):
    """The laboratory example's two tests in one file, its force 0.4 ms late: k_i 900,000 kN/m, F_y 650 kN, h 0.15, a 0.40."""
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = cls.temporary.name
        package = pathlib.Path(RIMPACT).resolve().parents[1] / "python"
        if not list(package.glob("rimpact/_core*.so")):
            raise unittest.SkipTest(f"the Python package, which makes the example's table, is not built in {package}")
        example = pathlib.Path(__file__).resolve().parents[2] / "examples" / "laboratory-curve"
        for name in ("campaign.toml", "make_table.py"):
            shutil.copy(example / name, cls.folder)
        subprocess.run([sys.executable, "make_table.py"], cwd=cls.folder, check=True, env={**os.environ, "PYTHONPATH": str(package)})

    def test_both_are_fitted_and_the_lag_is_told(self):
        done = rimpact("calibrate", "campaign.toml", "--law", "elastoplastic", "--laws", "none", "-o", "fit", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, "fit/calibration.json"), encoding="utf-8") as file:
            made = json.load(file)
        self.assertEqual(sorted(made["fit"]), ["campaign.toml#7", "campaign.toml#8"])
        for name, truth in (("k_i", 9e5), ("yield_force", 650), ("hardening", 0.15), ("unloading_gain", 0.40)):
            self.assertAlmostEqual(made["parameters"][name]["value"] / truth, 1, delta=0.015, msg=name)
        lags = re.findall(r"#(\d): the force comes ([\d.]+) \+- ([\d.]+) ms after", done.stdout + done.stderr)
        self.assertEqual({name for name, _, _ in lags}, {"7", "8"})
        for _, lag, unsure in lags:
            self.assertAlmostEqual(float(lag), 0.4, delta=3 * float(unsure))
            self.assertLess(float(unsure), 0.05)

    def test_without_that_the_rim_comes_out_soft(self):
        late = pathlib.Path(self.folder, "campaign.toml").read_text(encoding="utf-8").replace("estimate_lag = true", "estimate_lag = false")
        pathlib.Path(self.folder, "late.toml").write_text(late, encoding="utf-8")
        done = rimpact("calibrate", "late.toml", "--law", "elastoplastic", "--laws", "none", "-o", "soft", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        made = json.loads(done.stdout)
        self.assertLess(made["parameters"]["k_i"]["value"], 0.9 * 9e5)
        self.assertTrue(any("the motion that it causes" in doubt for doubt in made["answer"]["doubts"]))

    def test_one_is_compared_and_reported_by_its_name(self):
        done = rimpact("compare", "campaign.toml#7", "campaign.toml#8", "--anyway", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = rimpact("compare", "campaign.toml", "campaign.toml#8", cwd=self.folder)
        self.assertEqual(said.returncode, 2)
        self.assertIn("holds 2 tests; name one: campaign.toml#7", said.stderr)
        done = rimpact("report", "campaign.toml#7", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Measured curve campaign-7", pathlib.Path(self.folder, "campaign-7.html").read_text(encoding="utf-8"))


class Moved(unittest.TestCase):
    def test_a_calibration_goes_elsewhere_alone(self):
        """Of a bearing whose dish stands in a file: all that it was made of is gone, and it is flown, exported and reported as before."""
        with tempfile.TemporaryDirectory() as folder:
            lab, away = pathlib.Path(folder, "lab"), pathlib.Path(folder, "away")
            lab.mkdir(), away.mkdir()
            self.assertEqual(rimpact("new", "case", cwd=lab).returncode, 0)
            bearing = (lab / "case/bearing.toml").read_text(encoding="utf-8")
            ellipse = bearing[bearing.index("[surface]"):bearing.index("[slider]")]
            table = '[surface]\nkind = "table"\nfile = "dish.csv"\nplanar_radius_mm = 520.0\n\n'
            (lab / "case/bearing.toml").write_text(bearing.replace(ellipse, table), encoding="utf-8")
            rows = "\n".join(f"{r},{140.625 * (1 - math.sqrt(1 - (r / 562.5) ** 2)):.9f}" for r in range(0, 551, 10))
            (lab / "case/dish.csv").write_text("radius_mm,height_mm\n" + rows + "\n", encoding="utf-8")
            for speed in ("0.1", "0.2", "0.4"):
                done = rimpact("reduced", "case/scene.toml", "--set", "excitation.kind=window", "--set", f"excitation.speed_m_per_s={speed}", "-o", f"runs/{speed}", cwd=lab)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(rimpact("calibrate", "runs/0.1", "runs/0.2", "runs/0.4", "--laws", "none", "-o", "fit", cwd=lab).returncode, 0)
            peaks = []
            for place in (lab, away):
                if place == away:
                    shutil.move(lab / "fit", away / "fit")
                    shutil.rmtree(lab)
                flown = rimpact("reduced", "fit/fitted-scene.toml", "--set", "excitation.speed_m_per_s=0.3", "-o", "flown", "--json", cwd=place)
                self.assertEqual(flown.returncode, 0, flown.stderr)
                peaks.append(json.loads(flown.stdout)["peak_impact_force_N"])
                exported = rimpact("export", "fit", "--opensees", "--csv", "-o", "handed", cwd=place)
                self.assertEqual(exported.returncode, 0, exported.stderr)
                peaks.append((place / "handed/law.csv").read_text(encoding="utf-8"))
                self.assertEqual(rimpact("report", "fit", cwd=place).returncode, 0)
                other = rimpact("reduced", "impact-window", "--calibration", "fit", "-o", "other", cwd=place)
                self.assertEqual(other.returncode, 0, other.stderr)
            self.assertEqual(peaks[:2], peaks[2:])


if __name__ == "__main__":
    unittest.main()
