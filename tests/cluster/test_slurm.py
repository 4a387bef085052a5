"""studies/cluster/*.sbatch on a SLURM of one node: an array of shards, one of them killed and submitted again, gathered."""
import csv
import json
import math
import os
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


def at2(period):
    values = [0.25 * math.sin(2 * math.pi * 0.01 * i / period) if i < 400 else 0.0 for i in range(600)]
    return "PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 600, DT= .01 SEC\n" + "\n".join(f"{v:.6e}" for v in values) + "\n"


@unittest.skipIf(missing(), missing())
class Slurm(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        os.mkdir(self.path("records"))
        for name, period in (("RSN1_A000", 1.0), ("RSN2_B000", 1.7)):
            self.write(f"records/{name}.AT2", at2(period))
        self.write("study.toml", STUDY)
        self.write("dying", DYING.format(rimpact=RIMPACT))
        os.chmod(self.path("dying"), 0o755)
        self.slurm = OneNode(self.path("slurm"))
        self.addCleanup(self.slurm.stop)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def job(self, script, *options, **environment):
        return self.slurm.submit("--mem=500M", "--chdir", self.folder, "--output", self.path("job-%A-%a.txt"), *options,
                                 os.path.join(SOURCE, "studies", "cluster", script), "study.toml", "out", **environment)

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
        with open(self.path("out/reliability.csv"), encoding="utf-8") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 4)
        self.assertTrue(os.path.exists(self.path("out/report.html")))


if __name__ == "__main__":
    unittest.main()
