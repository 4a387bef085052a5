"""Numbers of the thesis's entries, made anew, beside those kept with the program."""
import json
import os
import tempfile
import unittest

from command import rimpact

RECORDS = os.environ.get("RIMPACT_RECORDS", os.path.join(os.path.dirname(__file__), "../../../shared/records"))


class Numbers(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def made(self, what, records=None):
        run = rimpact("thesis", what, "--cheap", "--json", "--quiet", "-o", self.folder, "--records", records or self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def holds(self, what, records=None):
        """Every number of ours is found, met or with a cause, and the kept one within 1 % where one is kept, or within what the
        default step tolerance leaves open: residuals of plates that stick and slip (`resolved`, against steps a thousand times finer)."""
        kept = {entry["id"]: entry for entry in json.loads(rimpact("thesis", "list", "--json", "-o", "/nonexistent").stdout)["entries"]}
        n = 0
        for entry in self.made(what, records)["entries"]:
            self.assertEqual(entry["missing"], [], entry["id"])
            for now, then in zip(entry["numbers"], kept[entry["id"]]["numbers"], strict=True):
                if now["verdict"] == "not comparable":
                    continue
                with self.subTest(f"{entry['id']}: {now['what']}"):
                    self.assertIsNotNone(now["ours"])
                    self.assertTrue(now["verdict"] == "met" or now["word"])
                    if then["ours"] is not None:
                        self.assertLessEqual(abs(now["ours"] - then["ours"]), max(0.01 * abs(then["ours"]), 0.02 * (now["within"] or 0), now["resolved"]))
                    n += 1
        return n
