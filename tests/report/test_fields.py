"""Fields in the report: names with units, and the script that shows them in ParaView."""
import ast
import os
import shutil
import subprocess
import unittest

import synthetic
import synthetic_mesh
from support import InFolder

from report import paraview, vtu
from report.build import build
from report.field_catalogue import info_of


class Fields(InFolder):
    def run_folder(self, **options):
        synthetic.run(self.path("run"), "run", 'kind = "window"\nspeed_m_per_s = 0.5', lambda t: 0.0, synthetic.Rim(4.5e8, 0.7), "rim", 0.5)
        os.makedirs(self.path("run", "fields"))
        synthetic_mesh.write_vtu(self.path("run", "fields", "rim_000.vtu"), **options)
        self.write("run/fields.pvd", '<VTKFile type="Collection"><Collection><DataSet timestep="0.01" file="fields/rim_000.vtu"/></Collection></VTKFile>')
        return self.path("run")

    def test_units_are_of_the_catalogue_or_the_name(self):
        self.assertEqual([info_of(name).unit for name in ("displacement", "von_mises_MPa", "stress_xx_MPa", "gap_mm", "depth_m", "equivalent_plastic_strain", "part")],
                         ["m", "MPa", "MPa", "mm", "m", "–", "–"])

    def test_the_report_lists_them(self):
        path, problems = build(self.run_folder(stress=True, curved=True, cell_type=72))
        self.assertEqual(problems, [])
        with open(path, encoding="utf-8") as file:
            page = file.read()
        for said in ("<code>von_mises_MPa</code>", "<code>displacement</code>", "cells of 27 nodes", "time 0.01 s", paraview.NAME):
            self.assertIn(said, page)

    def test_the_script_is_python_and_knows_the_half(self):
        folder = self.run_folder(stress=True)
        script = paraview.write(folder, vtu.read(self.path("run", "fields", "rim_000.vtu")))
        with open(script, encoding="utf-8") as file:
            text = file.read()
        ast.parse(text)
        self.assertIn('FIELD, TITLE, HALF = "von_mises_MPa", "von Mises stress (MPa)", True', text)

    def test_without_stress_there_is_strain_and_without_an_index_nothing(self):
        folder = self.run_folder()
        grid = vtu.read(self.path("run", "fields", "rim_000.vtu"))
        with open(paraview.write(folder, grid), encoding="utf-8") as file:
            self.assertIn('"equivalent_plastic_strain"', file.read())
        os.remove(self.path("run", "fields.pvd"))
        self.assertIsNone(paraview.write(folder, grid))

    @unittest.skipUnless(shutil.which("pvpython") and os.environ.get("DISPLAY"), "ParaView is not installed, or there is no screen")
    def test_paraview_draws_it(self):
        script = paraview.write(self.run_folder(stress=True), vtu.read(self.path("run", "fields", "rim_000.vtu")))
        done = subprocess.run(["pvpython", script, self.path("a.png")], capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, 0, done.stderr[-400:])
        self.assertGreater(os.path.getsize(self.path("a.png")), 5000)


if __name__ == "__main__":
    unittest.main()
