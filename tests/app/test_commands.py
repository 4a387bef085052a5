"""The command as a whole: unknown words, terminals, places it cannot write, data it cannot read; the head of a report."""
import os
import subprocess
import tempfile
import unittest

from command import RIMPACT, Refusals, in_terminal, rimpact


class Commands(Refusals):
    def test_unknown_verb_and_option(self):
        self.refused(2, "did you mean \"run\"", arguments=["runn"])
        self.refused(2, "did you mean --json", arguments=["check", "ricker-0.78g-1.0s", "--jsn"])
        self.refused(2, "--fast", arguments=["check", "ricker-0.78g-1.0s", "--fast"])
        self.refused(2, arguments=[])

    def test_a_terminal_gets_colours_unless_told_not_to(self):
        self.assertIn("\033[31m", in_terminal("check", "nowhere.toml"))
        self.assertNotIn("\033", in_terminal("check", "nowhere.toml", NO_COLOR="1"))
        self.assertNotIn("\033", rimpact("check", "nowhere.toml").stderr)

    def test_unwritable_places(self):
        for arguments in (["reduced", "impact-window", "-o", "/proc/nowhere"], ["new", "/proc/nowhere"]):
            self.refused(6, "/proc/nowhere", arguments=arguments)
        with open("/dev/full", "w") as full:
            run = subprocess.run([RIMPACT, "list"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(run.returncode, 6, run.stderr)

    def test_unreadable_data(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "response.h5")
            with open(path, "wb") as file:
                file.write(b"\x89HDF\r\n\x1a\n and then nothing")
            self.refused(3, "response.h5", arguments=["compare", path, path])
            self.refused(3, folder, arguments=["export", folder, "--opensees"])
            self.assertEqual(rimpact("report", folder).returncode, 3)
            self.assertEqual(rimpact("calibrate", folder).returncode, 3)

    def test_a_report_takes_its_head_and_says_where_no_pdf_can_be_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            run = os.path.join(folder, "run")
            self.assertEqual(rimpact("reduced", "impact-window", "-o", run).returncode, 0)
            document = os.path.join(folder, "d.toml")
            with open(document, "w", encoding="utf-8") as file:
                file.write('client = "Acme & Co"\nproject = "R3"\n')
            made = rimpact("report", run, "--title", "--odd <title>", "--document", document, "--pdf", PATH="/nowhere")
            self.assertEqual((made.returncode, made.stdout), (0, os.path.join(run, "report.html") + "\n"))
            self.assertRegex(made.stderr, r"no PDF: none of chromium, .* Open .*report\.html in a browser")
            with open(os.path.join(run, "report.html"), encoding="utf-8") as file:
                page = file.read()
            for said in ("--odd &lt;title&gt;", "Acme &amp; Co", "R3"):
                self.assertIn(said, page)
            with open(document, "w", encoding="utf-8") as file:
                file.write('clinet = "x"\n')
            self.refused(2, 'd.toml: unknown key "clinet"; did you mean "client"?', arguments=["report", run, "--document", document])
            self.refused(6, "/dev/full", arguments=["report", run, "-o", "/dev/full"])


if __name__ == "__main__":
    unittest.main()
