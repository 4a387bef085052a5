"""The way of a new user, from a drawing to what is typed into a building model, with the numbers asserted.

new -> check -> main -> report -> export for a bearing of the user's own (bearing.toml beside this file) and a load of the user's own
(3,200 kN). Three finite-element windows at speeds the fit has not seen judge what is handed over: the exported law must meet their
peak force within 5 % at 0.15 and 0.3 m/s. Page one is computed once more (page_one.py). Usage: walk.py RIMPACT FOLDER [--mesh N]; about 15 minutes on two cores."""
import argparse
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib

import page_one
from runs_again import read

HERE = os.path.dirname(os.path.abspath(__file__))
WEIGHT_KN, MASS_KG = 3200.0, 3200e3 / 9.81
FITTED = "0.05,0.1,0.2,0.4"
UNSEEN = (0.15, 0.3)
PEAK_TOLERANCE = 0.05
failures = []


def expect(truth, sentence):
    print(("ok      " if truth else "FAILED  ") + sentence, flush=True)
    if not truth:
        failures.append(sentence)


class Walk:
    def __init__(self, program, folder, mesh):
        self.program, self.folder, self.mesh = program, folder, mesh
        self.case = os.path.join(folder, "acme")
        self.main = os.path.join(folder, "main")

    def __call__(self, *words, code=0):
        run = subprocess.run([self.program, *words], capture_output=True, text=True, check=False)
        expect(run.returncode == code, f"rimpact {' '.join(words)[:110]}: exit {run.returncode}, {code} is due" +
               ("" if run.returncode == code else "\n" + run.stderr[-1500:]))
        return run

    def new(self):
        self("new", self.case, "--scene", "impact-window")
        shutil.copy(os.path.join(HERE, "bearing.toml"), os.path.join(self.case, "bearing.toml"))

    def check(self):
        run = self("check", f"{self.case}/scene.toml", "--set", f"load.vertical_kN={WEIGHT_KN}")
        for word in ("acme-r2500", "3200", "326"):
            expect(word in run.stdout, f"check names {word}")
        assumed = run.stdout.split("assumed", 1)[-1]
        expect("rim.height_mm" not in assumed, "the user's rim height is not called an assumption")
        expect("tangent_modulus_MPa" in assumed, "the tangent modulus, marked so, is called an assumption")
        run = self("check", f"{self.case}/scene.toml", "--set", f"load.vertical_kN={WEIGHT_KN}", "--set", "load.mass_kg=86952")
        expect("mass_kg" in run.stderr and "vertical_kN" in run.stderr, "a weight with another load's mass is remarked upon")

    def run_main(self):
        run = self("main", f"{self.case}/bearing.toml", "--set", f"load.vertical_kN={WEIGHT_KN}", "--windows-only", "--speeds", FITTED, "--set",
                   f"model.mesh={self.mesh}", "-o", self.main, "--title", "Walk", "--client", "ACME")
        table = read(self.main, "main.json")
        expect(abs(table["load"]["mass_kg"] / MASS_KG - 1) < 1e-9, f"main ran with {table['load']['mass_kg']:.0f} kg")
        answer = read(self.main, "calibration", "calibration.json")["answer"]
        expect(answer["bearing"] == "acme-r2500" and abs(answer["mass_kg"] / MASS_KG - 1) < 1e-9, "the answer is of this bearing and mass")
        expect(answer["published_applies"] is False, "the thesis's pair is not offered for another bearing")
        expect("4.5e5" not in run.stdout and "450000" not in run.stdout, "main prints no published pair")
        doubts = [(row["name"], doubt) for row in table["comparison"] for doubt in row.get("doubts", [])]
        for name, doubt in doubts:
            expect(doubt in run.stdout + run.stderr, f"the screen says of {name}: {doubt[:60]}")
        return answer, doubts

    def unseen(self):
        """Finite-element windows that no fit has seen, at the user's mass."""
        peaks = {}
        for speed in UNSEEN:
            folder = os.path.join(self.folder, f"unseen-{speed}")
            if not os.path.exists(os.path.join(folder, "summary.json")):
                self("run", f"{self.case}/scene.toml", "--quiet", "--set", f"load.vertical_kN={WEIGHT_KN}", "--set",
                     f"excitation.speed_m_per_s={speed}", "--mesh", self.mesh, "-o", folder)
            peaks[speed] = read(folder, "summary.json")
        return peaks

    def handed_over(self, unseen):
        """The law in calibration.toml, and by --calibration, flown at the unseen speeds."""
        with open(os.path.join(self.main, "calibration", "calibration.toml"), "rb") as file:
            typed = tomllib.load(file)["reduced"]
        ways = {"--calibration": ["--calibration", os.path.join(self.main, "calibration")],
                "typed from calibration.toml": [word for key, value in typed.items() for word in
                                                ("--set", f"reduced.{key}={json.dumps(value)}")]}
        for way, words in ways.items():
            for speed, summary in unseen.items():
                out = os.path.join(self.folder, "flown")
                shutil.rmtree(out, ignore_errors=True)
                self("reduced", f"{self.case}/scene.toml", "--set", f"load.vertical_kN={WEIGHT_KN}", "--set",
                     f"excitation.speed_m_per_s={speed}", *words, "-o", out)
                error = read(out, "summary.json")["peak_impact_force_N"] / summary["peak_impact_force_N"] - 1
                expect(abs(error) < PEAK_TOLERANCE, f"{way}: the law meets the peak at {speed} m/s within {100 * error:+.2f} %")
        out = os.path.join(self.folder, "plain")
        run = self("reduced", f"{self.case}/scene.toml", "--set", f"load.vertical_kN={WEIGHT_KN}", "-o", out)
        expect("450000" in run.stderr or "4.5e" in run.stderr, "without a calibration the thesis's pair is loudly said not to be this bearing's")

    def report(self, doubts):
        self("report", self.main, "--title", "Walk", "--client", "ACME")
        with open(os.path.join(self.main, "report.html"), encoding="utf-8") as file:
            page = file.read()
        told = re.sub(r"<(script|style)\b.*?</\1>", "", page.replace("&nbsp;", " "), flags=re.DOTALL)
        plain = re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", "", told)))
        for word in ("Walk", "ACME", "acme-r2500"):
            expect(word in plain, f"the report's head names {word}")
        for _, doubt in doubts:
            start = re.sub(r"\s+", " ", doubt)[:50]
            expect(start in plain, f"page one says: {start}")
        for met, said in page_one.checks(self.main):
            expect(met, said)
        expect("+-" not in plain and "`" not in plain, "no +- and no backticks are left in the report")

    def export(self, answer):
        for form in ("--opensees", "--csv", "--sap2000", "--etabs"):
            run = self("export", os.path.join(self.main, "calibration"), form)
            for path in run.stdout.split():
                if not os.path.isfile(path):
                    continue
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                expect("acme-r2500" in text, f"{os.path.basename(path)} names the bearing")
                expect(answer["law"]["name"] in text, f"{os.path.basename(path)} names the law {answer['law']['name']}")
                validity = re.sub(r"\W+", " ", answer["validity"])[:60]
                expect(validity in re.sub(r"\W+", " ", text), f"{os.path.basename(path)} holds the sentence of validity")

    def mistakes(self):
        """Wrong load, range, bearing and folder are each caught."""
        calibration = os.path.join(self.main, "calibration")
        out = os.path.join(self.folder, "mistake")
        run = self("reduced", "impact-window", "--calibration", calibration, "-o", out)
        expect("another" in run.stderr or "rim" in run.stderr, "another bearing's calibration is remarked upon")
        run = self("reduced", f"{self.case}/scene.toml", "--set", f"load.vertical_kN={WEIGHT_KN}", "--set", "excitation.speed_m_per_s=2.0",
                   "--calibration", calibration, "-o", out + "-fast")
        expect(read(out + "-fast", "summary.json")["beyond_fit"] is True, "a speed beyond the fit is flagged")
        expect("fit" in run.stderr, "and said")
        foreign = os.path.join(self.folder, f"unseen-{UNSEEN[0]}")
        self("reduced", "ricker-0.78g-1.0s", "-o", foreign, code=2)
        self("compare", foreign, out, code=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--mesh", default="1")
    given = parser.parse_args()
    os.makedirs(given.folder, exist_ok=True)
    walk = Walk(os.path.abspath(given.program), os.path.abspath(given.folder), given.mesh)
    if not os.path.isdir(walk.case):
        walk.new()
    walk.check()
    answer, doubts = walk.run_main()
    unseen = walk.unseen()
    walk.handed_over(unseen)
    walk.report(doubts)
    walk.export(answer)
    walk.mistakes()
    print(f"{len(failures)} expectation(s) not met")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
