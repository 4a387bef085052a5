"""The folder of a sweep: table.csv, or the tables of its shards, and fractiles.csv."""
import csv
import glob
import json
import os
from dataclasses import dataclass, field

import numpy as np

from .errors import DataError

NOT_PARAMETERS = ("run", "status")  #: the parameters of a sweep stand between these columns


@dataclass
class Fleet:
    folder: str
    parameters: list[str]
    columns: dict[str, np.ndarray]     #: numbers; NaN where a run has none
    status: list[str]
    fractiles: dict[str, np.ndarray] = field(default_factory=dict)
    along: str = ""                    #: the parameter the fractiles are given along
    n_due: int = 0                     #: runs of the sweep, with those of shards that are not here
    groups: list[str] = field(default_factory=list)  #: of each row of the fractiles, what it is given by; "" where by nothing

    @property
    def varied(self) -> list[str]:
        """Parameters that differ between runs; of those that go together the first."""
        known: list[np.ndarray] = []
        chosen: list[str] = []
        for name in self.parameters:
            values = self.columns[name]
            differs = len(np.unique(values[np.isfinite(values)])) > 1
            if differs and not any(np.allclose(values, other, equal_nan=True) for other in known):
                known.append(values)
                chosen.append(name)
        return chosen


def is_fleet(folder: str) -> bool:
    return bool(_tables(folder))


def _tables(folder: str) -> list[str]:
    whole = os.path.join(folder, "table.csv")
    return [whole] if os.path.isfile(whole) else sorted(glob.glob(os.path.join(glob.escape(folder), "table-*-of-*.csv")))


def read(folder: str) -> Fleet:
    """Throws DataError naming the file."""
    tables = _tables(folder)
    if not tables:
        raise DataError(f"{folder} holds no table.csv of a sweep")
    rows = [row for table in tables for row in _rows(table)]
    names = list(rows[0])
    if "run" in names:  # shards of another count hold some of them again
        rows = [row for _, row in sorted(dict(zip(_numbers(tables[0], rows, "run"), rows)).items())]
    for name in (*NOT_PARAMETERS, "peak_displacement_m"):
        if name not in names:
            raise DataError(f"{tables[0]}: no column {name}; there are {', '.join(names)}")
    parameters = [name for name in names[names.index("run") + 1:names.index("status")] if _is_number_column(rows, name)]
    numbers = [name for name in names if name not in ("status", "reason") and _is_number_column(rows, name)]
    fleet = Fleet(folder, parameters, {name: _numbers(tables[0], rows, name) for name in numbers}, [row["status"] for row in rows])
    fleet.n_due = max(_n_due(os.path.join(folder, "fleet.json")), len(rows))
    path = os.path.join(folder, "fractiles.csv")
    if os.path.isfile(path):
        table = _rows(path)
        names = list(table[0])
        if "n_runs" not in names[1:]:
            raise DataError(f"{path}: no column n_runs behind the parameters; there are {', '.join(names)}")
        *by, fleet.along = names[:names.index("n_runs")]
        fleet.fractiles = {name: _numbers(path, table, name) for name in names[len(by):]}
        fleet.groups = [", ".join(row[name] for name in by) for row in table]
    return fleet


def _n_due(path: str) -> int:
    """0: the folder does not say."""
    try:
        with open(path, encoding="utf-8") as file:
            return int(json.load(file)["n_runs"])
    except (OSError, ValueError, KeyError, TypeError):
        return 0


def _rows(path: str) -> list[dict[str, str]]:
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise DataError(f"{path} is not a readable table ({error})") from None
    if not rows:
        raise DataError(f"{path} holds no rows")
    if any(None in row or None in row.values() for row in rows):
        raise DataError(f"{path}: a row has not as many cells as the header")
    return rows


def _is_number_column(rows: list[dict[str, str]], name: str) -> bool:
    try:
        [float(row[name]) for row in rows if row[name] not in ("", None)]
    except ValueError:
        return False
    return True


def _numbers(path: str, rows: list[dict[str, str]], name: str) -> np.ndarray:
    try:
        return np.array([float(row[name]) if row[name] else np.nan for row in rows])
    except ValueError as error:
        raise DataError(f"{path}: column {name}: {error}") from None
