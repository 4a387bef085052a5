#!/usr/bin/env python3
"""The reduced model against the kept curves of rung rigid-dish, each from its own start: with the law fitted to these curves (data/references/elastoplastic.json),
and with the law of rung rim on the pad's spring (rim.json), which has seen none of them.

law_against_curves.py RIMPACT [--check]: prints the table kept as law_against_curves.txt; --check fails where an error has moved by more than 0.2 of a per cent.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
REFERENCES, KEPT = ROOT / "data/references", pathlib.Path(__file__).with_suffix(".txt")
HEAD = "curve               in m/s  peak kN  deep mm  out m/s | law: peak %  rebound %  displacement % | rim: peak %  rebound %  displacement %"


def settings(name):
    law = json.loads((REFERENCES / f"{name}.json").read_text(encoding="utf-8"))
    return [word for key, value in law.items() for word in ("--set", f"{key}={json.dumps(value)}")]


def compared(rimpact, curve, name):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([rimpact, "reduced", curve / "scene.toml", "-o", folder, "--quiet", *settings(name)], capture_output=True, check=True)
        done = subprocess.run([rimpact, "compare", curve, folder, "--json", "--quiet"], capture_output=True, text=True, check=True)
    law = json.loads(done.stdout)
    return f"     {100 * law['peak_force_error']:+7.2f}    {100 * law['rebound_error']:+7.2f}         {100 * law['nrmse_displacement']:7.2f}"


def row(rimpact, curve):
    impact = json.loads((curve / "summary.json").read_text(encoding="utf-8"))["impacts"][0]
    laws = " |".join(compared(rimpact, curve, name) for name in ("elastoplastic", "rim"))
    return (impact["approach_speed_m_s"], f"{curve.name:18}  {impact['approach_speed_m_s']:6.3f}  {impact['peak_force_N'] / 1e3:7.1f}  {1e3 * impact['peak_penetration_m']:7.2f}  "
            f"{impact['rebound_speed_m_s']:7.4f} |{laws}")


def errors(table):
    return [[float(x) for x in re.findall(r"[-+]?\d+\.\d+", line.partition("|")[2])] for line in table.splitlines()[1:]]


def main(rimpact, *options):
    rows = sorted(row(rimpact, curve) for curve in REFERENCES.iterdir() if curve.is_dir())
    table = "\n".join([HEAD] + [text for _, text in rows]) + "\n"
    if "--check" not in options:
        print(table, end="")
        return 0
    moved = [f"{a} {b}" for a, b in zip(errors(KEPT.read_text(encoding="utf-8")), errors(table), strict=True) if max(abs(x - y) for x, y in zip(a, b)) > 0.2]
    print("\n".join(moved) or "the law errs on every curve as the table says")
    return 1 if moved else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
