"""Hostile text, folders and commands stay comments in what `rimpact export` writes."""
import os
import shutil
import tempfile
import unittest

from exported import Exported

HOSTILE = ["x\nimport os; os.system('touch OWNED')\n", "\\n]; exec touch OWNED; #", "[exec touch OWNED] $env(HOME) \\", '"""\nopen("OWNED", "w")\n"""', "'''\nopen('OWNED', 'w')",
           "Lager Süd – 300 ™ \u2028 exec touch OWNED", "a}\nexec touch OWNED\nproc b {} {", "\r\nexec touch OWNED\x00\x1b[2J", "end\\"]


class Hostile(Exported):
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


if __name__ == "__main__":
    unittest.main()
