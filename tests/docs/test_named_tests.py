"""Every test that docs/verification.md names exists: `Suite.Name` of C++, or `test_file.py: test_method`."""
import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["RIMPACT_SOURCE"])
COMPILED = re.compile(r"TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)")
NAMED = re.compile(r"`([A-Z]\w+)\.([A-Z]\w+)`")
METHOD = re.compile(r"`(test_\w+\.py): (test_\w+)`")


class NamedTests(unittest.TestCase):
    def setUp(self):
        self.page = (SOURCE / "docs/verification.md").read_text(encoding="utf-8")

    def test_every_compiled_test_exists(self):
        known = {match for path in SOURCE.glob("tests/**/*.cc") for match in COMPILED.findall(path.read_text(encoding="utf-8"))}
        named = NAMED.findall(self.page)
        self.assertGreater(len(named), 20)
        self.assertEqual([f"{suite}.{name}" for suite, name in named if (suite, name) not in known], [])

    def test_every_method_exists(self):
        named = METHOD.findall(self.page)
        self.assertGreater(len(named), 8)
        for file, method in named:
            texts = [path.read_text(encoding="utf-8") for path in SOURCE.glob(f"tests/**/{file}")]
            self.assertTrue(any(f"def {method}(" in text for text in texts), f"{file}: {method}")


if __name__ == "__main__":
    unittest.main()
