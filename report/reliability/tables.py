"""The tables of a reliability study as lists of rows, and how its systems fall into panels and series."""
import csv
import os
from typing import Any

from ..data_files import read_any_json
from ..errors import DataError

Cell = float | str | None
Row = dict[str, Any]  #: a cell by its column's name


def read(folder: str, name: str) -> list[Row]:
    """Rows of FOLDER/NAME.csv as dictionaries, numbers as numbers, empty cells None; [] where there is no such file."""
    path = os.path.join(folder, name + ".csv")
    if not os.path.exists(path):
        return []
    try:
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            return [{key: _cell(text) for key, text in row.items() if key} for row in csv.DictReader(file)]
    except (OSError, csv.Error) as error:
        raise DataError(f"cannot read {path}: {error}") from None


def _cell(text: str) -> Cell:
    if text in (None, ""):
        return None
    try:
        return float(text)
    except ValueError:
        return text


def summary(folder: str) -> dict[str, Any]:
    path = os.path.join(folder, "reliability.json")
    content = read_any_json(path)
    if not isinstance(content, dict) or not isinstance(content.get("levels"), list):
        raise DataError(f"{path} is no summary of a reliability study")
    return content


def shown(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def short(key: str) -> str:
    """`superstructure.period_s` is `period_s` to a reader of a picture."""
    return key.rsplit(".", 1)[-1]


class Layout:
    """Panels (systems alike in all but the series key) and series (values of the first difference's key)."""

    def __init__(self, keys: list[str], rows: list[Row], series_key: str | None) -> None:
        self.systems: dict[int, Row] = {}
        for row in rows:
            self.systems.setdefault(int(row["system"]), {key: row.get(key) for key in keys})
        self.series_key = series_key if series_key in keys else None
        told = [self.series_key] if self.series_key else []
        for key in keys:  # a key that the others tell (a case's name, what is linked to them) names no panel
            if key != self.series_key and not self._is_told(key, told):
                told.append(key)
        self.panel_keys = [key for key in told if key != self.series_key]
        self.panels: dict[str, list[int]] = {}
        for number, values in self.systems.items():
            label = ", ".join(f"{short(key)} {shown(values[key])}" for key in self.panel_keys) or "all systems"
            self.panels.setdefault(label, []).append(number)

    def _is_told(self, key: str, told: list[str]) -> bool:
        seen: dict[tuple[Cell, ...], Cell] = {}
        for values in self.systems.values():
            if seen.setdefault(tuple(values[k] for k in told), values[key]) != values[key]:
                return False
        return True

    def series(self, system: int) -> str:
        return f"{short(self.series_key)} {shown(self.systems[system][self.series_key])}" if self.series_key else f"system {system}"
