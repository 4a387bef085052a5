"""`run --ranks N`: what ends one process ends all ranks in order, with exit code 130 (RIMPACT in the environment). A program
that notes what it hears stands in for rimpact-fe; test_dish_ranks.py has the real one."""
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

STAND_IN = """#!/usr/bin/python3
import os, pathlib, signal, sys, time
rank, folder = os.environ.get("OMPI_COMM_WORLD_RANK", "0"), pathlib.Path(sys.argv[sys.argv.index("-o") + 1])
def end(number, _):
    time.sleep(2.5)  # a step goes on for longer than mpirun waits
    (folder / f"checkpoint{rank}").write_text(signal.Signals(number).name)
    sys.exit(130)
signal.signal(signal.SIGUSR1, end)
(folder / f"words{rank}").write_text(" ".join(sys.argv[1:]))
time.sleep(60)
"""


@unittest.skipUnless(shutil.which("mpirun"), "no mpirun here")
class RankSignals(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        program = self.folder / "stand_in.py"
        program.write_text(STAND_IN)
        program.chmod(0o755)
        self.environment = dict(os.environ, RIMPACT_FE_PROGRAM=str(program))

    def start(self, *ranks, scene=("some.toml",)):
        return subprocess.Popen([os.environ["RIMPACT"], "run", *scene, *ranks, "-o", str(self.folder)], env=self.environment,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, start_new_session=True)

    def until_started(self, process, n):
        for _ in range(300):
            if all((self.folder / f"words{k}").exists() and (self.folder / f"words{k}").read_text() for k in range(n)):
                return
            self.assertIsNone(process.poll(), process.stderr.read() if process.poll() is not None else "")
            time.sleep(0.1)
        self.fail("the ranks did not start")

    def test_every_end_leaves_what_each_rank_keeps(self):
        for tell in (lambda p: os.killpg(p.pid, signal.SIGINT), lambda p: p.send_signal(signal.SIGTERM), lambda p: p.send_signal(signal.SIGHUP)):
            process = self.start("--ranks", "2")
            self.until_started(process, 2)
            tell(process)
            _, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130, errors)
            for rank in range(2):
                self.assertEqual((self.folder / f"checkpoint{rank}").read_text(), "SIGUSR1")
                self.assertEqual((self.folder / f"words{rank}").read_text(), f"run some.toml -o {self.folder}")
                (self.folder / f"checkpoint{rank}").unlink()
                (self.folder / f"words{rank}").unlink()

    def test_numbers_that_are_none(self):
        for words in (("--ranks", "0"), ("--ranks=two",), ("--ranks", "100000"), ("--ranks", "")):
            process = self.start(*words)
            _, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 2, errors)
            self.assertIn("--ranks", errors)

    def test_a_long_run_takes_two_ranks_unless_told(self):
        cores = len(os.sched_getaffinity(0))
        if cores < 2:
            self.skipTest("one processor here")
        long, none = ["ricker-0.78g-1.0s", "--rung", "rigid-dish"], {}
        self.environment.pop("RIMPACT_THREADS", None)
        free = self.environment
        for scene, threads, n in ((long, none, 2), ([*long, "--ranks", "1"], none, 1), ([*long, "--mesh", "0"], none, 1), (["ricker-0.78g-1.0s"], none, 2),
                                  ([*long, "--dry-run"], none, 1), (long, {"RIMPACT_THREADS": "1"}, 1)):
            with self.subTest(" ".join(scene), **threads), tempfile.TemporaryDirectory() as folder:
                self.environment, self.folder = {**free, **threads}, pathlib.Path(folder)
                process = self.start(scene=scene)
                self.until_started(process, n)
                self.assertEqual(len(list(self.folder.glob("words*"))), n)
                process.kill()
                process.communicate()

    def test_killed_with_its_ranks(self):
        process = self.start("--ranks", "2")
        self.until_started(process, 2)
        program = self.environment["RIMPACT_FE_PROGRAM"]
        process.kill()
        process.communicate()
        for _ in range(50):
            left = subprocess.run(["pgrep", "-f", f"mpirun.*{program}"], stdout=subprocess.PIPE, text=True).stdout
            if not left:
                return
            time.sleep(0.1)
        self.fail(f"still there: {left}")


if __name__ == "__main__":
    unittest.main()
