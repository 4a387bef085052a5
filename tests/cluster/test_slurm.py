"""Arrays of shards on a SLURM of one node: studies/cluster/*.sbatch and the scripts that --slurm writes; a task killed, one told to
end, both submitted again, all gathered."""
import csv
import json
import math
import os
import subprocess
import tempfile
import unittest

from one_node import OneNode, missing

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RIMPACT = os.environ["RIMPACT"]
STUDY = """scene = "ricker-0.78g-1.0s"
[set]
excitation.duration_s = 7.0
[intensity]
period_s = 3.0
levels_g = [0.1, 0.3]
[motions]
folders = ["records"]
[hazard]
points = [[0.1129, 475], [0.26227, 2475]]
[[limit]]
quantity = "peak_displacement_m"
values = [0.2]
[grid]
bearing.surface.a_m = [2.25, 0.7875, 0.675, 0.5625]
[latin_hypercube]
samples = 20
reduced.mu_fast = { low = 0.03, high = 0.07 }
[linked]
reduced.mu_slow = { product = [1.0, "reduced.mu_fast"] }
[bootstrap]
replicates = 20
"""
#: What stands in for rimpact once: it is killed as a node that dies kills it, after a moment of work.
DYING = """#!/bin/bash
"{rimpact}" "$@" --threads 1 &
sleep 0.2
kill -KILL $!
wait $!
"""
#: The same for the second task of an array alone.
SECOND_DIES = """#!/bin/bash
[ "${{SLURM_ARRAY_TASK_ID:-0}}" != 2 ] && exec "{rimpact}" "$@"
exec "{dying}" "$@"
"""


def at2(period):
    values = [0.25 * math.sin(2 * math.pi * 0.01 * i / period) if i < 400 else 0.0 for i in range(600)]
    return "PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 600, DT= .01 SEC\n" + "\n".join(f"{v:.6e}" for v in values) + "\n"


@unittest.skipIf(missing(), missing())
class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.slurm = OneNode(os.path.join(holder.name, "slurm"))
        cls.addClassCleanup(cls.slurm.stop)

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        os.mkdir(self.path("records"))
        for name, period in (("RSN1_A000", 1.0), ("RSN2_B000", 1.7)):
            self.write(f"records/{name}.AT2", at2(period))
        self.write("study.toml", STUDY)
        self.write("dying", DYING.format(rimpact=RIMPACT), 0o755)
        self.write("second-dies", SECOND_DIES.format(rimpact=RIMPACT, dying=self.path("dying")), 0o755)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text, mode=0o644):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(self.path(name), mode)

    def rows(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def job(self, script, *options, **environment):
        return self.slurm.submit("--mem=500M", "--chdir", self.folder, "--output", self.path("job-%A-%a.txt"), *options,
                                 os.path.join(SOURCE, "studies", "cluster", script), "study.toml", "out", **environment)

    def make_scripts(self, *words):
        """By --slurm; they ask for the 4 GB of a usual node, which SBATCH_MEM_PER_NODE lowers here."""
        done = subprocess.run([RIMPACT, *words, "--slurm", "3"], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertIn("submit.sh` submits 3 shards", done.stdout)

    def slurm_environment(self, program):
        return self.slurm.environment | {"RIMPACT": program, "SBATCH_MEM_PER_NODE": "500M", "SBATCH_OUTPUT": self.path("job-%A-%a.txt")}

    def run_there(self, *words, program=RIMPACT):
        return subprocess.run(words, cwd=self.folder, env=self.slurm_environment(program), capture_output=True, text=True, check=True).stdout

    def test_a_killed_shard_goes_on_and_all_are_gathered(self):
        self.job("reliability.sbatch", "--array=1,3", RIMPACT=RIMPACT, RIMPACT_SHARDS="3")
        self.job("reliability.sbatch", "--array=2", RIMPACT=self.path("dying"), RIMPACT_SHARDS="3")
        self.slurm.wait_for_all()
        shards = self.job("reliability.sbatch", "--array=2", RIMPACT=RIMPACT, RIMPACT_SHARDS="3")
        self.job("gather.sbatch", f"--dependency=afterok:{shards}", RIMPACT=RIMPACT)
        self.slurm.wait_for_all()
        with open(self.path("out/reliability.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertEqual(summary["n_runs"], 4 * 2 * 2 * 20)
        self.assertEqual(summary["kept"], summary["n_runs"])  # the gathering call had nothing left to run
        self.assertEqual(summary["n_runs_without_result"], 0)
        self.assertEqual(len(self.rows("out/reliability.csv")), 4)
        self.assertTrue(os.path.exists(self.path("out/report.html")))

    def test_submit_sh_of_a_study_gathers_what_a_killed_task_left(self):
        """The gathering job waits for the array, however it ends, and runs what is missing itself."""
        self.make_scripts("reliability", "study.toml", "-o", "out")
        self.run_there("bash", "out/slurm/submit.sh", program=self.path("second-dies"))
        self.slurm.wait_for_all()
        with open(self.path("out/reliability.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertEqual(summary["n_runs"], 4 * 2 * 2 * 20)
        self.assertLess(summary["kept"], summary["n_runs"])  # of the killed task
        self.assertEqual(summary["n_runs_without_result"], 0)

    def test_a_sweeps_task_that_is_told_to_end_keeps_its_rows_and_goes_on(self):
        runs = 30_000  # ten seconds a task of one core
        self.make_scripts("reduced", "ricker-0.78g-1.0s", "--sweep", f"excitation.scale=0.8:1.2:{runs}", "-o", "out")
        job = self.run_there("sbatch", "--parsable", "--array=2", "--cpus-per-task=1", "out/slurm/array.sbatch").strip()
        self.slurm.wait_until(lambda: os.path.exists(self.path("out/table-2-of-3.csv")), "the first rows")
        self.run_there("scancel", "--batch", "--signal=TERM", f"{job}_2")  # as SLURM does a minute before the time is up
        self.slurm.wait_for_all()
        before = len(self.rows("out/table-2-of-3.csv"))
        self.assertGreater(before, 0)
        self.assertLess(before, runs // 3)
        self.run_there("bash", "out/slurm/submit.sh")
        self.slurm.wait_for_all()
        rows = self.rows("out/table.csv")
        self.assertEqual(len(rows), runs)
        self.assertEqual({row["status"] for row in rows}, {"done"})


if __name__ == "__main__":
    unittest.main()
