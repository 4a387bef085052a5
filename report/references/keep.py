"""python3 -m report.references.keep RUN_FOLDER...: keeps finished runs in data/references, each under its folder's name.

scene.toml, summary.json and response.csv (nine digits, to half a second after the last release).
A run whose imbalance is 1e-3 or more, or that has no impact, is refused. For the source tree only."""
import json
import os
import shutil

import h5py
import numpy as np

from ..data_files import read_any_json
from ..errors import DataError, run_main
from ..files import write_whole
from .kept import FOLDER

COLUMNS = {"time_s": "time", "ux_m": "displacement_x", "uy_m": "displacement_y", "uz_m": "displacement_z", "vx_m_per_s": "velocity_x",
           "vy_m_per_s": "velocity_y", "vz_m_per_s": "velocity_z", "Fx_N": "force_x", "Fy_N": "force_y", "Fz_N": "force_z",
           "Ix_N": "impact_x", "Iy_N": "impact_y", "gap_m": "gap"}
SHOWN_AFTER = 0.5  #: [s], after the last release
LARGEST_IMBALANCE = 1e-3


def keep(run: str, kept: str) -> None:
    """`run`: a run folder; `kept`: the folder to fill. Throws DataError for a run that is no reference."""
    summary = read_any_json(os.path.join(run, "summary.json"))
    imbalance = summary["energy"]["imbalance_relative"]
    if summary["status"] != "done" or not summary["impacts"] or abs(imbalance) >= LARGEST_IMBALANCE:
        raise DataError(f"{run} is no reference: status {summary['status']}, {len(summary['impacts'])} impacts, imbalance {imbalance:.1e} (below {LARGEST_IMBALANCE:g})")
    with h5py.File(os.path.join(run, "response.h5")) as file:
        table = np.column_stack([file[f"response/{signal}"][:] for signal in COLUMNS.values()])
    table = table[table[:, 0] <= summary["impacts"][-1]["release_time_s"] + SHOWN_AFTER]
    at_end = dict(zip(COLUMNS, table[-1].tolist(), strict=True))  # of what is kept, not of the run that was longer
    summary |= {"residual_displacement_m": np.hypot(at_end["ux_m"], at_end["uy_m"]).item(),
                "final_speed_m_s": np.hypot(at_end["vx_m_per_s"], at_end["vy_m_per_s"]).item()}
    os.makedirs(kept, exist_ok=True)
    shutil.copy(os.path.join(run, "scene.toml"), os.path.join(kept, "scene.toml"))
    write_whole(os.path.join(kept, "summary.json"), lambda file: file.write((json.dumps(summary, indent=2, sort_keys=True) + "\n").encode()))
    write_whole(os.path.join(kept, "response.csv"), lambda file: np.savetxt(file, table, fmt="%.9g", delimiter=",", header=",".join(COLUMNS), comments=""))


def main(arguments: list[str]) -> None:
    for run in arguments:
        keep(run, os.path.join(FOLDER, os.path.basename(os.path.normpath(run))))


if __name__ == "__main__":
    run_main(main)
