"""Laboratory files as they come: whatever the spelling of a table, the same law is fitted to it; what cannot be read is said with what there is."""
import json
import os
import tempfile
import unittest
import zipfile

from command import rimpact

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


if __name__ == "__main__":
    unittest.main()
