"""Runs of the catalogue: made by rimpact's own verbs as child processes, kept once done, read by the figures and numbers."""
import hashlib
import json
import os
import subprocess
import sys
from typing import Any

from ..data_files import read_any_json
from ..errors import DataError
from ..files import write_whole
from ..run_folder import Run, load_run
from ..side_by_side import cores_to_use, run_side_by_side
from . import derived
from .catalogue import FOLDER, Catalogue, Number


class Runs:
    """`folder`: where they are kept, a folder each. `cheap`: heavy ones are read where they are kept, never made. `jobs`: so many of the others
    run side by side; 0: as many as there are cores. `calibration`: a folder whose law the rims of two dishes have, instead of the one assumed."""

    def __init__(self, catalogue: Catalogue, program: str, folder: str, records: str, cheap: bool = False, quiet: bool = False, jobs: int = 0,
                 calibration: str = "") -> None:
        self.catalogue, self.program, self.folder, self.records = catalogue, program, folder, records
        self.cheap, self.quiet, self.jobs = cheap, quiet, jobs or cores_to_use()
        self.calibration = os.path.abspath(calibration) if calibration else ""
        self._law = hashlib.sha256(json.dumps(read_any_json(os.path.join(calibration, "calibration.json"))).encode()).hexdigest() if calibration else ""
        self.missing: dict[str, str] = {}  #: name: the sentence why it is not there
        self._read: dict[str, Run] = {}

    def place(self, name: str) -> str:
        run = self.catalogue.runs[name]
        return os.path.join(FOLDER, run.kept) if run.kept else os.path.join(self.folder, "runs", name)

    def words(self, name: str) -> list[str]:
        """Of its command: {records} is the user's folder, {law} the settings of the law fitted to the kept references."""
        words = []
        for word in self.catalogue.runs[name].command:
            words += _law() if word == "{law}" else [word.replace("{records}", os.path.abspath(self.records))]
        if self._takes_law(name):
            return [*_without_element(words), "--calibration", self.calibration]
        return words

    def make(self, name: str) -> bool:
        """Whether the run is there, made now if it must be."""
        self.make_all([name])
        return name not in self.missing

    def make_all(self, names: list[str]) -> None:
        """Those that can be made and are not there yet: heavy ones, which take all cores, one by one, the others side by side, the longest first."""
        waiting = sorted((name for name in dict.fromkeys(names) if self._is_wanted(name)), key=lambda name: -self.catalogue.runs[name].seconds)
        for heavy, at_once in ((False, self.jobs), (True, 1)):
            commands = {name: self._whole(name) for name in waiting if self.catalogue.runs[name].heavy == heavy}
            for name, done in run_side_by_side(commands, at_once, self._begin):
                self._end(name, done)

    def _is_wanted(self, name: str) -> bool:
        """Whether it is to be made and can be; where it cannot, `missing` says why."""
        run = self.catalogue.runs[name]
        if run.kept or name in self.missing or self._is_done(name):
            return False
        absent = [file for file in run.records if not os.path.isfile(os.path.join(self.records, file))]
        if absent:
            self.missing[name] = f"{name} needs {', '.join(absent)} in {self.records} (--records DIR)"
        elif run.heavy and self.cheap:
            self.missing[name] = f"{name} takes some {_duration(run.seconds)}: run without --cheap"
        return name not in self.missing

    def _is_done(self, name: str) -> bool:
        """Kept from before, by the same command, to its end."""
        noted = os.path.join(self.place(name), "command.json")
        return os.path.isfile(noted) and read_any_json(noted) == self._identity(name)

    def _identity(self, name: str) -> list[str]:
        """Its command, and what the calibration's file holds: a folder may be made anew."""
        return [*self.words(name), self._law] if self._takes_law(name) else self.words(name)

    def _takes_law(self, name: str) -> bool:
        return bool(self.calibration) and self.catalogue.runs[name].has_two_dishes

    def _whole(self, name: str) -> list[str]:
        end = ["--json"] if self.catalogue.runs[name].json else ["-o", self.place(name), "--force", "--quiet"]
        return [self.program, *self.words(name), *end]

    def _begin(self, name: str) -> None:
        os.makedirs(self.place(name), exist_ok=True)
        if not self.quiet:
            print(f"{name}: rimpact {' '.join(self._whole(name)[1:])}", file=sys.stderr)

    def _end(self, name: str, done: subprocess.CompletedProcess[str]) -> None:
        place = self.place(name)
        if done.returncode != 0:
            self.missing[name] = f"{name} ended with {done.returncode}: {(done.stderr.strip().splitlines() or ['no word'])[-1]}"
            return
        if self.catalogue.runs[name].json:
            _write(os.path.join(place, "output.json"), json.loads(done.stdout))
        _write(os.path.join(place, "command.json"), self._identity(name))

    def response(self, name: str) -> Run | None:
        """The run as report.run_folder reads it; None where it is not there."""
        if not self.make(name):
            return None
        if name not in self._read:
            self._read[name] = load_run(self.place(name), name)
        return self._read[name]

    def summary(self, name: str) -> Any:
        """Its summary.json, or what it printed; None where it is not there."""
        if not self.make(name):
            return None
        place = self.place(name)
        kind = "output.json" if self.catalogue.runs[name].json else "summary.json"
        return read_any_json(place if place.endswith(".json") else os.path.join(place, kind))


def _without_element(words: list[str]) -> list[str]:
    """A command's words without the settings of the rims' element, which would win over a calibration."""
    element = tuple(f"reduced.{key}=" for key in ("impact_law", "k_i_kN_per_m", "restitution"))
    dropped = {i for i, word in enumerate(words) if word.startswith(element)}
    return [word for i, word in enumerate(words) if i not in dropped and i + 1 not in dropped]


def _law() -> list[str]:
    settings = read_any_json(os.path.join(FOLDER, "references", "elastoplastic.json"))
    return [word for key, value in settings.items() for word in ("--set", f"{key}={json.dumps(value)}")]


def value_of(number: Number, runs: Runs) -> float | None:
    """Ours, in the printed unit; None where a run is not there or has no such number."""
    return _mean(number, number.ours, runs)


def value_without_cause(number: Number, runs: Runs) -> float | None:
    """The same of the run that takes the cause away."""
    return _mean(number, number.without, runs)


def _mean(number: Number, formula: str, runs: Runs) -> float | None:
    if not formula:
        return None
    values = [_ratio(text.strip(), runs) for text in formula.split(";")]
    known = [value for value in values if value is not None]
    return number.factor * sum(known) / len(known) if len(known) == len(values) else None


def _ratio(ours: str, runs: Runs) -> float | None:
    text = ours.removesuffix(" - 1")
    terms = [_term(term.strip(), runs) for term in text.split("/")]
    known = [term for term in terms if term is not None]
    if len(known) < len(terms) or 0 in known[1:]:
        return None
    value = known[0] / known[1] if len(known) > 1 else known[0]
    return value - 1 if text != ours else value


def _term(term: str, runs: Runs) -> float | None:
    name, _, path = term.partition(":")
    if derived.is_derived(path):
        run = runs.response(name)
        return None if run is None else derived.of(run, path)
    value = runs.summary(name)
    if path.startswith("reduction "):
        return None if value is None else derived.reduction(value, path)
    for key in path.split("."):
        if isinstance(value, list):
            value = value[int(key)] if int(key) < len(value) else None
        else:
            value = value.get(key) if isinstance(value, dict) else None
    if value is not None and not isinstance(value, (int, float)):
        raise DataError(f"{term} is no number")
    return value


def _write(path: str, value: Any) -> None:
    write_whole(path, lambda file: file.write(json.dumps(value, indent=1).encode()))


def _duration(seconds: float) -> str:
    return f"{seconds / 3600:.1f} h" if seconds >= 3600 else f"{seconds / 60:.0f} min" if seconds >= 60 else f"{seconds:.0f} s"
