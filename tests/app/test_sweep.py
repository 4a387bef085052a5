"""`rimpact reduced --sweep`: grids in shards, resumed and gathered; sweeps that are refused."""
import csv
import json
import tempfile
import unittest

import h5py

from command import rimpact


class Sweeps(unittest.TestCase):
    GRID = ["reduced", "ricker-0.78g-1.0s", "--sweep", "excitation.scale=0.5:1.4:4", "--sweep", "reduced.mu_fast=0.07:0.08:2"]

    def rows(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def test_grid_in_shards_resumed_and_gathered(self):
        with tempfile.TemporaryDirectory() as folder:
            def run(*more):
                done = rimpact(*self.GRID, "-o", folder, "--json", "--quiet", *more)
                self.assertEqual(done.returncode, 0, done.stderr)
                return json.loads(done.stdout)
            self.assertEqual([run("--shard", f"{i}/3")["n_runs"] for i in (1, 2, 3)], [3, 3, 2])
            self.assertEqual(len(self.rows(f"{folder}/table-2-of-3.csv")), 3)
            whole = run("--threads", "2")
            self.assertEqual((whole["n_runs"], whole["kept"], whole["done"]), (8, 8, 8))
            rows = self.rows(whole["table"])
            self.assertEqual([row["run"] for row in rows], [str(i) for i in range(1, 9)])
            self.assertEqual({(row["excitation.scale"], row["n_impacts"] != "0") for row in rows},
                             {("0.5", False), ("0.8", False), ("1.1", True), ("1.4", True)})
            with h5py.File(f"{folder}/table.h5") as table:
                peaks = [float(row["peak_displacement_m"]) for row in rows]
                self.assertEqual(list(table["table/peak_displacement_m"]), peaks)

    def test_bad_sweeps(self):
        for arguments, code, needle in ((["--sweep", "excitation.scale=1:2"], 2, "KEY=a:b:n"),
                                        (["--sweep", "nowhere.toml"], 2, "nowhere.toml"),
                                        (["--sweep", "excitation.scale=1:2:3", "--shard", "4/3"], 2, "4/3"),
                                        (["--sweep", "excitation.scale=1:2:3", "--shard", "nan/3"], 2, "nan/3"),
                                        (["--shard", "1/3"], 2, "--sweep")):
            run = rimpact("reduced", "ricker-0.78g-1.0s", *arguments)
            self.assertEqual(run.returncode, code, run.stderr)
            self.assertIn(needle, run.stderr)
            self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)


if __name__ == "__main__":
    unittest.main()
