#!/usr/bin/env python3
"""How the strain of a rim's steel converges, by its places: windows at 0.2 and 0.5 m/s on meshes 0, 1, 2 (rung rim).

Writes the largest plastic strain and damage of a point and their means, with the means' change to the next finer mesh. Gates from mesh 1 to 2: where the
rim is strained by more than 5 %, the averaged strain moves by less than 5 %; elsewhere by less than 0.005. Where its averaged damage, by either locus, is more than 0.05, it
moves by less than 10 %; by 15 % on the wall, where the slider presses and the cut-off cuts, and by 20 % in the dish below the rim, whose cells are the coarsest: the answer
states the largest of them (damage_mesh_change in responses/steel_report.h). Elsewhere it moves by less than 0.01.

usage: steel_places.py RIMPACT FOLDER [MESHES]
"""
import pathlib
import re
import sys

from kept_run import finish, kept_run

SPEEDS, PLACES = (0.2, 0.5), ("rim_wall", "rim_root", "dish", "slider_edge")
HEAD = "speed mesh place         largest  averaged  change_%  triaxiality  lode  damage  averaged  change_%   locus  averaged  change_%  seconds"
LOCUS = "averaged_damage_bao_wierzbicki"
MEANS = {"averaged_plastic_strain": (0.05, 0.05, 0.005), "averaged_damage": (0.05, 0.10, 0.01), LOCUS: (0.05, 0.10, 0.01)}  #: from where on a share is asked, the share, the difference

SHARES = {"rim_wall": 0.15, "dish": 0.20}  #: of the damage, where 10 % is missed
HEADER = pathlib.Path(__file__).resolve().parents[2] / "responses/steel_report.h"
STATED = float(re.search(r"damage_mesh_change = (\S+);", HEADER.read_text(encoding="utf-8")).group(1))
assert max(SHARES.values()) == STATED, f"the answer states {STATED}, the gates are {SHARES}"


def steel(program, folder, speed, mesh):
    settings = [f"excitation.speed_m_per_s={speed}", "excitation.duration_s=0.06"]
    return kept_run(program, "run", "impact-window", folder / f"v{speed}_mesh{mesh}", settings, ["--mesh", str(mesh), "--no-fields"])


def missed(place, speed, key, coarse, fine):
    """Why the mean of mesh 1 is not that of mesh 2; empty where it is."""
    start, share, difference = MEANS[key]
    if key in ("averaged_damage", LOCUS):
        share = SHARES.get(place, share)
    far = abs(fine - coarse) > (share * coarse if coarse > start else difference)
    return f"{place} at {speed} m/s: {key} {coarse:.4f} on mesh 1, {fine:.4f} on mesh 2" if far else ""


def change(runs, mesh, place, key):
    """To the next finer mesh, in a column of the table."""
    return f"{100 * (runs[mesh + 1]['steel'][place][key] / runs[mesh]['steel'][place][key] - 1):9.1f}" if mesh + 1 in runs else f"{'-':>9}"


def main(program, folder, meshes=(0, 1, 2)):
    folder = pathlib.Path(folder)
    lines, failures = [HEAD], []
    for speed in SPEEDS:
        runs = {mesh: steel(program, folder, speed, mesh) for mesh in meshes}
        for place in PLACES:
            for mesh, run in runs.items():
                at = run["steel"][place]
                strain, damage, locus = (change(runs, mesh, place, key) for key in MEANS)
                lines.append(f"{speed:5.2f} {mesh:4d} {place:12s} {at['max_plastic_strain']:8.4f} {at['averaged_plastic_strain']:9.4f} {strain} {at['triaxiality']:12.2f} "
                             f"{at['lode']:5.2f} {at['damage']:7.3f} {at['averaged_damage']:9.4f} {damage} "
                             f"{at['damage_bao_wierzbicki']:7.3f} {at[LOCUS]:9.4f} {locus} {run['processor_time_s']:8.0f}")
            if {1, 2} <= set(runs):
                failures += filter(None, [missed(place, speed, key, *(runs[mesh]["steel"][place][key] for mesh in (1, 2))) for key in MEANS])
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], tuple(int(m) for m in sys.argv[3].split(",")) if len(sys.argv) > 3 else (0, 1, 2)))
