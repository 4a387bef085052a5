"""rimpact thesis: what takes seconds is made anew, and its numbers are those kept with the program; done runs are not made twice."""
import glob
import json
import os
import signal
import subprocess
import unittest

from command import RIMPACT, rimpact
from thesis_numbers import RECORDS, Numbers

from report.thesis import catalogue as catalogues


def words_of(path):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:  # it has ended
        return ""


class Thesis(Numbers):
    def test_what_needs_no_record(self):
        n = sum(self.holds(what) for what in ("fig-2-3", "fig-2-4", "fig-2-24", "fig-3-5", "fig-4-1", "fig-A-2", "fig-B-2", "design", "table-2-1", "table-2-3",
                                              "table-4-1"))
        self.assertGreater(n, 30)
        for name in ("fig-2-3", "fig-2-24", "fig-B-2"):
            self.assertTrue(os.path.isfile(os.path.join(self.folder, "figures", f"{name}.png")))
            self.assertTrue(os.path.isfile(os.path.join(self.folder, f"{name}.html")))

    def test_pulses_over_the_kept_finite_elements(self):
        for what in ("fig-2-7", "fig-2-8"):
            made = self.made(what)["entries"][0]
            self.assertEqual([sentence for sentence in made["missing"] if "--cheap" not in sentence], [])
            self.assertTrue(os.path.isfile(made["picture"]))

    def test_done_runs_are_kept(self):
        self.made("fig-3-5")
        path = os.path.join(self.folder, "runs", "stages", "response.h5")
        before = os.stat(path).st_mtime_ns
        self.made("fig-3-5")
        self.assertEqual(os.stat(path).st_mtime_ns, before)

    @unittest.skipUnless(os.path.isfile(os.path.join(RECORDS, "RSN1044_NORTHR_NWH360.AT2")), "the records are not here (RIMPACT_RECORDS)")
    def test_what_needs_records(self):
        self.assertEqual(sum(self.holds(f"table-3-{k}", RECORDS) for k in range(2, 8)), 162)
        for what in ("table-3-1", "slider-slip", "fig-4-4", "fig-2-32"):
            self.assertGreater(self.holds(what, RECORDS), 0, what)

    @unittest.skipUnless(os.path.isfile(os.path.join(RECORDS, "RSN1044_NORTHR_NWH360.AT2")), "the records are not here (RIMPACT_RECORDS)")
    def test_no_command_of_a_building_is_refused(self):
        """Each one's first instants: whole, they are in the slow suite."""
        runs = [run for run in catalogues.load().runs.values() if run.command[:1] == ["building"]]
        self.assertGreater(len(runs), 8)
        for run in runs:
            words = [word.replace("{records}", os.path.abspath(RECORDS)) for word in run.command]
            with self.subTest(run.name):
                done = rimpact(*words, "--set", "excitation.duration_s=0.02", "--quiet", "-o", os.path.join(self.folder, run.name))
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_thesis_s_own_results(self):
        listed = json.loads(rimpact("thesis", "headlines", "--json").stdout)
        self.assertEqual(len(listed), 13)
        text = rimpact("thesis", "headlines").stdout
        for row in listed:
            self.assertIn(row["verdict"], ("met", "not met"))
            self.assertIn(row["headline"], text)

    def test_an_interrupt_ends_what_it_started(self):
        """The command alone hears it: its Python and that one's runs end before it does."""
        place = os.path.join(self.folder, "interrupted")
        process = subprocess.Popen([RIMPACT, "thesis", "fig-2-24", "-o", place], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        for line in process.stderr:  # its first run begins
            if line.startswith("loop-"):
                break
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertNotIn("Traceback", said)
        self.assertEqual([name for name in glob.glob("/proc/[0-9]*/cmdline") if place in words_of(name)], [])

    def test_an_unknown_figure_is_a_usage_error(self):
        run = rimpact("thesis", "fig-9-9", "-o", self.folder)
        self.assertEqual(run.returncode, 2)
        self.assertIn("fig-9-9", run.stderr)


if __name__ == "__main__":
    unittest.main()
