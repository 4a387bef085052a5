#!/usr/bin/env python3
"""How the strain of a rim's steel converges, by its places: windows at 0.2 and 0.5 m/s on meshes 0, 1, 2 (rung rim).

Writes the largest plastic strain of a point, the averaged one and the damage, with their change to the next finer mesh. Gates: where the rim is
strained by more than 5 %, the averaged strain moves by less than 5 % from mesh 1 to 2; elsewhere by less than 0.005.

usage: steel_places.py RIMPACT FOLDER [MESHES]
"""
import pathlib
import sys

from kept_run import finish, kept_run

SPEEDS, PLACES = (0.2, 0.5), ("rim_wall", "rim_root", "dish", "slider_edge")
HEAD = "speed mesh place         largest  averaged  change_%  triaxiality  damage  seconds"
FROM = 0.05  #: strain from which a share is asked, not a difference


def steel(program, folder, speed, mesh):
    settings = [f"excitation.speed_m_per_s={speed}", "excitation.duration_s=0.06"]
    return kept_run(program, "run", "impact-window", folder / f"v{speed}_mesh{mesh}", settings, ["--mesh", str(mesh), "--no-fields"])


def missed(place, speed, coarse, fine):
    """Why the averaged strain of mesh 1 is not that of mesh 2; empty where it is."""
    far = abs(fine - coarse) > (0.05 * coarse if coarse > FROM else 0.005)
    return f"{place} at {speed} m/s: averaged {coarse:.4f} on mesh 1, {fine:.4f} on mesh 2" if far else ""


def main(program, folder, meshes=(0, 1, 2)):
    folder = pathlib.Path(folder)
    lines, failures = [HEAD], []
    for speed in SPEEDS:
        runs = {mesh: steel(program, folder, speed, mesh) for mesh in meshes}
        for place in PLACES:
            averaged = {mesh: run["steel"][place]["averaged_plastic_strain"] for mesh, run in runs.items()}
            for mesh, run in runs.items():
                at = run["steel"][place]
                change = f"{100 * (averaged[mesh + 1] / averaged[mesh] - 1):8.1f}" if mesh + 1 in averaged else f"{'-':>8}"
                lines.append(f"{speed:5.2f} {mesh:4d} {place:12s} {at['max_plastic_strain']:8.4f} {at['averaged_plastic_strain']:9.4f}  {change} {at['triaxiality']:12.2f} "
                             f"{at['damage']:7.3f} {run['processor_time_s']:8.0f}")
            if {1, 2} <= set(averaged):
                failures += filter(None, [missed(place, speed, averaged[1], averaged[2])])
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], tuple(int(m) for m in sys.argv[3].split(",")) if len(sys.argv) > 3 else (0, 1, 2)))
