"""A results folder of `rimpact main`, or one run folder taken as such.

    DIR/runs/<name>/  FE runs    DIR/reduced/<name>/  the same scenes by the reduced model, fitted values
    DIR/law/<name>/  the same, with the impact law that leaves least unexplained
    DIR/published/<name>/ or DIR/reduced/<name>-published/  the same, published values
    DIR/calibration/calibration.json    DIR/main.json: {"runs": [{name, role, fe, reduced, law, published}], totals, ...}

Whatever is missing or unreadable becomes a sentence in `problems`, never an error, as long as something is left."""
import os
import re
from dataclasses import dataclass, field
from typing import Any

from . import curves
from .curves import ImpactCurve
from .data_files import read_json
from .errors import DataError
from .files import require_folder
from .run_folder import Run, is_run_folder, load_run
from .shapes import CALIBRATION, CURVES, MAIN, ShapeError

SLOTS = ("fe", "fitted", "law", "published")  #: what may stand for one scene, the reference first
ROLES = ("fit", "predict", "window", "push")


@dataclass
class Entry:
    """One scene: its FE run and what the reduced model makes of it. Any of them may be None."""
    name: str
    role: str
    fe: Run | None = None
    fitted: Run | None = None
    law: Run | None = None
    published: Run | None = None

    def models(self) -> list[tuple[str, Run]]:
        """(style role, run) of those that have a response, the reference first."""
        return [(slot, getattr(self, slot)) for slot in SLOTS if getattr(self, slot) is not None and getattr(self, slot).signals]

    @property
    def best(self) -> str:
        """The slot of the reduced run to be judged by: the answer's law, where the folder holds it beside a pair."""
        return "law" if self.law else "fitted"

    @property
    def any_run(self) -> Run | None:
        return self.fe or self.fitted or self.law or self.published

    @property
    def scale(self) -> float:
        return self.any_run.get("excitation", "scale", default=1.0) if self.any_run else 1.0

    @property
    def speed(self) -> float | None:
        """Approach speed a window asks for [m/s]."""
        return self.any_run.get("excitation", "speed_m_per_s") if self.any_run else None


@dataclass
class Results:
    folder: str
    single: bool = False
    entries: list[Entry] = field(default_factory=list)
    calibration: dict[str, Any] = field(default_factory=dict)
    curves: dict[str, Any] = field(default_factory=dict)  # of curves.json beside it
    impacts: list[ImpactCurve] = field(default_factory=list)
    main: dict[str, Any] = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)

    def having(self, *roles: str) -> list[Entry]:
        return [entry for entry in self.entries if entry.role in roles]

    @property
    def histories(self) -> list[Entry]:
        return self.having("fit", "predict", "history")

    @property
    def windows(self) -> list[Entry]:
        windows = self.having("window")
        return sorted(windows, key=lambda entry: entry.speed or 0.0)

    @property
    def answer(self) -> dict[str, Any]:
        """The one record of what the calibration answers; empty where there is none."""
        return self.calibration.get("answer", {})

    @property
    def only(self) -> Run:
        """The run of a folder that holds one."""
        run = self.entries[0].any_run
        assert run is not None
        return run

    @property
    def reference(self) -> Run | None:
        """The run whose scene stands for the bearing and the load."""
        for entry in self.histories + self.entries:
            for run in (entry.fe, entry.fitted, entry.law, entry.published):
                if run is not None and run.scene:
                    return run
        return None


def load_results(folder: str) -> Results:
    """Throws DataError when the folder holds nothing that can be reported."""
    require_folder(folder)
    if is_run_folder(folder):
        return single_run(folder)
    results = Results(folder)
    _read_main(results)
    _read_calibration(results)
    for item in _listed_runs(results) or _found_runs(folder):
        results.entries.append(_load_entry(results, item))
    results.impacts = results.impacts or curves.of_entries(results.entries, results.answer.get("law", {}).get("name"))
    if not results.answer.get("published_applies"):
        for entry in results.entries:  # another bearing's pair
            entry.published = None
    if not any(entry.any_run for entry in results.entries) and not results.calibration:
        reasons = f" ({results.problems[0]})" if results.problems else ""
        raise DataError(f"{folder} holds no run folder with a response and no calibration{reasons}")
    return results


def single_run(folder: str) -> Results:
    run = load_run(folder)
    if not run.signals and not run.summary:
        raise DataError(f"{folder} holds no response and no summary")
    results = Results(folder, single=True, problems=[f"{run.name}: {problem}" for problem in run.problems])
    entry = Entry(run.name, _role_of(run.kind, run.name))
    setattr(entry, "fitted" if run.rung == "reduced" else "fe", run)
    results.entries.append(entry)
    return results


def _read_main(results: Results) -> None:
    path = os.path.join(results.folder, "main.json")
    if not os.path.isfile(path):
        if os.path.isdir(os.path.join(results.folder, "runs")):
            results.problems.append("no main.json: totals and versions are not known")
        return
    results.main = read_json(path, MAIN)


def _read_calibration(results: Results) -> None:
    for path in ("calibration/calibration.json", "calibration.json"):
        path = os.path.join(results.folder, path)
        if os.path.isfile(path):
            results.calibration = read_json(path, CALIBRATION)
            _read_curves(results, os.path.join(os.path.dirname(path), "curves.json"))
            return
    results.problems.append("calibration: not run (no calibration/calibration.json)")


def _read_curves(results: Results, path: str) -> None:
    if os.path.isfile(path):
        results.curves = read_json(path, CURVES)
        results.impacts = curves.read(path, results.curves)


def _listed_runs(results: Results) -> list[dict[str, str]]:
    return [item for item in results.main.get("runs", []) if "name" in item]


def _found_runs(folder: str) -> list[dict[str, str]]:
    names = []
    for sub in ("runs", "reduced"):
        path = os.path.join(folder, sub)
        if os.path.isdir(path):
            names += [n for n in os.listdir(path) if os.path.isdir(os.path.join(path, n)) and not _is_published(n)]
    return [{"name": name} for name in sorted(set(names), key=_natural)]


def _is_published(name: str) -> bool:
    return name.endswith("-published")


def _natural(name: str) -> list[float | str]:
    return [float(part) if part.replace(".", "", 1).isdigit() else part for part in re.split(r"(\d+\.?\d*)", name)]


def _load_entry(results: Results, item: dict[str, str]) -> Entry:
    name = str(item["name"])
    entry = Entry(name, "")
    places = {"fe": [item.get("fe"), f"runs/{name}"],
              "fitted": [item.get("reduced"), item.get("fitted"), f"reduced/{name}"],
              "law": [item.get("law"), f"law/{name}"],
              "published": [item.get("published"), f"published/{name}", f"reduced/{name}-published"]}
    for slot, candidates in places.items():
        setattr(entry, slot, _first_run(results, name, slot, candidates))
    if entry.fitted and entry.law and entry.fitted.get("reduced") == entry.law.get("reduced"):
        entry.law = None  # no pair serves: both are the law's
    if entry.fe is None:
        results.problems.append(f"{name}: no finite-element run is stored")
    role = item.get("role")
    kind = entry.any_run.kind if entry.any_run else ""
    entry.role = role if role in ROLES else _role_of(kind, name)
    return entry


def _first_run(results: Results, name: str, slot: str, candidates: list[Any]) -> Run | None:
    for place in candidates:
        if not place:
            continue
        for path in (os.path.join(results.folder, place), place):
            if os.path.isdir(path) and is_run_folder(path):
                return _tolerant_load(results, path, f"{name} ({slot})")
    return None


def _tolerant_load(results: Results, path: str, label: str) -> Run | None:
    try:
        run = load_run(path)
    except ShapeError:  # a hand has been there: nothing of it is shown
        raise
    except DataError as error:
        results.problems.append(f"{label}: {error}")
        return None
    results.problems += [f"{label}: {problem}" for problem in run.problems]
    return run


def _role_of(kind: str, name: str) -> str:
    if kind == "window" or name.startswith(("window", "impact-window")):
        return "window"
    if kind == "push" or name.startswith(("push", "rim-push")):
        return "push"
    return "history"
