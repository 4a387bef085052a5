"""A results folder as `rimpact main` leaves it, for the tests of the report ONLY: nothing in it is a result.
`python3 synthetic_results.py DIR` writes one to look at."""
import json
import os
import sys
from collections.abc import Sequence
from typing import Any

import synthetic
from synthetic_calibration import SPEEDS, answer, calibration, estimate
from synthetic_mesh import write_vtu

PULSES = ((0.78, 1.0), (0.38, 1.5))


def main_folder(folder: str, pulses: Sequence[tuple[float, float]] = PULSES, speeds: Sequence[float] = SPEEDS) -> None:
    """Pulses at three scales, windows, a calibration: everything `rimpact main` leaves."""
    jobs = [(f"ricker-{a:g}g-{T:.1f}s" + (f"-x{s:.2f}" if s != 1 else ""), a, T, s, "predict" if s == 1 else "fit")
            for a, T in pulses for s in (1.0, 1.05, 1.10)]
    entries = list[dict[str, str]]()
    for name, a, T, scale, role in jobs:
        text = f'kind = "ricker"\nscale = {scale}\namplitude_g = {a}\nperiod_s = {T}\ncentre_s = {2 * T}'
        _trio(folder, name, text, synthetic.ricker((1.10 if T < 1.2 else 1.14) * a * scale, T))
        entries.append({"name": name, "role": role, "fe": f"runs/{name}", "reduced": f"reduced/{name}"})
    windows = []
    for v in speeds:
        name = f"window-{v:.2f}"
        fe = _trio(folder, name, f'kind = "window"\nscale = 1.0\nspeed_m_per_s = {v}', lambda t: 0.0, v)
        entries.append({"name": name, "role": "window", "fe": f"runs/{name}", "reduced": f"reduced/{name}"})
        e = fe["impacts"][0]["restitution"]
        windows.append({"folder": f"runs/{name}", "speed_m_s": v, "restitution": e, "pair_force_error": 0.5 * (v - 0.25),
                        "parameters": {"k_i": estimate(5.2e5 * (1 - 0.5 * v), 0.02, "kN/m"),
                                       "e": estimate(e, 0.015, "-")}})
    calibration(folder, windows, answer(speeds))
    with open(os.path.join(folder, "main.json"), "w", encoding="utf-8") as file:
        json.dump({"runs": entries, "totals": {"wall_time_s": 402.0, "peak_memory_bytes": 1.4e9},
                   "versions": {"rimpact": "0.1.0-synthetic", "deal.II": "9.4.1"}, "machine": {"cores": 2},
                   "warnings": ["synthetic data: nothing in this folder is a result"]}, file, indent=1)


def _trio(folder: str, name: str, excitation: str, motion: synthetic.Motion, speed: float | None = None) -> dict[str, Any]:
    summary = synthetic.run(f"{folder}/runs/{name}", name, excitation, motion, synthetic.Rim(4.9e8, 0.72, 2.2e6, 0.25), "rim", speed)
    synthetic.run(f"{folder}/reduced/{name}", name, excitation, motion, synthetic.Rim(4.1e8, 0.62), "reduced", speed)
    synthetic.run(f"{folder}/law/{name}", name, excitation, motion, synthetic.Rim(6.0e8, 0.75, 2.0e6, 0.25), "reduced", speed, law="elastoplastic")
    synthetic.run(f"{folder}/reduced/{name}-published", name, excitation, motion, synthetic.Rim(4.5e8, 0.65), "reduced", speed)
    os.makedirs(f"{folder}/runs/{name}/fields", exist_ok=True)
    write_vtu(f"{folder}/runs/{name}/fields/rim-0001.vtu", max(1e-6, summary["max_plastic_strain"]))
    return summary


if __name__ == "__main__":
    main_folder(sys.argv[1])
