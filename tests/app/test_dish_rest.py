"""Rung rigid-dish at rest: steps grow once the slider has stopped for good, and the bearing still carries the shaking's inertia."""
import csv
import json
import math
import os
import tempfile
import unittest

from command import rimpact

MASS, GRAVITY = 853e3 / 9.81, 9.81
PUSH_ENDS, END, SWAY = 0.1, 5.0, 0.02  # [s], [s], [g]
RINGS_ON = 0.5  # [s]; until the steps have damped what it rings with on stopping


def ground(t):
    """A push that makes it slide, then a sway that friction holds [g]."""
    return 0.2 if t < PUSH_ENDS else SWAY * math.sin(math.pi * (t - PUSH_ENDS))


class Rest(unittest.TestCase):
    def test_sways_in_long_steps(self):
        with tempfile.TemporaryDirectory() as folder:
            record, run = os.path.join(folder, "push.csv"), os.path.join(folder, "run")
            with open(record, "w") as file:
                file.write("time_s,acceleration_g\n" + "".join(f"{k / 200:.3f},{ground(k / 200):.8f}\n" for k in range(int(200 * END) + 1)))
            scene = ["ricker-0.78g-1.0s", "--rung", "rigid-dish", "--mesh", "0", "--set", 'excitation.kind="record"', "--set",
                     f'excitation.x="{record}"', "--set", f"excitation.duration_s={END}"]
            plan = json.loads(rimpact("check", *scene, "--json").stdout)
            self.assertGreater(plan["rests_from_s"], PUSH_ENDS)
            self.assertLess(plan["rests_from_s"], 2)
            made = rimpact("run", *scene, "-o", run, "--no-fields", "--quiet")
            self.assertEqual(made.returncode, 0, made.stderr)
            with open(os.path.join(run, "summary.json")) as file:
                summary = json.load(file)
            self.assertLess(abs(summary["energy"]["imbalance_relative"]), 1e-3)
            self.assertAlmostEqual(summary["min_normal_force_N"] / (MASS * GRAVITY), 1, delta=0.2)
            with open(os.path.join(run, "response.csv")) as file:
                rows = [(float(row["time_s"]), float(row["ux_m"]), float(row["Fx_N"])) for row in csv.DictReader(file)]
            rest = [row for row in rows if row[0] > plan["rests_from_s"] + RINGS_ON]
            steps = [after[0] - before[0] for before, after in zip(rest, rest[1:])]
            self.assertAlmostEqual(sorted(steps)[len(steps) // 2], 0.05)
            self.assertLess(max(u for _, u, _ in rest) - min(u for _, u, _ in rest), 1e-3)
            for t, _, force in rest:
                self.assertLess(abs(force - MASS * GRAVITY * ground(t)), 0.02 * SWAY * MASS * GRAVITY, t)


if __name__ == "__main__":
    unittest.main()
