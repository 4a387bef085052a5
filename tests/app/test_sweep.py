"""`rimpact reduced --sweep`: grids in shards, resumed and gathered; sweeps that are refused."""
import csv
import json
import math
import os
import subprocess
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
                self.assertEqual(list(table["table/status"].asstr()), ["done"] * 8)
                touched = [row["first_touch_s"] == "" for row in rows]
                self.assertEqual([math.isnan(value) for value in table["table/first_touch_s"]], touched)  # empty is NaN, not 0
                self.assertEqual(list(table), ["meta", "table"])

    def test_a_column_of_a_slash_is_refused(self):
        done = rimpact("reduced", "ricker-0.78g-1.0s", "--sweep", "variable.a/b=1:2:2", "-o", "nowhere")
        self.assertEqual(done.returncode, 2)
        self.assertIn('variable.a/b', done.stderr)

    def test_slurms_scripts_make_the_same_table(self):
        with tempfile.TemporaryDirectory() as place:
            plain = rimpact(*self.GRID, "-o", "plain", "--quiet", cwd=place)
            self.assertEqual(plain.returncode, 0, plain.stderr)
            made = rimpact(*self.GRID, "-o", "it's shared", "--slurm", "3", cwd=place)
            self.assertEqual(made.returncode, 0, made.stderr)
            scripts = f"{place}/it's shared/slurm"
            self.assertEqual(sorted(os.listdir(scripts)), ["array.sbatch", "gather.sbatch", "submit.sh"])
            with open(f"{scripts}/array.sbatch", encoding="utf-8") as file:
                self.assertIn("#SBATCH --array=1-3\n", file.read())
            program = os.environ["RIMPACT"]
            for task in ("1", "2", "3"):
                shard = subprocess.run(["bash", f"{scripts}/array.sbatch"], capture_output=True, text=True,
                                       env={**os.environ, "SLURM_ARRAY_TASK_ID": task, "RIMPACT": program})
                self.assertEqual(shard.returncode, 0, shard.stderr)
            gathered = subprocess.run(["bash", f"{scripts}/gather.sbatch"], capture_output=True, text=True,
                                      env={**os.environ, "RIMPACT": program})
            self.assertEqual(gathered.returncode, 0, gathered.stderr)
            self.assertIn("8 of them kept", gathered.stdout)
            tables = [self.rows(f"{place}/{folder}/table.csv") for folder in ("it's shared", "plain")]
            for row in tables[0] + tables[1]:
                del row["wall_time_s"]
            self.assertEqual(*tables)

    def test_a_dry_run_makes_no_folder(self):
        with tempfile.TemporaryDirectory() as place:
            run = rimpact(*self.GRID, "-o", "none", "--dry-run", "--json", "--jobs", "2", cwd=place)
            self.assertEqual(run.returncode, 0, run.stderr)
            plan = json.loads(run.stdout)
            self.assertEqual((plan["n_runs"], plan["at_once"]), (8, 2))
            self.assertGreater(plan["expected_seconds"], 0)
            self.assertFalse(os.path.exists(f"{place}/none"))

    def test_a_case_s_record_is_sought_on_the_shelf(self):
        with tempfile.TemporaryDirectory() as shelf, tempfile.TemporaryDirectory() as place:
            for name, peak in (("A", 0.2), ("B", 0.4)):
                with open(f"{shelf}/{name}.AT2", "w") as file:
                    file.write("PEER\nown\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 200, DT= .0100 SEC\n")
                    file.writelines(f"{peak * math.sin(0.1 * k):.6e}\n" for k in range(200))
            with open(f"{place}/sweep.toml", "w") as file:
                file.writelines(f'[[case]]\nname = "{name}"\nexcitation.kind = "record"\nexcitation.x = "{name}.AT2"\n' for name in "AB")
            run = ["reduced", "ricker-0.78g-1.0s", "--sweep", "sweep.toml", "--json", "-o"]
            self.assertEqual(rimpact(*run, "none", cwd=place).returncode, 3)
            found = json.loads(rimpact(*run, "found", cwd=place, RIMPACT_RECORDS=shelf).stdout)
            self.assertEqual(found["done"], 2)
            peaks = [float(row["peak_displacement_m"]) for row in self.rows(f"{place}/found/table.csv")]
            self.assertLess(peaks[0], peaks[1])

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
