"""Rung rigid-dish's restarts: killed in mid-slide and resumed, a run goes on as the one that was left alone, to the last bit; an
interrupt loses no step."""
import json
import os
import signal
import subprocess
import tempfile
import time
import unittest

import numpy as np
from checkpoints import numbers
from command import RIMPACT, rimpact
from test_checkpoints import steps_kept, until

# On one rank: shared out, MUMPS sums up in the order in which messages come.
LOOP = ["run", "static-unidirectional", "--ranks", "1", "--quiet"]
SEAT = ["--mesh", "0", "--set", 'bearing.contact.pad_foot="frictional"']  # the pad rubs in the foot's recess


def run_until_next_checkpoint(folder, *more):
    """Runs until the checkpoint is written once more (every ten steps), kills; the checkpoint's numbers."""
    path = os.path.join(folder, "checkpoint.h5")
    before = os.stat(path).st_mtime_ns if os.path.exists(path) else None
    process = subprocess.Popen([RIMPACT, *LOOP, "-o", folder, *more], stderr=subprocess.PIPE, text=True)
    while process.poll() is None and (not steps_kept(folder, 10) or os.stat(path).st_mtime_ns == before):
        time.sleep(0.05)
    process.kill()
    _, errors = process.communicate()
    assert process.returncode == -signal.SIGKILL, errors
    return numbers(path)


class Resume(unittest.TestCase):
    def test_killed_in_mid_slide(self):
        self.goes_on()

    def test_an_interrupt_loses_no_step(self):
        with tempfile.TemporaryDirectory() as folder:
            code, errors = until(folder, lambda place: steps_kept(place, 10), *LOOP)
            self.assertEqual(code, 130, errors)
            with open(os.path.join(folder, "summary.json")) as file:
                made = json.load(file)["n_steps"]
            self.assertEqual(numbers(os.path.join(folder, "checkpoint.h5"))["steps"][0], made)

    def test_with_a_frictional_seat(self):
        self.goes_on(*SEAT)

    def goes_on(self, *more):
        with tempfile.TemporaryDirectory() as folder:
            whole, halves = os.path.join(folder, "whole"), os.path.join(folder, "halves")
            first = run_until_next_checkpoint(halves, *more)
            second = run_until_next_checkpoint(halves, *more, "--resume")
            self.assertEqual([first["steps"][0], second["steps"][0]], [10, 20])
            for name in ("seconds_wall", "seconds_processor"):
                self.assertGreater(second[name][0], first[name][0])
            process = subprocess.Popen([RIMPACT, *LOOP, *more, "-o", whole], stderr=subprocess.PIPE)
            path, straight = os.path.join(whole, "checkpoint.h5"), None
            while process.poll() is None and straight is None:
                time.sleep(0.05)
                if steps_kept(whole, 20):
                    straight = numbers(path)
            process.send_signal(signal.SIGINT)
            process.communicate()
            self.assertGreater(sum(straight["contact0_status"] == 2), 0)  # slipping: something is at stake
            for name, values in second.items():
                if name.startswith("seconds_"):
                    continue  # what it took, and that of both processes
                self.assertTrue(np.array_equal(values, straight[name], equal_nan=True), name)
            other = rimpact(*LOOP, *more, "-o", halves, "--resume", "--set", "excitation.amplitude_m=0.2")
            self.assertEqual(other.returncode, 3)
            self.assertIn("another", other.stderr)


if __name__ == "__main__":
    unittest.main()
