#!/usr/bin/env python3
"""Keeps the summary of a reliability study for docs/results/reliability.md: keep_reliability.py RESULTS_FOLDER NAME "WHAT IT IS" LIMITS [KEYS].

From RESULTS_FOLDER/reliability.json to data/reliability/kept/NAME.json: counts, levels, and reductions at the LIMITS ("0.3,0.4,1,10"); with KEYS
("case,device,variable.R_I") also from its reliability.csv to kept/curves/NAME.json, which the thesis's figures are drawn of: every system's
probabilities, the system told by these keys. No record and no path goes along.
"""
import json
import pathlib
import sys
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
from report.reliability.tables import read  # noqa: E402

KEPT = ("years", "period_s", "n_systems", "keys", "samples", "n_runs", "n_runs_without_result", "levels", "hazard", "confidence", "replicates",
        "differences")


def main(folder: str, name: str, what: str, limits: str, keys: str = "") -> None:
    summary = json.loads(pathlib.Path(folder, "reliability.json").read_text(encoding="utf-8"))
    kept: dict[str, Any] = {"study": name, "what": what, **{key: summary[key] for key in KEPT}}
    wanted = {float(limit) for limit in limits.split(",")}
    kept["differences"] = [row for row in kept["differences"] if row["limit"] in wanted]
    target = ROOT / "data" / "reliability" / "kept" / f"{name}.json"
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
    if keys:
        drawn = target.parent / "curves" / target.name
        drawn.parent.mkdir(exist_ok=True)
        drawn.write_text(curves(folder, name, keys.split(",")), encoding="utf-8")


def curves(folder: str, name: str, keys: list[str]) -> str:
    """JSON, one line a system: probabilities with five digits."""
    limits: dict[str, list[float]] = {}
    systems: dict[float, dict[str, Any]] = {}
    for row in read(folder, "reliability"):
        quantity, limit, probability = row["quantity"], row["limit"], row["probability"]
        if limit not in limits.setdefault(quantity, []):
            limits[quantity].append(limit)
        system = systems.setdefault(row["system"], {"of": {key: row[key] for key in keys}})
        system.setdefault(quantity, []).append(None if probability is None else float(f"{probability:.5g}"))
    lines = ",\n".join(json.dumps(system) for system in systems.values())
    return f'{{"study": {json.dumps(name)}, "limits": {json.dumps(limits)}, "systems": [\n{lines}\n]}}\n'


if __name__ == "__main__":
    main(*sys.argv[1:])
