"""Readers of the files a run leaves: response.h5, response.csv, *.json. Each throws DataError with the reason."""
import json
from typing import Any

import h5py
import numpy as np

from .errors import DataError
from .shapes import check, without_nulls

CSV_NAMES = {"time_s": "time", "ux_m": "displacement_x", "uy_m": "displacement_y", "uz_m": "displacement_z",
             "Fx_N": "force_x", "Fy_N": "force_y", "Fz_N": "force_z", "Ix_N": "impact_x", "Iy_N": "impact_y",
             "gap_m": "gap"}


def read_any_json(path: str) -> Any:
    """As it stands. Throws DataError where it cannot be read."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise DataError(f"{path} is not readable JSON ({error})") from None
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None


def read_json(path: str, shape: dict[str, Any]) -> dict[str, Any]:
    """Checked against its shape, nulls left out. Throws DataError naming file and key."""
    data = without_nulls(read_any_json(path))
    check(data, shape, path)
    return data


def _no_number(text: str) -> None:
    raise ValueError(f"{text} is no number")


def read_hdf5(path: str) -> tuple[dict[str, np.ndarray], dict[str, str]]:
    """Signals and meta text of a response.h5."""
    try:
        with h5py.File(path, "r") as file:
            if "response" not in file:
                raise DataError(f"{path} holds no group /response")
            signals = {name: np.asarray(data[()], dtype=float) for name, data in file["response"].items()}
            group = file.get("meta")
            meta = {}
            if group is not None:
                meta.update({key: _text(value) for key, value in group.attrs.items()})
                meta.update({key: _text(data[()]) for key, data in group.items() if isinstance(data, h5py.Dataset)})
    except OSError as error:
        raise DataError(f"{path} is not readable HDF5 ({str(error).splitlines()[0]})") from None
    except (ValueError, KeyError, RuntimeError, TypeError, AttributeError) as error:
        raise DataError(f"{path} is damaged ({error})") from None
    return signals, meta


def _text(value: Any) -> str:
    value = value.item() if isinstance(value, np.ndarray) and value.size == 1 else value
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def read_table(path: str) -> tuple[list[str], np.ndarray]:
    """(column names, (n, columns) numbers) of a CSV with one header line."""
    try:
        with open(path, encoding="utf-8") as file:
            header, *rows = file.read().strip().splitlines() or [""]
        table = np.loadtxt(rows, delimiter=",", ndmin=2) if rows else np.empty((0, 0))
    except (ValueError, UnicodeDecodeError) as error:
        raise DataError(f"{path} is not a readable table ({error})") from None
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None
    names = [name.strip() for name in header.split(",")]
    if table.shape[1] != len(names):
        raise DataError(f"{path} has {len(names)} columns in its header and {table.shape[1]} in its rows")
    return names, table


def read_csv(path: str) -> dict[str, np.ndarray]:
    """Signals of a response.csv."""
    names, table = read_table(path)
    return {CSV_NAMES.get(name, name): table[:, i] for i, name in enumerate(names)}


def check_signals(path: str, signals: dict[str, np.ndarray]) -> None:
    if "time" not in signals:
        raise DataError(f"{path} holds no signal `time`")
    n = len(signals["time"])
    if n < 2:
        raise DataError(f"{path} holds {n} instants; at least 2 are needed")
    for name, values in signals.items():
        if values.shape != (n,):
            raise DataError(f"{path}: signal {name} has {values.size} values, time has {n}")
        if not np.all(np.isfinite(values)):
            raise DataError(f"{path}: signal {name} holds a value that is not a number")
    if back := np.flatnonzero(np.diff(signals["time"]) < 0).tolist():
        before, after = signals["time"][back[0]:back[0] + 2]
        raise DataError(f"{path}: time falls from {before:g} to {after:g} at instant {back[0] + 1}")
