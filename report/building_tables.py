"""Buildings as tables: building.csv, drift, roof and floors over time; storeys.csv, the largest of each storey. SI, units in the names."""
import os
import re
from typing import Any

import numpy as np

from .files import write_whole
from .numbers import is_number
from .run_folder import Run

UNITS = (("acceleration", "m_per_s2"), ("shear", "N"), ("overturning", "N_m"), ("rotation", "rad"), ("velocity", "m_per_s"))
OF_BUILDING = re.compile(r"(drift|roof|roof_acceleration|storey_shear|floor_\d+_\w+|base_rotation|overturning)(_[xyz])?$")


def unit_of(signal: str) -> str:
    """As a column's ending; lengths are what is left."""
    return next((unit for word, unit in UNITS if word in signal), "m")


def histories(run: Run) -> dict[str, np.ndarray]:
    """Columns of building.csv; empty where the run carries no building."""
    names = sorted((name for name in run.signals if OF_BUILDING.fullmatch(name)), key=_place)
    columns = {f"{name}_{unit_of(name)}": run.signals[name] for name in names}
    floors = floor_count(run)
    if floors and "roof_x" not in run.signals:  # the highest floor is the roof
        columns |= {f"roof_{axis}_m": run.signals[f"floor_{floors}_displacement_{axis}"] for axis in "xy" if f"floor_{floors}_displacement_{axis}" in run.signals}
    return {"time_s": run.time} | columns if columns else {}


def _place(name: str) -> list[Any]:
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def floor_count(run: Run) -> int:
    return max((int(found.group(1)) for found in (re.match(r"floor_(\d+)_", name) for name in run.signals) if found), default=0)


def storeys(run: Run) -> list[dict]:
    """From the base up, as the summary has them."""
    return run.summary.get("superstructure", {}).get("storeys") or run.summary.get("building", {}).get("floors") or []


def write(run: Run) -> list[str]:
    """Writes both tables into the run's folder; gives their names."""
    written, columns = [], histories(run)
    if columns and run.has("time"):
        text = ",".join(columns) + "\n" + "".join(",".join(f"{value + 0.0:.9g}" for value in row) + "\n" for row in np.column_stack(list(columns.values())))
        written.append(_put(run, "building.csv", text))
    rows = storeys(run)
    if rows:
        keys = [key for key in rows[0] if all(key in row for row in rows)]
        lines = [",".join(["storey", *keys])]
        lines += [",".join([str(i), *(f"{row[key]:.9g}" if is_number(row[key]) else "" for key in keys)]) for i, row in enumerate(rows, 1)]
        written.append(_put(run, "storeys.csv", "\n".join(lines) + "\n"))
    return written


def _put(run: Run, name: str, text: str) -> str:
    write_whole(os.path.join(run.folder, name), lambda file: file.write(text.encode()))
    return name
