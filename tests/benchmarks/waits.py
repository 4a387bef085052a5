#!/usr/bin/env python3
"""What a user waits for: commands as they are typed, alone on the machine, elapsed beside processor time.

    waits.py RIMPACT [--rows NAME,...] [--work FOLDER] [--write FILE] [--list]

The main job, its fits and its report, then rows of runs.py with the ranks that the program chooses. Counts are the same on every machine, seconds are this one's.
"""
import argparse
import json
import pathlib
import tempfile

import runs

HEAD = f"{'row':32s} elapsed s    cpu s  steps  Newton   GMRES factor  force kN rebound  imbalance"


JOBS = ("main", "calibrate", "report")


def command(name: str, program: str, work: pathlib.Path) -> list[str]:
    """Of a row; fits and report read what the main job left."""
    if name == "main":
        return [program, "main", "--force", "-o", str(work / "main")]
    if name == "calibrate":
        return [program, "calibrate", *map(str, sorted((work / "main" / "runs").glob("window-*"))), "-o", str(work / "calibration")]
    if name == "report":
        return [program, "report", str(work / "main")]
    return runs.command_of(program, runs.ROWS[name], str(work / name))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rows", default="main,calibrate,report,window-rim-mesh-1")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path)
    options, names = runs.rows_asked(parser, [*JOBS, *runs.ROWS])
    text = [HEAD]
    print(HEAD, flush=True)
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or pathlib.Path(temporary)
        for name in names:
            elapsed, cpu = runs.timed(command(name, options.program, work))
            text.append(f"{name:32s} {elapsed:9.1f} {cpu:8.1f}")
            if name in runs.ROWS:
                summary = json.loads((work / name / "summary.json").read_text())
                text[-1] += f" {runs.counts(summary)} {runs.answer(summary)}"
            print(text[-1], flush=True)
            if options.write:
                options.write.write_text("\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
