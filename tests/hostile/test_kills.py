"""`kill -9` at random instants, and what is made by going on: the same bytes as by a run that nobody disturbed.
usage: test_kills.py (RIMPACT in the environment; RIMPACT_KILLS: instants a case, RIMPACT_SEED)."""
import csv
import os
import pathlib
import random
import signal
import subprocess
import tempfile
import time
import unittest

INSTANTS, SEED = int(os.environ.get("RIMPACT_KILLS", "20")), int(os.environ.get("RIMPACT_SEED", "1"))
STOPPED = 1e-4  # main and study die with their runs stopped as by Ctrl-C, which keep a checkpoint off the schedule
WINDOW = ["impact-window", "--quiet", "--set", "excitation.speed_m_per_s=0.05", "--set", "model.mesh=0"]
WEIGHT = ["--set", 'excitation.with=["weight","friction"]', "--no-fields"]
SWEEP = ["--sweep", "excitation.scale=0.8:1.2:100", "--sweep", "reduced.k_i_kN_per_m=3e5:6e5:3"]


def without_seconds(path):
    """Rows of a table but for what they took."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{key: value for key, value in row.items() if key != "wall_time_s"} for row in csv.DictReader(file)]


def peaks(table):
    return [max(abs(float(row[key])) for row in table) for key in ("Fx_N", "ux_m")]


def differ(one, other, tolerance):
    """Whether two tables do: in a digit, or, with a tolerance, in a share of their peak force and displacement."""
    if not tolerance or one is None or other is None:
        return one != other
    return any(abs(a - b) > tolerance * a for a, b in zip(peaks(one), peaks(other)))


def files(folder, pattern):
    """Contents of what must be alike, by its path in the folder."""
    return {str(path.relative_to(folder)): without_seconds(path) for path in sorted(pathlib.Path(folder).glob(pattern))}


class Killed(unittest.TestCase):
    def start(self, words, folder):
        return subprocess.Popen([os.environ["RIMPACT"], *words, "-o", folder], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)

    def finish(self, words, folder):
        process = self.start(words, folder)
        _, said = process.communicate()
        self.assertEqual(process.returncode, 0, said.decode(errors="replace"))

    def kill_and_go_on(self, words, pattern, instants=INSTANTS, go_on=(), tolerance=0.0):
        with tempfile.TemporaryDirectory() as where:
            began = time.monotonic()
            self.finish(words, f"{where}/whole")
            seconds, whole = time.monotonic() - began, files(f"{where}/whole", pattern)
            self.assertTrue(whole)
            chance, killed = random.Random(SEED), 0
            for k in range(instants):
                with self.subTest(instant=k):
                    folder = f"{where}/{k}"
                    process = self.start(words, folder)
                    time.sleep(seconds * chance.random())
                    if process.poll() is None:
                        os.killpg(process.pid, signal.SIGKILL)
                        killed += 1
                    process.communicate()
                    begun = os.path.exists(f"{folder}/checkpoint.h5") or not go_on
                    self.finish([*words, *(go_on if begun else ())], folder)
                    again = files(folder, pattern)
                    self.assertEqual([name for name in {*whole, *again} if differ(whole.get(name), again.get(name), tolerance)], [])
                    self.assertEqual([str(path) for path in pathlib.Path(folder).rglob("*.tmp")], [])
            print(f"{self.id().split('_')[-1]}: {instants} instants, {killed} killed, seed {SEED}, {seconds:.1f} s each")

    def test_rim(self):
        self.kill_and_go_on(["run", *WINDOW, "--no-fields"], "response.csv", go_on=["--resume"])

    def test_dish(self):
        self.kill_and_go_on(["run", *WINDOW, *WEIGHT, "--rung", "rigid-dish"], "response.csv", max(1, INSTANTS // 4), ["--resume"])

    def test_full(self):
        self.kill_and_go_on(["run", *WINDOW, *WEIGHT, "--rung", "full"], "response.csv", max(1, INSTANTS // 10), ["--resume"])

    def test_reduced(self):
        self.kill_and_go_on(["reduced", "ricker-0.78g-1.0s"], "response.csv")

    def test_sweep(self):
        self.kill_and_go_on(["reduced", "ricker-0.78g-1.0s", *SWEEP], "table.csv")

    def test_study(self):
        self.kill_and_go_on(["study", *WINDOW, "--axes", "rung", "--rungs", "reduced,rim", "--error", "1000"], "**/response.csv", tolerance=STOPPED)

    def test_main(self):  # one job at a time: beside another one a run has fewer threads, which round otherwise
        self.kill_and_go_on(["main", "--windows-only", "--speeds", "0.05,0.1,0.2", "--mesh", "0", "--laws", "none", "--jobs", "1"],
                         "**/response.csv", max(1, INSTANTS // 4), tolerance=STOPPED)


if __name__ == "__main__":
    unittest.main()
