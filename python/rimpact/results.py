"""Run folders and fleets as pandas tables. Column names are the signals of response.h5; units stand in `frame.attrs["units"]`."""
from __future__ import annotations

import html
import json
import os
import warnings
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from rimpact import _core
from rimpact.errors import DataError

# Columns of response.csv and the signals they hold.
CSV_COLUMNS = {"time_s": "time", "ux_m": "displacement_x", "uy_m": "displacement_y", "uz_m": "displacement_z", "Fx_N": "force_x",
               "Fy_N": "force_y", "Fz_N": "force_z", "Ix_N": "impact_x", "Iy_N": "impact_y", "gap_m": "gap"}


@dataclass(frozen=True)
class Run:
    """One run, flown or read.

    response: signals over time [s]; summary: summary.json; impacts: a row each, as summary["impacts"]; fields: the files of the
    finite-element fields with their times [s], empty for a reduced run; scene: the resolved scene, TOML; folder: None where none was written.

    >>> run = rimpact.run_reduced("impact-window")
    >>> float(run.impacts.peak_force_N[0]) == run.summary["peak_impact_force_N"], run.response.attrs["units"]["impact_x"]
    (True, 'N')
    """
    response: pd.DataFrame
    summary: dict
    impacts: pd.DataFrame
    fields: pd.DataFrame
    scene: str
    folder: Path | None

    def plot(self, path: str | os.PathLike | None = None) -> object:
        """Displacement and rim force over time, and the loop: a matplotlib figure, written to `path` where one is given. Loops are drawn as
        minus the force over the displacement. Needs matplotlib."""
        from rimpact.drawing import draw_run
        return draw_run(self, path)

    def _repr_html_(self) -> str:
        return html_of("run", {name: self.summary.get(name) for name in ("status", "rung", "peak_displacement_m", "peak_lateral_force_N", "peak_impact_force_N",
                                                                       "n_impacts")}, self.impacts, self.summary.get("warnings") or [])


@dataclass(frozen=True)
class Fleet:
    """A sweep: `runs`, a row each with parameters and results; `fractiles`, None where none were asked for.

    >>> fleet = rimpact.sweep("impact-window", {"excitation.speed_m_per_s": [0.2, 0.4]}, "two-runs")
    >>> list(fleet.runs["excitation.speed_m_per_s"]), fleet.fractiles is None
    ([0.2, 0.4], True)
    """
    runs: pd.DataFrame
    fractiles: pd.DataFrame | None
    folder: Path

    def _repr_html_(self) -> str:
        return html_of("fleet", {"runs": len(self.runs), "folder": self.folder}, self.runs.head(20), [])


def html_of(title: str, facts: Mapping[str, object], table: pd.DataFrame, doubts: list[str]) -> str:
    """What a notebook shows: facts, a table, and doubts as a list."""
    rows = "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(f'{value:.6g}' if isinstance(value, float) else str(value))}</td></tr>"
                   for name, value in facts.items() if value is not None)
    said = "".join(f"<li>{html.escape(each)}</li>" for each in doubts)
    return f"<b>{title}</b><table>{rows}</table>{table.to_html()}" + (f"<ul>{said}</ul>" if said else "")


def frame_of(signals: Mapping[str, np.ndarray]) -> pd.DataFrame:
    """Signals by name as a table over time, with units and descriptions."""
    known = {name: (units, text) for name, units, text in _core.known_signals()}
    columns = {name: values for name, values in signals.items() if name != "time"}
    frame = pd.DataFrame(columns, index=pd.Index(signals["time"], name="time"))
    frame.attrs["units"] = {name: known[name][0] for name in frame.columns if name in known}
    frame.attrs["descriptions"] = {name: known[name][1] for name in frame.columns if name in known}
    return frame


def run_from_signals(signals: Mapping[str, np.ndarray], summary: dict, scene: str, folder: str | os.PathLike | None) -> Run:
    """A run from its parts."""
    place = None if folder is None else Path(folder)
    return Run(frame_of(signals), summary, _impacts(summary), _fields(place), scene, place)


def load(folder: str | os.PathLike) -> Run:
    """Reads a run folder of any rung: response.h5 (or response.csv), summary.json, scene.toml, fields/fields.pvd.

    >>> flown = rimpact.run_reduced("impact-window", "a-run")
    >>> bool((rimpact.load("a-run").response.impact_x == flown.response.impact_x).all())
    True
    """
    place = Path(folder)
    if not place.is_dir():
        raise DataError(f"{place}: no such folder")
    with _reading(place):
        return run_from_signals(_signals(place), _json(place / "summary.json"), _text(place / "scene.toml"), place)


def load_fleet(folder: str | os.PathLike) -> Fleet:
    """Reads what `rimpact reduced --sweep` wrote: table.csv, or the tables of its shards, each run once, and fractiles.csv.

    Warns where shards are missing.

    >>> made = rimpact.sweep("impact-window", {"excitation.speed_m_per_s": [0.2, 0.4]}, "a-fleet")
    >>> len(rimpact.load_fleet("a-fleet").runs)
    2
    """
    place = Path(folder)
    tables = [place / "table.csv"] if (place / "table.csv").is_file() else sorted(place.glob("table-*-of-*.csv"))
    if not tables:
        raise DataError(f"{place}: holds no table.csv; is it the folder of a sweep?")
    with _reading(place):
        runs = pd.concat([pd.read_csv(table, float_precision="round_trip") for table in tables], ignore_index=True)
        runs = runs.drop_duplicates("run").sort_values("run", ignore_index=True)
        due = _json(place / "fleet.json").get("n_runs", len(runs))
        if len(runs) < due:
            warnings.warn(f"{place}: {len(runs)} of {due} runs are done; the other shards are missing", stacklevel=2)
        fractiles = place / "fractiles.csv"
        return Fleet(runs, pd.read_csv(fractiles) if fractiles.is_file() else None, place)


@contextmanager
def _reading(place: Path) -> Iterator[None]:
    """A file of another kind, a missing signal or column, signals of unequal lengths: one sentence."""
    try:
        yield
    except DataError:
        raise
    except (OSError, ValueError, KeyError, TypeError, ElementTree.ParseError) as error:
        raise DataError(f"{place}: cannot be read: {error!r}") from error


def _signals(folder: Path) -> dict[str, np.ndarray]:
    if (folder / "response.h5").is_file():
        import h5py  # only runs by finite elements and the command need it
        try:
            with h5py.File(folder / "response.h5", "r") as file:
                return {name: data[:] for name, data in file["response"].items()}
        except (OSError, KeyError) as error:
            raise DataError(f"{folder / 'response.h5'}: is no response: {error}") from error
    table = folder / "response.csv"
    if not table.is_file():
        raise DataError(f"{folder}: holds no response.h5 and no response.csv")
    frame = pd.read_csv(table, float_precision="round_trip")
    missing = [name for name in ("time_s", "ux_m", "Fx_N") if name not in frame]
    if missing:
        raise DataError(f"{table}: the column {missing[0]} is missing; there are {', '.join(frame.columns)}")
    return {CSV_COLUMNS[name]: frame[name].to_numpy(float) for name in frame if name in CSV_COLUMNS}


def _impacts(summary: dict) -> pd.DataFrame:
    names = ["touch_time_s", "release_time_s", "direction_deg", "approach_speed_m_s", "rebound_speed_m_s", "restitution", "peak_force_N",
             "peak_penetration_m"]
    rows = summary.get("impacts") or []
    return pd.DataFrame(rows, columns=names if not rows else None).astype(float)


def _fields(folder: Path | None) -> pd.DataFrame:
    index = folder / "fields.pvd" if folder else None
    if index is None or not index.is_file():
        return pd.DataFrame({"time_s": pd.Series(dtype=float), "file": pd.Series(dtype=str)})
    sets = [item.attrib for item in ElementTree.parse(index).iter("DataSet")]
    return pd.DataFrame({"time_s": [float(each["timestep"]) for each in sets], "file": [str(index.parent / each["file"]) for each in sets]})


def json_in(folder: str | os.PathLike, name: str) -> dict:
    """A file that makes a folder one of results. Raises DataError where it is not there, or is no JSON."""
    path = Path(folder) / name
    if not path.is_file():
        raise DataError(f"{folder}: is no folder with a {name}")
    return _table(path, lambda: path.read_text(encoding="utf-8"))


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return ""


def _json(path: Path) -> dict:
    return _table(path, lambda: _text(path) or "{}")


def _table(path: Path, text: Callable[[], str]) -> dict:
    try:
        found = json.loads(text())
    except ValueError as error:  # JSON, or its bytes
        raise DataError(f"{path}: {error}") from error
    if not isinstance(found, dict):
        raise DataError(f"{path}: is no table of keys")
    return found
