"""Files of the working folder and of others must not run programs: meshes, PETSc's options, Python modules."""
import json
import os
import tempfile
import unittest

from command import rimpact


class ForeignFiles(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        self.marker = os.path.join(self.folder, "PWNED")

    def file(self, name, text, mode=0o644):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
        os.chmod(path, mode)
        return path

    def test_check_of_a_mesh_runs_no_script(self):
        for name in ("evil.msh", "evil.geo", "evil.txt", "evil"):
            path = self.file(name, f'SystemCall "touch {self.marker}";\n')
            run = rimpact("check", "impact-window", "--set", f'model.own_mesh.file="{path}"', cwd=self.folder)
            self.assertEqual(run.returncode, 3, run.stderr)
            self.assertFalse(os.path.exists(self.marker), name)

    def test_a_script_is_run_only_where_allowed_and_never_ends_the_run_quietly(self):
        path = self.file("own.geo", "Exit;\n")
        run = rimpact("run", "impact-window", "--allow-script", "--set", f'model.own_mesh.file="{path}"', "-o", "out", cwd=self.folder)
        self.assertEqual(run.returncode, 3)
        self.assertIn("Exit in line 1 leaves the script", run.stderr)

    def test_preferences_of_gmsh_do_not_rule_the_meshes(self):
        plain = rimpact("mesh", "--mesh", "0", "-o", "plain.msh", cwd=self.folder, HOME=self.folder)
        self.assertEqual(plain.returncode, 0, plain.stderr)
        for number, options in enumerate(("Mesh.Algorithm = 8;", "Mesh.ElementOrder = 2;", f'SystemCall "touch {self.marker}";')):
            self.file(".gmsh-options", options)
            self.file(".gmshrc", options)
            run = rimpact("mesh", "--mesh", "0", "-o", f"{number}.msh", cwd=self.folder, HOME=self.folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(self.folder, "plain.msh")) as first, open(os.path.join(self.folder, f"{number}.msh")) as second:
                self.assertEqual(first.read(), second.read(), options)
        self.assertFalse(os.path.exists(self.marker))

    def test_petsc_takes_no_options_from_files_or_the_environment(self):
        script = self.file("evil.sh", f"#!/bin/sh\ntouch {self.marker}\n", 0o755)
        self.file(".petscrc", f"-start_in_debugger {script}\n-debug_terminal {script}\n-log_view\n")
        for environment in ({}, {"PETSC_OPTIONS": "-log_view"}):
            run = rimpact("version", "--json", cwd=self.folder, HOME=self.folder, **environment)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn("PETSc", json.loads(run.stdout))
        self.assertFalse(os.path.exists(self.marker))

    def test_python_files_of_the_working_folder_are_not_run(self):
        evil = f"open({self.marker!r}, 'w'); raise SystemExit(0)\n"
        run = rimpact("reduced", "ricker-0.78g-1.0s", "-o", "run", cwd=self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        for name in ("report.py", "json.py", "numpy/__init__.py", "report/__init__.py", "sitecustomize.py"):
            path = self.file(name, evil)
            for words in (("reduced", "ricker-0.78g-1.0s", "--png", "-o", "run"), ("report", "run")):
                run = rimpact(*words, cwd=self.folder, PYTHONPATH=self.folder)
                self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(os.path.getsize(os.path.join(self.folder, "run", "report.html")) > 10000)
            self.assertFalse(os.path.exists(self.marker), name)
            os.remove(path)


if __name__ == "__main__":
    unittest.main()
