"""Whose a folder is: another scene's or kind's result is not replaced, one process writes at a time, stale results are made again, names lead
nowhere else, and damaged files are one sentence. Without finite elements (stand_in_fe.py)."""
import fcntl
import json
import os
import shutil
import subprocess
import tempfile
import unittest

import h5py
import numpy as np
from command import RIMPACT, rimpact

STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in_fe.py")
WINDOW = ["reduced", "impact-window"]


class Folders(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.place = temporary.name
        self.folder = os.path.join(self.place, "run")

    def path(self, *parts):
        return os.path.join(self.place, *parts)

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def summary(self, folder=None):
        with open(os.path.join(folder or self.folder, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def says(self, code, *needles, arguments, **more):
        run = rimpact(*arguments, **more)
        self.assertEqual(run.returncode, code, run.stderr)
        for needle in needles:
            self.assertIn(needle, run.stderr)
        if code:
            self.assertEqual(run.stderr.count("error: "), 1, run.stderr)
            self.assertNotIn("bug", run.stderr)
        return run

    def test_another_scenes_run_is_not_replaced(self):
        self.says(0, arguments=[*WINDOW, "-o", self.folder])
        before = self.summary()
        self.says(2, self.folder + " holds a run of another scene", "name is", "--force", arguments=["reduced", "ricker-0.78g-1.0s", "-o", self.folder])
        self.assertEqual(self.summary(), before)
        self.says(0, "is replaced", arguments=["reduced", "ricker-0.78g-1.0s", "-o", self.folder, "--force"])
        self.assertNotEqual(self.summary()["identity"]["scene"], before["identity"]["scene"])

    def test_a_scene_being_edited_is_run_again_and_that_is_said(self):
        self.says(0, arguments=[*WINDOW, "-o", self.folder])
        run = self.says(0, arguments=[*WINDOW, "-o", self.folder])
        self.assertEqual(run.stderr, f"next: rimpact report {self.folder}\n")
        self.says(0, "speed_m_per_s is 0.1 there and 0.2 here", arguments=[*WINDOW, "-o", self.folder, "--set", "excitation.speed_m_per_s=0.2"])

    def test_a_finite_element_run_is_not_replaced_by_a_reduced_one(self):
        self.says(0, arguments=[*WINDOW, "-o", self.folder])
        summary = self.summary()
        self.write("run/summary.json", json.dumps({**summary, "rung": "rim"}))
        for name in ("run/fields/rim_000.vtu", "run/fields.pvd", "run/checkpoint.h5", "run/notes.txt"):
            self.write(name, "x")
        self.says(2, "holds a run by finite elements", arguments=[*WINDOW, "-o", self.folder])
        self.assertTrue(os.path.exists(self.path("run", "checkpoint.h5")))
        self.says(0, arguments=[*WINDOW, "-o", self.folder, "--force"])
        left = set(os.listdir(self.folder))
        self.assertEqual(left, {"scene.toml", "response.h5", "response.csv", "summary.json", "notes.txt"})

    def test_collections_are_not_mixed(self):
        sweep = ["reduced", "impact-window", "--sweep", "excitation.speed_m_per_s=0.1:0.2:2", "--quiet"]
        self.says(0, arguments=[*sweep, "-o", self.folder])
        self.says(2, "holds a sweep", arguments=[*WINDOW, "-o", self.folder])
        self.says(2, "holds a sweep", arguments=["study", "impact-window", "-o", self.folder], RIMPACT_FE_PROGRAM=STAND_IN)
        self.says(0, arguments=[*WINDOW, "-o", self.path("one")])
        self.says(2, "holds a run", arguments=[*sweep, "-o", self.path("one")])
        self.says(2, "holds a run", arguments=["main", "-o", self.path("one")], RIMPACT_FE_PROGRAM=STAND_IN)

    def test_one_process_at_a_time(self):
        os.makedirs(self.folder)
        with open(os.path.join(self.folder, ".rimpact.lock"), "w", encoding="utf-8") as lock:
            lock.write("process 12345 on testhost, since noon: rimpact run big\n")
            lock.flush()
            fcntl.flock(lock, fcntl.LOCK_EX)
            for arguments in (WINDOW, ["calibrate", self.folder], ["study", "impact-window"], ["main"], ["geometry"],
                              ["reduced", "impact-window", "--sweep", "excitation.speed_m_per_s=0.1:0.2:2"]):
                with self.subTest(arguments[0]):
                    self.says(6, "in use by process 12345 on testhost", arguments=[*arguments, "-o", self.folder], RIMPACT_FE_PROGRAM=STAND_IN)
        self.says(0, arguments=[*WINDOW, "-o", self.folder])  # the holder is gone: the file alone locks nothing
        self.assertNotIn(".rimpact.lock", os.listdir(self.folder))

    def record_case(self, peak):
        self.write("case/q.csv", f"time_s,acceleration_g\n0,0\n0.5,{peak}\n1.0,0\n")
        return self.write("case/scene.toml", '[excitation]\nkind = "record"\nx = "q.csv"\nduration_s = 2.0\n')

    def test_a_study_runs_again_what_an_edited_record_made_stale(self):
        study = ["study", self.record_case(0.1), "--axes", "mesh", "--meshes", "1,2", "-o", self.folder, "--error", "1000"]
        log = {"RIMPACT_FE_PROGRAM": STAND_IN, "STAND_IN_LOG": self.path("calls")}

        def calls():
            with open(self.path("calls"), encoding="utf-8") as file:
                return len(file.read().splitlines())

        rimpact(*study, **log)
        self.assertEqual(calls(), 2)
        run = rimpact(*study, **log)
        self.assertEqual((calls(), run.stderr.count("already done, kept")), (2, 2), run.stderr)
        self.record_case(0.2)
        run = rimpact(*study, **log)
        self.assertEqual((calls(), run.stderr.count("q.csv changed since")), (4, 2), run.stderr)
        for job in ("rim-mesh1", "rim-mesh2"):
            summary = self.summary(os.path.join(self.folder, "runs", job))
            self.write(f"run/runs/{job}/summary.json", json.dumps({**summary, "identity": {**summary["identity"], "build": "another"}}))
        run = rimpact(*study, **log)
        self.assertEqual((calls(), run.stderr.count("another version of the program")), (6, 2), run.stderr)
        run = rimpact(*study, "--set", "load.mass_kg=90000", **log)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("load.mass_kg", run.stderr)

    def test_names_lead_nowhere_else(self):
        for name in ("..", "../../../x", "a/b", "."):
            path = self.write("t.toml", f'name = "{name}"\n[excitation]\nkind = "free"\ndisplacement_m = [0.1, 0]\nduration_s = 0.1\n')
            self.write("scene.toml", "# mine\n")
            for verb in ("reduced", "check", "run"):
                self.says(2, "name", arguments=[verb, path], cwd=self.place)
            with open(self.path("scene.toml"), encoding="utf-8") as file:
                self.assertEqual(file.read(), "# mine\n")
        path = self.write("t.toml", 'name = "a\\nb\\u001b[31m' + "x" * 300 + '"\n[excitation]\nkind = "free"\ndisplacement_m = [0.1, 0]\nduration_s = 0.1\n')
        self.says(0, arguments=["reduced", path], cwd=self.place)
        (made,) = os.listdir(self.path("results"))
        self.assertTrue(made.startswith("a_b_[31mxxx"), made)
        self.says(0, arguments=["reduced", os.path.join("results", made), "-o", "again"], cwd=self.place)  # what was written can be read

    def test_file_names_that_are_not_utf8(self):
        raw = os.fsencode(self.place) + b"/caf\xe9.toml"
        with open(raw, "wb") as file:
            file.write(b'[excitation]\nkind = "free"\ndisplacement_m = [0.1, 0]\nduration_s = 0.1\n')
        run = subprocess.run([RIMPACT, "check", raw, "--json"], capture_output=True)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn(b"UTF-8", run.stderr)
        with open(raw, "ab") as file:
            file.write(b"")
        with open(raw, "rb") as file:
            text = file.read()
        with open(raw, "wb") as file:
            file.write(b'name = "plain"\n' + text)
        out = os.fsencode(self.place) + b"/o\xe9"
        run = subprocess.run([RIMPACT, "reduced", raw, "-o", out, "--json"], capture_output=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        json.loads(run.stdout)
        run = subprocess.run([RIMPACT, "reduced", raw, "-o", out + b"-sweep", "--json", "--quiet", "--sweep", "excitation.scale=0.5:1:2"], capture_output=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        json.loads(run.stdout.decode())
        record = os.fsencode(self.place) + b"/q\xe9.csv"
        with open(record, "wb") as file:
            file.write(b"time_s,acceleration_g\n0,0\n0.5,0.1\n1.0,0\n")
        run = subprocess.run([RIMPACT, "motion", record, "--json"], capture_output=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        json.loads(run.stdout.decode())

    def test_damaged_results_are_one_sentence(self):
        self.says(0, arguments=[*WINDOW, "-o", self.folder])
        whole = self.summary()
        for change, needle in (({"status": 3}, "status"), ({"status": None}, "status"), ({"impacts": "X"}, "impacts"), ({"rung": 5}, "rung"), ({"n_impacts": []}, "n_impacts")):
            self.write("run/summary.json", json.dumps({**whole, **change}))
            self.says(3, "summary.json is damaged", needle, arguments=["calibrate", self.folder, "-o", self.path("fit")])
        self.write("run/summary.json", "{")
        self.says(3, "summary.json", arguments=["calibrate", self.folder, "-o", self.path("fit")])
        self.write("run/summary.json", json.dumps(whole))

        def damage(name, values):
            folder = self.path("damaged")
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(self.folder, folder)
            with h5py.File(os.path.join(folder, "response.h5"), "r+") as file:
                del file["response"][name]
                if values is not None:
                    file["response"][name] = values
            return folder

        with h5py.File(os.path.join(self.folder, "response.h5")) as file:
            time, force = file["response/time"][()], file["response/impact_x"][()]
        for name, values in (("time", time[:-1]), ("time", time[::-1]), ("time", np.zeros(0)), ("time", None), ("impact_x", force[:-3]), ("impact_x", np.full(len(time), np.nan)),
                             ("impact_x", force.reshape(1, -1)), ("impact_x", b"text"), ("displacement_x", None)):
            for verb in (["calibrate", damage(name, values), "-o", self.path("fit")], ["compare", damage(name, values), self.folder]):
                with self.subTest(field=name, verb=verb[0]):
                    self.says(3, arguments=verb)

    def test_a_response_reads_no_other_file(self):
        self.says(0, arguments=[*WINDOW, "-o", self.folder])
        path = os.path.join(self.folder, "response.h5")
        with h5py.File(path) as file:
            values = file["response/gap"][()]
        secret = self.path("secret.bin")
        values.tofile(secret)
        with h5py.File(self.path("other.h5"), "w") as file:
            file["gap"] = values
        for make in (lambda group: group.create_dataset("gap", (len(values),), "f8", external=[(secret, 0, values.nbytes)]),
                     lambda group: group.__setitem__("gap", h5py.ExternalLink(self.path("other.h5"), "gap"))):
            with h5py.File(path, "r+") as file:
                del file["response/gap"]
                make(file["response"])
            self.says(3, "/response/gap", arguments=["compare", self.folder, self.folder])

    def test_what_would_hang_or_fill_the_memory_is_refused(self):
        fifo = self.path("fifo.toml")
        os.mkfifo(fifo)
        self.write("sweep.toml", '[records]\nfolder = "records"\ncomponents = "x"\nsa_period_s = 1e-9\n[grid]\nexcitation.scale = [1.0]\n')
        for needle, arguments in (("pipe", ["check", fifo]), ("cannot be read", ["check", "/proc/self/mem"]),
                                  ("period_s", ["reduced", "ricker-0.78g-1.0s", "--set", "excitation.period_s=1e-300"]),
                                  ("output_step_ms", [*WINDOW, "--set", "reduced.output_step_ms=1e-300"]),
                                  ("output_step_ms", ["reduced", "ricker-0.78g-1.0s", "--set", "reduced.output_step_ms=1e-4"]),
                                  ("duration_s", ["run", "impact-window", "--set", "excitation.duration_s=1e-13"]),
                                  ("elastic_slip_mm", [*WINDOW, "--set", 'reduced.friction="park-wen"', "--set", "reduced.elastic_slip_mm=1e-4"]),
                                  ("sa_period_s", ["reduced", "ricker-0.78g-1.0s", "--sweep", self.path("sweep.toml")]),
                                  ("--nodes", [*WINDOW, "--nodes", "nan,1"])):
            with self.subTest(needle):
                self.says(2, needle, arguments=[*arguments, *(["-o", self.folder] if arguments[0] != "check" else [])])

    def test_closed_streams_do_not_abort(self):
        run = subprocess.run(["bash", "-c", f"'{RIMPACT}' reduced impact-window -o '{self.folder}' >&- 2>&-"])
        self.assertIn(run.returncode, (0, 6))
        self.assertEqual(self.summary()["status"], "done")
        run = subprocess.run(["bash", "-c", f"'{RIMPACT}' reduced nowhere >&- 2>&-"])
        self.assertEqual(run.returncode, 2)


if __name__ == "__main__":
    unittest.main()
