"""compare -o: curves, pictures and the page, of responses that are there as compare.json names them."""
import json
import os
import shutil

import synthetic
from support import InFolder, in_process


class Compared(InFolder):
    def compared(self, n, capacity=0.4):
        """A folder as the command leaves it to Python: n responses, each with a rim of its own."""
        items = []
        for k in range(n):
            letter = chr(ord("A") + k)
            synthetic.run(self.path("curves", letter), letter, 'kind = "ricker"', synthetic.ricker(0.78 * 1.1, 1.0), synthetic.Rim(4.5e8 + 2e7 * k, 0.65),
                          "rim")
            items.append({"name": letter, "path": f"somewhere/{letter}", "metrics": {"peak_force_error": 0.02 * k, "rebound_error": None},
                          "differences": [{"key": "reduced.k_i_kN_per_m", "a": "450000", "b": "470000", "comparable": True}], "notes": []})
        self.write("compare.json", json.dumps({"version": "test", "capacity_m": capacity, "items": items}))

    def test_any_number_is_drawn(self):
        for n in (2, 10):
            with self.subTest(n):
                shutil.rmtree(self.path("curves"), ignore_errors=True)
                self.compared(n)
                run = in_process("report.compare", self.folder)
                self.assertEqual(run.returncode, 0, run.stderr)
                with open(self.path("compare.html"), encoding="utf-8") as file:
                    page = file.read()
                self.assertEqual(page.count("data:image/webp"), 2)
                self.assertIn("reduced.k_i_kN_per_m", page)
                self.assertNotIn("What is missing", page)
                for name in ("response", "impacts"):
                    self.assertTrue(os.path.isfile(self.path("figures", f"{name}.png")))

    def test_a_damaged_file_is_one_sentence(self):
        self.compared(2)
        self.write("compare.json", "{")
        run = in_process("report.compare", self.folder)
        self.assertEqual(run.returncode, 3)
        self.assertIn("compare.json", run.stderr)
