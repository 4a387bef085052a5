"""Buildings, reliability studies and the thesis's items, as the command makes them."""
from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from rimpact import program
from rimpact.errors import DataError
from rimpact.results import Run, html_of, json_in, load
from rimpact.scene import Scene, Value
from rimpact.work import on_disk, settings_words


@dataclass(frozen=True)
class Building:
    """A building's run. `run`: its response and summary; `bearings`: a row each with place, static load, impacts and peaks.

    >>> building = rimpact.building("ricker-0.78g-1.0s", "my-building", settings={"excitation.duration_s": 2.5})
    >>> len(building.bearings), bool(building.bearings.peak_displacement_m.max() < 0.4)
    (6, True)
    """
    run: Run
    bearings: pd.DataFrame

    def _repr_html_(self) -> str:
        facts = {name: self.run.summary.get(name) for name in ("status", "peak_displacement_m", "peak_impact_force_N", "n_impacts")}
        return html_of("building", facts, self.bearings, self.run.summary.get("warnings") or [])


def building(scene: Scene | str | os.PathLike, folder: str | os.PathLike, frame: str | os.PathLike = "thesis-2.4", *,
             settings: Mapping[str, Value] | None = None, force: bool = False) -> Building:
    """Moves a building with a bearing under each of its columns, as `rimpact building` does, into a run folder.

    frame: thesis-2.4, thesis-3.5, thesis-3.5-slab, thesis-2.5, a TOML file of a regular building or an inelastic frame, or a folder of
    tables; force: replaces what the folder holds. Raises Stopped where the motion could not be finished.

    >>> made = rimpact.building("ricker-0.78g-1.0s", "on-six", settings={"excitation.duration_s": 2.5})
    >>> made.run.summary["status"]
    'done'
    """
    with tempfile.TemporaryDirectory() as place:
        words = ["building", on_disk(scene, place), "--frame", os.fspath(frame), "-o", os.fspath(folder), "--quiet", *settings_words(settings)]
        program.run(*words, *(["--force"] if force else []))
    run = load(folder)
    return Building(run, pd.DataFrame((run.summary.get("building") or {}).get("bearings") or []))


@dataclass(frozen=True)
class Reliability:
    """A reliability study's results. `data`: reliability.json; `folder`: where its tables lie, each read by `table`.

    >>> rimpact.Reliability.load("my-study")                                       # doctest: +SKIP
    """
    data: dict
    folder: Path

    @staticmethod
    def load(folder: str | os.PathLike) -> Reliability:
        """Reads the results folder of a study."""
        return Reliability(json_in(folder, "reliability.json"), Path(folder))

    def table(self, name: str) -> pd.DataFrame:
        """One of its tables: fragility, reliability, ida, hits, motions, difference, sensitivity, levels, records."""
        path = self.folder / f"{name}.csv"
        if not path.is_file():
            raise DataError(f"{self.folder} has no table {name}; there are {', '.join(sorted(each.stem for each in self.folder.glob('*.csv')))}")
        return pd.read_csv(path, float_precision="round_trip")

    @property
    def fragility(self) -> pd.DataFrame:
        """Probability that a limit is passed, a row a system, limit and level, with its band."""
        return self.table("fragility")

    @property
    def rates(self) -> pd.DataFrame:
        """Rate a year and probability over the study's years, a row a system and limit, with bands."""
        return self.table("reliability")

    def _repr_html_(self) -> str:
        facts = {name: self.data.get(name) for name in ("study", "n_systems", "n_runs", "n_runs_without_result", "years")}
        return html_of("reliability", facts, self.rates.head(20), self.data.get("doubts") or [])


def reliability(study: str | os.PathLike, folder: str | os.PathLike, *, records: Iterable[str | os.PathLike] = (), table: str | os.PathLike | None = None,
                shard: str | None = None, jobs: int | None = None, report: bool = False, progress: Callable[[str], object] | None = None) -> Reliability:
    """Runs a reliability study, as `rimpact reliability` does: fragility, hazard, rate and probability of each system. Finished runs are kept.

    study: its file; records: folders beside the study's own; table: of motions, in place of the study's; shard: "2/4" for the second of four
    parts; report: report.html as well; progress: called with each line of messages.

    >>> rimpact.reliability("my-study.toml", "my-study", records=["my-records"])    # doctest: +SKIP
    """
    words = ["reliability", os.fspath(study), "-o", os.fspath(folder), *([] if report else ["--no-report"])]
    for each in records:
        words += ["--records", os.fspath(each)]
    for name, value in (("--table", table), ("--shard", shard), ("--jobs", jobs)):
        words += [name, os.fspath(value) if isinstance(value, os.PathLike) else str(value)] if value is not None else []
    program.run(*words, *([] if progress else ["--quiet"]), progress=progress)
    return Reliability.load(folder)


def thesis(what: str = "list", folder: str | os.PathLike = "results/thesis", *, records: str | os.PathLike | None = None, cheap: bool = False) -> pd.DataFrame:
    """A figure or table of the thesis by its number, ours beside it, as `rimpact thesis` makes it: a row a number. "list": what there is;
    "headlines": the headline numbers, judged. folder: of runs, pictures and pages; records: of your AT2 files; cheap: no finite elements.

    >>> rimpact.thesis("list").loc["table-3-4", "state"]
    'done'
    """
    words = ["thesis", what, "-o", os.fspath(folder), "--json", "--quiet", *(["--cheap"] if cheap else [])]
    words += ["--records", os.fspath(records)] if records is not None else []
    data = json.loads(program.run(*words))
    if what == "headlines":
        return pd.DataFrame(data)
    if what == "list":
        return pd.DataFrame([{**{key: value for key, value in each.items() if key != "numbers"}, "n_numbers": len(each["numbers"])} for each in data["entries"]]).set_index("id")
    return pd.DataFrame([{"entry": entry["id"], **number} for entry in data["entries"] for number in entry["numbers"]])
