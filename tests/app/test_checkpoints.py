"""What --resume does with a finished run, an early end, and damaged checkpoints: rung rim. (Rung rigid-dish: test_dish_checkpoints.py.)"""
import hashlib
import json
import os
import signal
import subprocess
import tempfile
import time
import unittest

import numpy as np
from checkpoints import copy_of, every_field, numbers, replace, reseal, with_entry
from command import RIMPACT, rimpact

EVERY = int(os.environ.get("RIMPACT_EVERY_FIELD", "1"))  # damages of one field in so many, the others by the slow suite
WINDOW = ["run", "impact-window", "--mesh", "0", "--set", "excitation.speed_m_per_s=0.05", "--set", "excitation.duration_s=0.015", "--quiet"]


def contents(folder):
    result = {}
    for place, _, files in os.walk(folder):
        for name in files:
            with open(os.path.join(place, name), "rb") as file:
                result[os.path.relpath(os.path.join(place, name), folder)] = hashlib.sha256(file.read()).hexdigest()
    return result


def until(folder, ready, *command, end=signal.SIGINT):
    """Runs until `ready(folder)`, then ends the process."""
    process = subprocess.Popen([RIMPACT, *command, "-o", folder], stderr=subprocess.PIPE, text=True)
    while process.poll() is None and not ready(folder):
        time.sleep(0.02)
    process.send_signal(end)
    _, errors = process.communicate()
    return process.returncode, errors


def steps_kept(folder, at_least):
    path = os.path.join(folder, "checkpoint.h5")
    try:
        return numbers(path)["steps"][0] >= at_least
    except (OSError, KeyError):  # not there yet, or being replaced, or only begun
        return False


class Rim(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.done = os.path.join(cls.temporary.name, "done")
        run = rimpact(*WINDOW, "-o", cls.done)
        assert run.returncode == 0, run.stderr
        cls.half = os.path.join(cls.temporary.name, "half")
        code, errors = until(cls.half, lambda folder: steps_kept(folder, 20), *WINDOW)
        assert code == 130, errors

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def refused(self, folder, *needles):
        run = rimpact(*WINDOW, "-o", folder, "--resume")
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertEqual(run.stderr.count("error: "), 1, run.stderr)
        for needle in needles:
            self.assertIn(needle, run.stderr)

    def test_a_finished_run_stays_as_it_is(self):
        before = contents(self.done)
        run = rimpact(*WINDOW, "-o", self.done, "--resume")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("done", run.stdout)
        self.assertEqual(contents(self.done), before)
        table = json.loads(rimpact(*WINDOW, "-o", self.done, "--resume", "--json").stdout)
        with open(os.path.join(self.done, "summary.json")) as file:
            self.assertEqual(table, json.load(file))

    def test_ended_between_the_last_checkpoint_and_the_summary(self):
        folder = copy_of(self.done, "no-summary")
        for name in ("summary.json", "response.h5", "response.csv"):
            os.remove(os.path.join(folder, name))
        run = rimpact(*WINDOW, "-o", folder, "--resume")
        self.assertEqual(run.returncode, 0, run.stderr)
        for name in ("response.csv", "scene.toml"):
            self.assertEqual(contents(folder)[name], contents(self.done)[name], name)
        with open(os.path.join(folder, "summary.json")) as file, open(os.path.join(self.done, "summary.json")) as whole:
            self.assertEqual(json.load(file)["impacts"], json.load(whole)["impacts"])

    def test_it_says_what_it_is_of(self):
        with open(os.path.join(self.done, "summary.json")) as file:
            identity = json.load(file)["identity"]
        self.assertEqual({len(identity["scene"]), len(identity["build"])}, {64})
        self.assertEqual(identity["inputs"], {})

    def test_killed_early_it_starts_afresh(self):
        folder = os.path.join(self.temporary.name, "early")
        code, _ = until(folder, lambda place: os.path.exists(os.path.join(place, "checkpoint.h5")), *WINDOW, end=signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        run = rimpact(*[word for word in WINDOW if word != "--quiet"], "-o", folder, "--resume")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(contents(folder)["response.csv"], contents(self.done)["response.csv"])

    def test_a_closed_terminal_leaves_a_checkpoint(self):
        folder = os.path.join(self.temporary.name, "hangup")
        code, errors = until(folder, lambda place: steps_kept(place, 20), *WINDOW, end=signal.SIGHUP)
        self.assertEqual(code, 130, errors)
        with open(os.path.join(folder, "summary.json")) as file:
            self.assertEqual(json.load(file)["status"], "interrupted")

    def test_nothing_to_resume(self):
        folder = os.path.join(self.temporary.name, "nothing")
        self.refused(folder, "nothing to resume", "run without --resume")
        self.assertFalse(os.path.exists(folder))

    def test_another_scene_or_version_is_refused(self):
        run = rimpact(*WINDOW, "-o", self.half, "--resume", "--set", "bearing.rim.height_mm=58")
        self.assertEqual(run.returncode, 3)
        self.assertIn("belongs to another run: the scene changed", run.stderr)

    def test_a_killed_push_goes_on_to_the_last_bit(self):
        push = ["run", "rim-push", "--mesh", "0", "--no-fields", "--quiet", "--set", "excitation.travel_mm=0.5"]
        whole, killed = (os.path.join(self.temporary.name, name) for name in ("push-whole", "push-killed"))
        self.assertEqual(rimpact(*push, "-o", whole).returncode, 0)
        until(killed, lambda place: steps_kept(place, 10), *push, end=signal.SIGKILL)
        self.assertFalse(os.path.exists(os.path.join(killed, "summary.json")))
        run = rimpact(*push, "-o", killed, "--resume")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(contents(killed)["response.csv"], contents(whole)["response.csv"])

    def test_every_damaged_byte_is_found(self):
        with open(os.path.join(self.half, "checkpoint.h5"), "rb") as file:
            whole = file.read()
        for what, damage in (("flipped", lambda b: b[: len(b) // 2] + bytes([b[len(b) // 2] ^ 4]) + b[len(b) // 2 + 1 :]), ("cut", lambda b: b[: len(b) // 2]),
                             ("empty", lambda b: b""), ("another file", lambda b: b"hello\n" * 1000), ("older", lambda b: b[512:]), ("longer", lambda b: b + b"\0")):
            with self.subTest(what):
                folder = copy_of(self.half, "bytes")
                with open(os.path.join(folder, "checkpoint.h5"), "wb") as file:
                    file.write(damage(whole))
                self.refused(folder, "run without --resume")

    def test_an_edited_checkpoint_is_found_by_its_checksum(self):
        folder = copy_of(self.half, "edited")
        path = os.path.join(folder, "checkpoint.h5")
        replace(path, "bearing_v", with_entry(numbers(path)["bearing_v"], 0, 0.06), sealed=False)
        self.refused(folder, "do not match their checksum")
        reseal(path)
        self.assertEqual(rimpact(*WINDOW, "-o", folder, "--resume").returncode, 0)  # with the checksum made right it is a checkpoint again

    def test_every_field_is_checked(self):
        kept = numbers(os.path.join(self.half, "checkpoint.h5"))
        self.assertGreater(len(kept), 50)
        cases = list(every_field(kept))[::EVERY]
        for name, wrong in (("arcs", (-1, 1e300, np.nan, 2.5, 2)), ("in_contact", (2,)), ("current_arc", (5, np.nan, 1e18, -1)), ("bearing_time", (-1,)),
                            ("next_step", (0,)), ("arc0_yielded", (3,))):
            cases += [(name, str(value), [value]) for value in wrong]
        cases += [("response_time", "back", kept["response_time"][::-1]), ("response_time", "1e300", with_entry(kept["response_time"], 3, 1e300)),
                  ("arc0_history_alpha", "negative", with_entry(kept["arc0_history_alpha"], 0, -1))]
        for name, what, values in cases:
            with self.subTest(field=name, what=what):
                folder = copy_of(self.half, "field")
                replace(os.path.join(folder, "checkpoint.h5"), name, values)
                self.refused(folder, "is damaged (field ", "run without --resume")


if __name__ == "__main__":
    unittest.main()
