"""References made again: what a program's runs give is held against what is kept, and a stopped one is said. The program is a stand-in."""
import json
import os
import shutil
import signal
import stat
import threading

from support import InFolder, in_process

from report.child import run_child
from report.errors import DataError, InputError
from report.references import keep
from report.references.kept import chosen, references

PROGRAM = """#!/bin/sh
if [ "$1" = run ]; then
  shift; scene=$1; shift 2
  case "$scene" in *{stops}*) exit 4;; esac
  mkdir -p "$1"; cp "$(dirname "$scene")"/* "$1"; echo "$@" >> "$1/words"
else
  echo '{{"peak_force_error": 0.01, "rebound_error": -0.02, "touch_time_difference_s": null, "notes": []}}'
fi
"""


class References(InFolder):
    def program(self, stops="nothing"):
        path = os.path.join(self.folder, "program")
        with open(path, "w", encoding="utf-8") as file:
            file.write(PROGRAM.format(stops=stops))
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
        return path

    def made(self, *names, stops="nothing", json_too=True):
        return in_process("report.references", "--program", self.program(stops), "--output", os.path.join(self.folder, "out"), "--quiet",
                          *(["--json"] if json_too else []), "--", *names)

    def test_each_is_made_and_held_against_what_is_kept(self):
        run = self.made("window-0.20", "window-0.07", "window-0.20")
        self.assertEqual(run.returncode, 0, run.stderr)
        rows = json.loads(run.stdout)
        self.assertEqual([row["name"] for row in rows], ["window-0.20", "window-0.07"])
        self.assertEqual([row["peak_force_error"] for row in rows], [0.01, 0.01])
        self.assertEqual(rows[0]["peak_impact_force_N"], rows[0]["kept_peak_impact_force_N"])
        with open(os.path.join(self.folder, "out", "references.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file), rows)
        self.assertIn("+1.00 %", self.made("window-0.20", json_too=False).stdout)

    def test_a_second_call_goes_on_where_the_first_was(self):
        self.made("window-0.20")
        self.made("window-0.20")
        with open(os.path.join(self.folder, "out", "window-0.20", "words"), encoding="utf-8") as file:
            self.assertEqual(["--resume" in line for line in file], [False, True])

    def test_a_run_that_stops_is_said_and_the_others_are_made(self):
        run = self.made("window-0.20", "window-0.07", stops="window-0.20")
        self.assertEqual(run.returncode, 4)
        self.assertEqual([row["problem"] for row in json.loads(run.stdout)], ["its run ended with 4", ""])
        self.assertIn("its run ended with 4", self.made("window-0.20", stops="window-0.20", json_too=False).stdout)

    def test_an_interrupt_is_passed_on_and_waited_for(self):
        heard = os.path.join(self.folder, "heard")
        program = ["sh", "-c", f"trap 'sleep 0.2; echo heard > {heard}; exit 130' INT; while :; do sleep 0.02; done"]
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            run_child(program)
        self.assertTrue(os.path.isfile(heard))  # it had ended

    def test_names_are_those_kept(self):
        known = references()
        self.assertEqual(chosen([], known), known)
        with self.assertRaisesRegex(InputError, "did you mean window-0.20"):
            chosen(["window-0.2"], known)

    def test_what_is_no_reference_is_not_kept(self):
        folder = os.path.join(self.folder, "run")
        shutil.copytree(references()[0].folder, folder)
        path = os.path.join(folder, "summary.json")
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
        for change in ({"status": "stopped"}, {"impacts": []}, {"energy": {"imbalance_relative": 2e-3}}):
            with open(path, "w", encoding="utf-8") as file:
                json.dump(summary | change, file)
            with self.assertRaisesRegex(DataError, "is no reference"):
                keep.keep(folder, os.path.join(self.folder, "kept"))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "kept")))
