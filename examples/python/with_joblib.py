#!/usr/bin/env python3
"""Peak rim force over speed and stiffness, runs side by side by joblib: scenes are pickled whole, so that workers need no file.

    with_joblib.py [JOBS]"""
import sys

import rimpact
from joblib import Parallel, delayed

SPEEDS, STIFFNESSES = (0.1, 0.2, 0.4), (3e5, 9e5)  # m/s, kN/m


def main(jobs: int) -> None:
    scenes = [rimpact.Scene("impact-window", {"excitation.speed_m_per_s": v, "reduced.k_i_kN_per_m": k}) for v in SPEEDS for k in STIFFNESSES]
    summaries = Parallel(n_jobs=jobs)(delayed(rimpact.summarise)(scene) for scene in scenes)
    for scene, summary in zip(scenes, summaries):
        print(f"{scene['excitation.speed_m_per_s']} m/s, {scene['reduced.k_i_kN_per_m']:.0f} kN/m: {summary['peak_impact_force_N'] / 1e3:.1f} kN")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
