"""The Debian package: built, unpacked into a root of its own, and walked from there; nothing of the source tree is asked for.

Environment: RIMPACT_BUILD, the build folder; RIMPACT_SOURCE, the source tree."""
import glob
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest

BUILD, SOURCE = os.environ["RIMPACT_BUILD"], os.environ["RIMPACT_SOURCE"]


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, check=False, **more)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="rimpact-package-")
        made = run("cpack", "-G", "DEB", "--config", os.path.join(BUILD, "CPackConfig.cmake"), "-B", cls.folder)
        found = glob.glob(os.path.join(cls.folder, "*.deb"))
        assert made.returncode == 0 and len(found) == 1, made.stdout + made.stderr
        cls.deb, cls.root = found[0], os.path.join(cls.folder, "moved", "elsewhere")
        os.makedirs(cls.root)
        assert run("dpkg", "-x", cls.deb, cls.root).returncode == 0
        cls.program = os.path.join(cls.root, "usr", "bin", "rimpact")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def says(self, *words, code=0):
        done = run(self.program, *words, cwd=self.folder)
        self.assertEqual(done.returncode, code, f"rimpact {' '.join(words)}\n{done.stderr}")
        return done.stdout

    def field(self, name):
        return run("dpkg-deb", "--field", self.deb, name).stdout.strip()

    def test_names_its_version_and_what_it_depends_on(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
            version = file.read().split("VERSION", 2)[2].split()[0]
        self.assertEqual(self.field("Version"), version)
        depends = self.field("Depends")
        for package in ("libc6", "libdeal.ii", "libpetsc-real", "libgmsh", "libfmt", "python3-h5py", "libopenblas0-pthread"):
            self.assertIn(package, depends)

    def test_no_path_of_the_source_tree_is_compiled_in(self):
        for name in ("rimpact", "rimpact-fe", "rimpact-gmsh"):
            with open(os.path.join(self.root, "usr", "bin", name), "rb") as file:
                paths = re.findall(re.escape(os.fsencode(SOURCE)) + rb"/[\w./-]*", file.read())
            self.assertEqual(paths, [], name)

    def test_lists_checks_runs_and_reports(self):
        self.assertIn("shfps-225", self.says("list", "bearings"))
        self.assertIn("L_c", self.says("check", "impact-window"))
        self.says("reduced", "ricker-0.78g-1.0s", "-o", "run", "--set", "excitation.scale=1.05")
        with open(os.path.join(self.folder, "run", "summary.json"), encoding="utf-8") as file:
            self.assertGreater(json.load(file)["n_impacts"], 0)
        self.says("report", "run")
        with open(os.path.join(self.folder, "run", "report.html"), encoding="utf-8") as file:
            self.assertIn("</html>", file.read())

    def test_the_finite_element_side_is_there_and_plans_a_run(self):
        self.assertIn("PETSc", self.says("version"))
        self.says("run", "impact-window", "--dry-run")
        self.says("mesh", "shfps-225", "-o", "bearing.msh")
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "bearing.msh")), 10000)

    def test_stored_studies_and_documents_go_along(self):
        share = os.path.join(self.root, "usr", "share")
        here = sorted(map(os.path.basename, glob.glob(os.path.join(SOURCE, "data", "studies", "*.json"))))
        self.assertEqual(sorted(os.listdir(os.path.join(share, "rimpact", "data", "studies"))), here)
        self.assertTrue(os.path.isfile(os.path.join(share, "doc", "rimpact", "docs", "guide", "README.md")))
        self.assertNotIn("__pycache__", run("dpkg-deb", "--contents", self.deb).stdout)

    def test_python_finds_its_package_and_the_program_beside_it(self):
        packages = os.path.join(self.root, "usr", "lib", "python3", "dist-packages")
        words = ("import rimpact; run = rimpact.run_reduced('impact-window', 'py-run'); print(len(run.impacts));"
                 "print(rimpact.load('py-run').folder); from rimpact import program; print(program.path())")
        done = run("/usr/bin/python3", "-c", words, cwd=self.folder, env={"PYTHONPATH": packages, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1"})
        self.assertEqual(done.stdout.split(), ["1", "py-run", self.program], done.stderr)

    def test_manual_completion_and_examples_go_along(self):
        share = os.path.join(self.root, "usr", "share")
        for path in ("bash-completion/completions/rimpact", "zsh/vendor-completions/_rimpact", "fish/vendor_completions.d/rimpact.fish",
                     "doc/rimpact/examples/README.md", "doc/rimpact/docs/reference/keys.md", "man/man1/rimpact.1", "man/man1/rimpact-reduced.1",
                     "man/man1/rimpact-run.1"):
            found = glob.glob(os.path.join(share, path) + "*")
            self.assertTrue(found and os.path.getsize(found[0]) > 500, path)
        if shutil.which("man"):
            page = run("man", "-l", os.path.join(share, "man", "man1", "rimpact-reduced.1"), env={**os.environ, "MANPAGER": "cat", "MANWIDTH": "100"})
            self.assertIn("--sweep", page.stdout)

    def test_an_installation_without_its_data_says_so(self):
        shutil.copytree(os.path.join(self.root, "usr", "bin"), os.path.join(self.folder, "alone", "bin"))
        self.says("reduced", "impact-window", "-o", "alone-run")
        done = run(os.path.join(self.folder, "alone", "bin", "rimpact"), "report", "alone-run", cwd=self.folder)
        self.assertEqual(done.returncode, 6)
        self.assertIn(os.path.join("alone", "share", "rimpact"), done.stderr)


if __name__ == "__main__":
    unittest.main()
