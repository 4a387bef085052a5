"""check_changes.py finds what no change names."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import check_changes  # noqa: E402

KEYS = "| key | unit |\n|---|---|\n| `load.mass_kg` | kg |\n| `load.factor` |  |\n"
VERBS = "## run\n\n  -o,--output TEXT\n  --mesh INT  of `--rung rim`\n"


class Changes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        for folder in ("docs/reference", "docs/changes"):
            (self.root / folder).mkdir(parents=True)
        self.write("docs/reference/keys.md", KEYS)
        self.write("docs/reference/verbs.md", VERBS)
        check_changes.main(str(self.root), "--release")

    def write(self, name, text):
        (self.root / name).write_text(text, encoding="utf-8")

    def test_nothing_changed(self):
        self.assertEqual(check_changes.interface(self.root), {"load.mass_kg", "load.factor", "run --output", "run --mesh"})
        self.assertEqual(check_changes.faults(self.root), [])

    def test_a_new_name_is_asked_for_until_a_file_names_it(self):
        self.write("docs/reference/keys.md", KEYS + "| `load.tilt_deg` | deg |\n")
        self.write("docs/reference/verbs.md", VERBS + "  --ranks INT\n")
        self.assertEqual([said.split(" is new")[0] for said in check_changes.faults(self.root)], ["load.tilt_deg", "run --ranks"])
        self.write("docs/changes/tilt.added.md", "A load stands askew by `tilt_deg`. `--ranks-of` is another word.\n")
        self.assertEqual([said.split(" is new")[0] for said in check_changes.faults(self.root)], ["run --ranks"])

    def test_a_gone_name_breaks(self):
        self.write("docs/reference/keys.md", KEYS.replace("| `load.factor` |  |\n", ""))
        self.write("docs/changes/factor.fixed.md", "`load.factor` is gone.\n")
        self.assertEqual(len(check_changes.faults(self.root)), 1)
        self.write("docs/changes/factor.breaking.md", "`load.factor` is gone: write the load.\n")
        self.assertEqual(check_changes.faults(self.root), [])

    def test_a_file_of_no_kind_is_refused(self):
        self.write("docs/changes/note.md", "Something.\n")
        self.assertIn("NAME.KIND.md", check_changes.faults(self.root)[0])


if __name__ == "__main__":
    unittest.main()
