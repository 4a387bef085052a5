"""One version number for everything, and a sentence where the compiled module was not built."""
import os
import pathlib
import re
import subprocess
import sys
import tomllib
import unittest

import rimpact

COMMAND, SOURCE = os.environ["RIMPACT"], pathlib.Path(os.environ["RIMPACT_SOURCE"])


def found(pattern, file):
    return re.search(pattern, (SOURCE / file).read_text(encoding="utf-8"), re.MULTILINE)[1]


class Importing(unittest.TestCase):
    def test_the_version_stands_in_cmakelists_and_the_others_follow(self):
        version = found(r"^project\(rimpact VERSION (\S+) ", "CMakeLists.txt")
        self.assertEqual(rimpact.__version__, version)
        self.assertEqual(found(r"^version: (\S+)$", "CITATION.cff"), version)
        self.assertEqual(found(r"^## (\d\S+) \(\d{4}-\d\d-\d\d\)$", "CHANGELOG.md"), version)
        said = subprocess.run([COMMAND, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said, f"rimpact {version}\n")

    def test_pip_takes_the_version_from_there(self):
        project = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))
        self.assertNotIn("version", project["project"])
        taken = project["tool"]["scikit-build"]["metadata"]["version"]
        self.assertEqual(re.search(taken["regex"], (SOURCE / taken["input"]).read_text(encoding="utf-8"))["value"], rimpact.__version__)

    def test_without_the_compiled_module_it_says_what_to_build(self):
        done = subprocess.run([sys.executable, "-c", "import rimpact"], capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
        self.assertEqual(done.returncode, 1)
        last = done.stderr.splitlines()[-1]
        for words in ("ImportError: ", str(SOURCE / "python" / "rimpact"), "pip install .", "PYTHONPATH=build/release/python"):
            self.assertIn(words, last)
        self.assertNotIn("circular", done.stderr)

    def test_numpy_2_is_refused_where_its_arrays_would_be_wrong(self):
        done = subprocess.run([sys.executable, "-c", "import numpy; numpy.__version__ = '2.1.0'; import rimpact.compiled"], capture_output=True, text=True,
                              check=False)
        if rimpact._core.knows_numpy_2:
            self.assertNotIn("pybind11", done.stderr)
        else:
            self.assertIn("compiled with a pybind11 before 2.12, whose arrays are wrong under NumPy 2.1.0", done.stderr)


if __name__ == "__main__":
    unittest.main()
