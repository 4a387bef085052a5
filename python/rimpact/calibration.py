"""Calibrations: made by the command, read as they are stored."""
from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from rimpact import program
from rimpact.comparison import write_run
from rimpact.measured import Measured
from rimpact.results import Run, html_of, json_in


@dataclass(frozen=True)
class Calibration:
    """A folder with calibration.json. `data` is that file; what follows is taken from it.

    >>> made = rimpact.calibrate(rimpact.run_reduced("impact-window"), "a-fit", law="signed", laws="none")
    >>> rimpact.Calibration.load("a-fit").mass == made.mass
    True
    """
    folder: Path
    data: dict

    @staticmethod
    def load(folder: str | os.PathLike) -> Calibration:
        """Reads a calibration folder, e.g. results/main/calibration."""
        return Calibration(Path(folder), json_in(folder, "calibration.json"))

    @property
    def answer(self) -> dict:
        """Law, table of speeds, constant pair or why there is none, doubts."""
        return self.data.get("answer") or {}

    @property
    def sentence(self) -> str:
        """What may be said of the law: its numbers, the speeds it holds for, its errors."""
        return (self.answer.get("law") or {}).get("sentence", "")

    @property
    def parameters(self) -> pd.DataFrame:
        """The fitted parameters: value, unit, standard error, interval and verdict, a row each."""
        return pd.DataFrame(self.data.get("parameters", {})).T

    @property
    def mass(self) -> float | None:
        """Supported mass of the fitted runs [kg]."""
        return self.answer.get("mass_kg")

    @property
    def known_speeds(self) -> tuple[float, float] | None:
        """Slowest and fastest approach [m/s] that its law was fitted to, at `mass`; None where none is said."""
        law = self.answer.get("law") or {}
        ends = law.get("valid_from_m_s"), law.get("valid_to_m_s")
        return None if None in ends else (float(ends[0]), float(ends[1]))

    def _repr_html_(self) -> str:
        return html_of("calibration", {"law": self.sentence, "supported mass (kg)": self.mass}, self.parameters, self.answer.get("doubts") or [])


def _named(run: str | os.PathLike | Measured | Run, folder: Path, number: int) -> str:
    """A path that the command reads: the run's own, or one in `folder`."""
    if isinstance(run, Measured):
        return os.fspath(run.write(folder))
    if isinstance(run, Run):
        return os.fspath(run.folder) if run.folder is not None else write_run(run, folder / f"run-{number}")
    return os.fspath(run)


def calibrate(runs: Iterable[str | os.PathLike | Measured | Run] | str | os.PathLike | Measured | Run, folder: str | os.PathLike = "results/calibration", *,
              predict: Iterable[str | os.PathLike | Measured | Run] = (),
              law: str | None = None, laws: str | None = None, fit: str | None = None, options: Iterable[str] = ()) -> Calibration:
    """Fits the rim's law, as `rimpact calibrate` does, to run folders, mapping files, `Measured` arrays or `Run`s of this process; what
    has no files is written to FOLDER/asked. options: further words of that verb.

    >>> runs = [rimpact.run_reduced(rimpact.Scene("impact-window", {"excitation.speed_m_per_s": speed})) for speed in (0.1, 0.2, 0.4)]
    >>> made = rimpact.calibrate(runs, "my-calibration", law="signed", laws="none")
    >>> round(made.parameters.value["k_i"] / rimpact.Scene("impact-window")["reduced.k_i_kN_per_m"], 2)
    1.0
    """
    given = [runs] if isinstance(runs, str | os.PathLike | Measured | Run) else list(runs)
    asked, left_out = Path(folder) / "asked", list(predict)
    words = ["calibrate", *(_named(run, asked, i) for i, run in enumerate(given)), "-o", os.fspath(folder), "--quiet"]
    for i, run in enumerate(left_out):
        words += ["--predict", _named(run, asked, len(given) + i)]
    for name, value in (("--law", law), ("--laws", laws), ("--fit", fit)):
        words += [name, value] if value else []
    program.run(*words, *options)
    return Calibration.load(folder)
