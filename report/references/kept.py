"""A kept reference: a run folder in data/references with its scene, its summary and its curve."""
import difflib
import os
from dataclasses import dataclass
from typing import Any

from ..data_files import read_any_json
from ..errors import InputError

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "data", "references")


@dataclass(frozen=True)
class Reference:
    name: str
    folder: str
    summary: dict[str, Any]

    @property
    def scene(self) -> str:
        return os.path.join(self.folder, "scene.toml")

    @property
    def peak_kN(self) -> float:
        return 1e-3 * float(self.summary["peak_impact_force_N"])

    @property
    def wall_time_s(self) -> float:
        """Of the run that was kept, on the machine and with the program of its day."""
        return float(self.summary["wall_time_s"])


def references(folder: str = FOLDER) -> list[Reference]:
    """In the order of their names."""
    names = sorted(name for name in os.listdir(folder) if os.path.isfile(os.path.join(folder, name, "summary.json")))
    return [Reference(name, os.path.join(folder, name), read_any_json(os.path.join(folder, name, "summary.json"))) for name in names]


def chosen(names: list[str], known: list[Reference]) -> list[Reference]:
    """Those named, each once, in the order given; all of them without a name. Throws InputError."""
    by_name = {reference.name: reference for reference in known}
    for name in names:
        if name not in by_name:
            close = difflib.get_close_matches(name, by_name, 1)
            raise InputError(f"{name} is no kept reference" + (f"; did you mean {close[0]}?" if close else f"; there are {', '.join(by_name)}"))
    return [by_name[name] for name in dict.fromkeys(names)] if names else known
