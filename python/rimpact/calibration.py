"""Calibrations: made by the command, read as they are stored."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from rimpact import program
from rimpact.errors import DataError


@dataclass(frozen=True)
class Calibration:
    """A folder with calibration.json. `data` is that file; what follows is taken from it."""
    folder: Path
    data: dict

    @staticmethod
    def load(folder: str | os.PathLike) -> Calibration:
        """Reads a calibration folder, e.g. results/main/calibration."""
        path = Path(folder) / "calibration.json"
        try:
            return Calibration(Path(folder), json.loads(path.read_text(encoding="utf-8")))
        except (FileNotFoundError, NotADirectoryError):
            raise DataError(f"{folder}: is no folder with a calibration.json") from None
        except ValueError as error:  # JSON, or its bytes
            raise DataError(f"{path}: {error}") from error

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


def calibrate(runs: Iterable[str | os.PathLike], folder: str | os.PathLike = "results/calibration", *, predict: Iterable[str | os.PathLike] = (),
              law: str | None = None, laws: str | None = None, fit: str | None = None, options: Iterable[str] = ()) -> Calibration:
    """Fits the rim's law to run folders or mapping files, as `rimpact calibrate` does; `options`: further words of that verb."""
    if isinstance(runs, str | os.PathLike):
        runs = [runs]
    words = ["calibrate", *map(os.fspath, runs), "-o", os.fspath(folder), "--quiet"]
    for run in predict:
        words += ["--predict", os.fspath(run)]
    for name, value in (("--law", law), ("--laws", laws), ("--fit", fit)):
        words += [name, value] if value else []
    program.run(*words, *options)
    return Calibration.load(folder)
