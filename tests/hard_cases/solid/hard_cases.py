#!/usr/bin/env python3
"""Hard cases of a finite-element rung: what became of each, its energy imbalance, steps, cuts and iterations. Rows with * must
come out right, that is: the expected status within half an hour, an imbalance below 1e-3 of the input, and what the row's own check asks. A case
that fails stays in the table, as failing. Runs kept in FOLDER are not repeated (see kept_run.py).
RUNG rim-rate, rigid-dish-rate, full-rate: those of that rung with steel that knows its rate; double-concave, double-concave-dish:
rungs rim and rigid-dish with a slider between two dishes. A case is a name, whether it must be right, (scene, settings), the expected
exit code, and a check of the summary, or words of the sentence where the code is not 0.
usage: hard_cases.py RUNG RIMPACT FOLDER [part of a case's name]"""
import importlib
import json
import pathlib
import signal
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "verification"))
from kept_run import command, is_kept  # noqa: E402

IMBALANCE = 1e-3
CASES = {"rim": "cases_rim", "rim-rate": "cases_rim_rate", "double-concave": "cases_double_concave",
         "double-concave-dish": "cases_double_concave_dish", "rigid-dish": "cases_stack", "full": "cases_stack",
         "rigid-dish-rate": "cases_stack_rate", "full-rate": "cases_stack_rate"}
BETWEEN_TWO_DISHES = {"double-concave": "rim", "double-concave-dish": "rigid-dish"}
LONGEST = 1800  # [s]


class Table:
    def __init__(self, rung, mesh, program, folder):
        self.options = ["--no-fields", "--rung", BETWEEN_TWO_DISHES.get(rung, rung.removesuffix("-rate")), "--set", f"model.mesh={mesh}"]
        self.program, self.folder, self.summaries = program, folder, {}

    def run(self, name, scene, settings):
        folder = self.folder / "".join(c if c.isalnum() else "_" for c in name)
        summary, verdict = folder / "summary.json", folder / "exit.txt"
        if not (verdict.exists() and is_kept(verdict, self.program)):
            code, said = self.solve(command(self.program, "run", scene, folder, settings, self.options))
            folder.mkdir(parents=True, exist_ok=True)
            verdict.write_text(f"{code}\n{said.splitlines()[-1] if said else ''}\n")
        code, sentence = verdict.read_text().split("\n")[:2]
        self.summaries[name] = json.loads(summary.read_text()) if summary.exists() else {}
        return int(code), sentence, self.summaries[name]

    @staticmethod
    def solve(words):
        """Exit code and what was said; a run that takes too long is interrupted, and so has failed."""
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            _, said = process.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            _, said = process.communicate()
        return process.returncode, said.strip()

    def row(self, name, starred, what, expected, check):
        code, sentence, s = self.run(name, *what)
        imbalance = abs(s.get("energy", {}).get("imbalance_relative", 0))
        wrong = []
        if code != expected:
            wrong.append(f"exit code {code}, not {expected}")
        elif code == 0:
            if not imbalance < IMBALANCE:
                wrong.append(f"imbalance {imbalance:.1e}")
            if check and not check(s, self.summaries.get):
                wrong.append("its check fails")
        if code != 0 and (check if isinstance(check, str) else "error:") not in sentence:
            wrong.append("another sentence")
        figures = (f"{len(s.get('impacts', [])):3d} {1e-3 * (s.get('peak_impact_force_N') or 0):9.1f} {imbalance:9.1e} "
                   f"{s.get('n_steps', 0):6d} {s.get('cuts', 0):4d} {s.get('n_newton_iterations', 0):6d} "
                   f"{s.get('wall_time_s', 0):7.0f}" if s else " " * 50)
        outcome = "FAILS" if wrong else ("right" if code == 0 else "refused" if code == 2 else "stopped")
        return bool(wrong), (f"{name + (' *' if starred else ''):38s} {outcome:8s} {figures} "
                             f"{'; '.join(wrong + ([sentence] if code else []))}").rstrip()


def main(rung, program, folder, only=""):
    scenes = importlib.import_module(CASES[rung])
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    table, lines, failed = Table(rung, scenes.MESH, program, folder), [], []
    header = (f"{'# case':38s} {'outcome':8s} hit   peak_kN imbalance  steps cuts newton seconds\n")
    for name, starred, what, expected, check in scenes.cases(program, folder):
        if only not in name and not name.startswith("reference"):
            continue
        wrong, line = table.row(name, starred, what, expected, check)
        lines.append(line)
        print(line, flush=True)
        if wrong and starred:
            failed.append(name)
    of = f"{BETWEEN_TWO_DISHES[rung]}, two dishes" if rung in BETWEEN_TWO_DISHES else rung
    text = (f"# Hard cases of rung {of}, mesh {scenes.MESH}; rows with * must be right. Made by hard_cases.py.\n" + header
            + "\n".join(lines) + "\n" + scenes.NOTES)
    if not only:
        (folder / "table.txt").write_text(text)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
