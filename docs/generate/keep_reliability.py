#!/usr/bin/env python3
"""Keeps the summary of a reliability study for docs/results/reliability.md: keep_reliability.py RESULTS_FOLDER NAME "WHAT IT IS" LIMITS.

From RESULTS_FOLDER/reliability.json to data/reliability/kept/NAME.json: counts, levels, and reductions at the LIMITS ("0.3,0.4,1,10"). No record
and no path goes along.
"""
import json
import pathlib
import sys
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEPT = ("years", "period_s", "n_systems", "keys", "samples", "n_runs", "n_runs_without_result", "levels", "hazard", "confidence", "replicates",
        "differences")


def main(folder: str, name: str, what: str, limits: str) -> None:
    summary = json.loads(pathlib.Path(folder, "reliability.json").read_text(encoding="utf-8"))
    kept: dict[str, Any] = {"study": name, "what": what, **{key: summary[key] for key in KEPT}}
    wanted = {float(limit) for limit in limits.split(",")}
    kept["differences"] = [row for row in kept["differences"] if row["limit"] in wanted]
    target = ROOT / "data" / "reliability" / "kept" / f"{name}.json"
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
