"""Comparison tests: a run, or the table of a model of one's own, held against a reference."""
from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from rimpact import program
from rimpact.errors import DataError, GateError
from rimpact.results import CSV_COLUMNS, Run

NEEDED = ("displacement_x", "force_x", "impact_x")


@dataclass(frozen=True)
class Comparison:
    """How far a run is from its reference.

    table: a row a figure (peak, displacement, approach, rebound, restitution, time_ms, rms_displacement, rms_force, rms_lateral) with
    `title`, `value` (NaN: it has no meaning here, `notes` say why), `unit`, and where it was limited `limit` and `met`.
    differences: what differs between the two scenes, a row a key; data: the command's JSON.

    >>> runs = [rimpact.run_reduced(rimpact.Scene("impact-window", {"reduced.k_i_kN_per_m": k})) for k in (4.5e5, 9e5)]
    >>> rimpact.compare(*runs, {"peak": 5}).missed[0].split(":")[0]
    'peak impact force'
    """
    table: pd.DataFrame
    notes: list[str]
    differences: pd.DataFrame
    data: dict

    @property
    def met(self) -> bool:
        """Whether every limit is met; True without limits."""
        return not self.missed

    @property
    def missed(self) -> list[str]:
        """A sentence for each limit that is not met."""
        return [f"{each['title']}: {each['why']}" for each in self.data["limits"] if not each["met"]]

    def check(self) -> Comparison:
        """Raises GateError naming what is not met; else returns itself."""
        if self.missed:
            raise GateError(f"{len(self.missed)} of {len(self.data['limits'])} limits are not met: {'; '.join(self.missed)}")
        return self

    def _repr_html_(self) -> str:
        return self.table.to_html()


def _table(source: pd.DataFrame, path: Path) -> None:
    """response.csv of a table over time."""
    frame = source.copy()
    if "time" not in frame and "time_s" not in frame:
        frame.insert(0, "time", frame.index)
    names = {signal: column for column, signal in CSV_COLUMNS.items()}
    frame = frame.rename(columns=names)
    missing = [name for name in NEEDED if names[name] not in frame]
    if missing:
        raise DataError(f"the table has no column {missing[0]} (or {names[missing[0]]}); there are {', '.join(map(str, source.columns))}")
    frame[[name for name in names.values() if name in frame]].to_csv(path, index=False, float_format="%.17g")


def write_run(run: Run, folder: Path) -> str:
    """A run folder of a run that has none."""
    folder.mkdir(parents=True, exist_ok=True)
    _table(run.response, folder / "response.csv")
    (folder / "scene.toml").write_text(run.scene, encoding="utf-8")
    (folder / "summary.json").write_text(json.dumps(run.summary), encoding="utf-8")
    return os.fspath(folder)


def _placed(source: str | os.PathLike | Run | pd.DataFrame, folder: Path) -> str:
    """A path that the command reads: the source's own, or one in `folder`."""
    if isinstance(source, Run):
        if source.folder is not None:
            return os.fspath(source.folder)
        return write_run(source, folder)
    if isinstance(source, pd.DataFrame):
        _table(source, folder.with_suffix(".csv"))
        return os.fspath(folder.with_suffix(".csv"))
    return os.fspath(source)


def compare(reference: str | os.PathLike | Run | pd.DataFrame, run: str | os.PathLike | Run | pd.DataFrame,
            limits: Mapping[str, float] | None = None, *, capacity: float | None = None, anyway: bool = False) -> Comparison:
    """Holds `run` against `reference`, as `rimpact compare` does.

    Either is a run folder, a file (.h5, .csv, mapping), a `Run`, or a table over time [s] with the columns displacement_x [m], force_x
    (what the bearing does to the mass) and impact_x (the rim's part of it) [N], and the same of y where the motion is not planar. A force
    that pushes back is negative where the displacement is positive. `limits`: {"peak": 5, "rebound": 10, "time_ms": 2}, per cent but for
    the time; `Comparison.check` raises where one is not met. `capacity`: L_c [m], where neither has a scene. Runs of another
    bearing, load or motion raise InputError unless `anyway`.

    >>> mine = rimpact.run_reduced("impact-window")
    >>> rimpact.compare(mine, mine.response, {"peak": 5, "time_ms": 1}).met
    True
    """
    with tempfile.TemporaryDirectory() as place:
        words = ["compare", _placed(reference, Path(place) / "reference"), _placed(run, Path(place) / "run"), "--json"]
        words += ["--anyway"] if anyway else []
        words += ["--capacity-mm", repr(1e3 * capacity)] if capacity is not None else []
        for name, most in (limits or {}).items():
            words += ["--max", f"{name}={float(most)!r}"]
        data = json.loads(program.run(*words, accept=(0, GateError.code)))
    rows = {each["name"]: each for each in data["figures"]}
    table = pd.DataFrame(rows).T[["title", "value", "unit"]].astype({"value": float})
    limited = {each["name"]: each for each in data["limits"]}
    if limited:
        table["limit"] = [limited[name]["limit"] if name in limited else float("nan") for name in table.index]
        table["met"] = [limited[name]["met"] if name in limited else None for name in table.index]
    return Comparison(table, data["notes"], pd.DataFrame(data["differences"], columns=["key", "a", "b", "comparable"]), data)
