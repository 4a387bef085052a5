#!/usr/bin/env python3
"""The same peaks by dask: on the cores of this machine, or on a cluster whose scheduler's address is given (it needs the package on every
worker).

    with_dask.py [ADDRESS]"""
import sys

import dask
import rimpact
from with_joblib import SPEEDS, STIFFNESSES


@dask.delayed
def peak(scene: rimpact.Scene) -> float:
    """Peak rim force [kN]."""
    return rimpact.summarise(scene)["peak_impact_force_N"] / 1e3


def main(address: str | None) -> None:
    scenes = [rimpact.Scene("impact-window", {"excitation.speed_m_per_s": v, "reduced.k_i_kN_per_m": k}) for v in SPEEDS for k in STIFFNESSES]
    asked = [peak(scene) for scene in scenes]
    if address:
        from dask.distributed import Client
        with Client(address):
            peaks = dask.compute(*asked)
    else:
        peaks = dask.compute(*asked, scheduler="processes", num_workers=2)
    for scene, force in zip(scenes, peaks):
        print(f"{scene['excitation.speed_m_per_s']} m/s, {scene['reduced.k_i_kN_per_m']:.0f} kN/m: {force:.1f} kN")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
