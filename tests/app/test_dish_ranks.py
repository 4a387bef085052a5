"""Runs under `mpirun -np 2` are those of one rank as far as their steps are solved: rung rigid-dish within 1e-7, rung rim, whose steps are solved to 1e-5, within 1e-5
(solved to 1e-10 the ranks agree to 1e-8: tests/fe_contact/test_ranks.cc); and a failure of one rank that ends both."""
import csv
import json
import os
import re
import tempfile
import unittest

from command import on_two_ranks, rimpact

TOUCH = ["run", "impact-window", "--rung", "rigid-dish", "--set", 'excitation.with=["weight","friction"]', "--set",
         "excitation.speed_m_per_s=0.5", "--set", "excitation.duration_s=0.0005", "--no-fields", "--quiet"]
SEAT = ["--mesh", "0", "--set", 'bearing.contact.pad_foot="frictional"']
RIM = ["run", "impact-window", "--mesh", "0", "--set", "excitation.speed_m_per_s=0.1", "--set", "bearing.contact.rim=0.1", "--no-fields", "--quiet"]


def columns(folder):
    with open(os.path.join(folder, "response.csv")) as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name] or 0) for row in rows] for name in rows[0]}


def vector(name):
    """The components of a vector have one name: Fx_N and Fz_N are of F_N."""
    return re.sub(r"[xyz]_", "_", name)


class Ranks(unittest.TestCase):
    def test_a_touch_is_that_of_one_rank(self):
        self.alike(TOUCH, 1e-7)

    def test_a_touch_with_a_frictional_seat_is_that_of_one_rank(self):
        self.alike([*TOUCH, *SEAT], 1e-6)

    def test_a_window_on_rung_rim_is_that_of_one_rank(self):
        self.alike(RIM, 1e-5)

    def alike(self, words, bound):
        with tempfile.TemporaryDirectory() as folder:
            one, two = os.path.join(folder, "one"), os.path.join(folder, "two")
            self.assertEqual(rimpact(*words, "--ranks", "1", "-o", one).returncode, 0)
            run = on_two_ranks(*words, "-o", two)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(run.stdout.count("impact-window"), 1, "the first rank alone speaks")
            with open(os.path.join(two, "summary.json")) as file:
                self.assertEqual(json.load(file)["ranks"], 2)
            alone, shared = columns(one), columns(two)
            self.assertGreater(max(map(abs, alone["Ix_N"])), 1e5)
            sizes = {}  # of a vector, not of each component: one that hardly is there has the others' rounding
            for name, values in alone.items():
                sizes[vector(name)] = max(sizes.get(vector(name), 0), max(map(abs, values)))
            for name, values in alone.items():
                size = sizes[vector(name)]
                for a, b in zip(values, shared[name], strict=True):
                    self.assertLessEqual(abs(a - b), bound * size, name)

    def test_a_failure_on_the_first_rank_ends_both(self):
        run = on_two_ranks(*TOUCH, "-o", "/proc/no-such-folder/run")
        self.assertNotEqual(run.returncode, 0)
        said = [line for line in run.stderr.splitlines() if line.startswith("error: ")]
        self.assertEqual(len(said), 1, run.stderr)
        self.assertIn("/proc/no-such-folder/run", said[0])


if __name__ == "__main__":
    unittest.main()
