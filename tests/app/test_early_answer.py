"""The main job's answer while its runs come in, with a stand-in for the finite elements (stand_in_fe.py)."""
import json
import os
import tempfile
import unittest

from command import rimpact

STAND_IN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stand_in_fe.py")
SPREAD = ["window-1.00", "window-0.05", "window-0.20", "window-0.10", "window-0.35", "window-0.60"]
BY_SPEED = ["window-1.00", "window-0.60", "window-0.35", "window-0.20", "window-0.10", "window-0.05"]


def read(*path):
    with open(os.path.join(*path)) as file:
        return json.load(file)


class EarlyAnswer(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder, self.log = os.path.join(temporary.name, "main"), os.path.join(temporary.name, "calls")

    def main(self, *words, laws="signed", report=False, **more):
        words = (*words, *([] if report else ["--no-report"]))
        return rimpact("main", *words, "--laws", laws, "--jobs", "1", "-o", self.folder, RIMPACT_FE_PROGRAM=STAND_IN, STAND_IN_LOG=self.log, **more)

    def order(self):
        with open(self.log) as file:
            return [os.path.basename(line.split()[line.split().index("-o") + 1]) for line in file]

    def test_windows_come_first_spread_over_the_speeds_and_answer_from_three_on(self):
        run = self.main()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.order()[:6], SPREAD)
        self.assertTrue(all(name.startswith("ricker") for name in self.order()[6:]))
        lines = run.stderr.splitlines()
        answers = [k for k, line in enumerate(lines) if line.startswith("after ")]
        self.assertEqual([lines[k].split(":")[0] for k in answers], ["after 3 windows", "after 6 windows"])
        self.assertTrue(lines[answers[0] - 1].startswith("window-0.20"), lines[answers[0] - 1])
        self.assertIn("from 0.05 to 1 m/s", lines[answers[0]])
        table = [row["name"] for row in read(self.folder, "main.json")["runs"]]
        self.assertEqual(table[6:], BY_SPEED)  # tables have the pulses, then the windows by speed
        self.assertIsNone(read(self.folder, "main.json")["until"])

    def test_until_leaves_runs_out_and_without_it_they_are_made(self):
        run = self.main("--until", "5%", report=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.order(), SPREAD[:3])
        main = read(self.folder, "main.json")
        self.assertEqual(main["until"]["asked_percent"], 5)
        self.assertLess(main["until"]["reached_percent"], 1)  # the stand-in has the law that is fitted
        self.assertEqual(len(main["until"]["left_out"]), 9)
        self.assertEqual([row["name"] for row in main["runs"]], ["window-1.00", "window-0.20", "window-0.05"])
        self.assertIn("9 runs are left out by --until", " ".join(main["warnings"]))
        with open(os.path.join(self.folder, "report.html")) as file:
            self.assertIn("9 runs are left out by --until", file.read())
        again = self.main()
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stderr.count("already done, kept"), 3)
        self.assertEqual(len(read(self.folder, "main.json")["runs"]), 12)

    def test_an_error_that_is_not_reached_makes_every_run(self):
        run = self.main("--until", "1e-9", "--windows-only", laws="no-tension")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.order(), SPREAD)
        self.assertEqual([line.split(":")[0] for line in run.stderr.splitlines() if line.startswith("after ")],
                         ["after 3 windows", "after 4 windows", "after 5 windows"])  # with six the job itself answers
        until = read(self.folder, "main.json")["until"]
        self.assertEqual((until["left_out"], read(self.folder, "main.json")["warnings"]), ([], []))
        self.assertGreater(until["reached_percent"], 1e-9)

    def test_the_twins_of_windows_left_out_are_left_out(self):
        own = os.path.join(os.path.dirname(self.log), "own.toml")
        with open(own, "w") as file:
            file.write('name = "own"\n[slider]\ndiameter_mm = 200.0\n[rim]\nthickness_mm = 50.0\n')
        run = self.main(own, "--windows-only", "--speeds", "0.1,0.15,0.2,0.25,0.4", "--until", "5")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.order(), ["window-0.40", "window-0.10", "window-0.20", "window-0.40-fast", "window-0.20-fast", "window-0.10-fast"])
        self.assertEqual(len(read(self.folder, "calibration", "calibration.json")["answer"]["steel_band"]["rows"]), 3)

    def test_an_error_that_cannot_be_had_is_refused(self):
        refused = (("0", "signed", "--until 0 must be"), ("101%", "signed", "--until 101% must be"), ("five", "signed", "--until five must be"), ("5%", "none", "--laws none"))
        for words, laws, said in refused:
            run = self.main("--until", words, laws=laws)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)
            self.assertFalse(os.path.exists(self.log))


if __name__ == "__main__":
    unittest.main()
