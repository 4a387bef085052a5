"""The impacts a law was fitted to and what the law makes of them: curves.json, else the run folders themselves."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import DataError
from .run_folder import Run
from .series import contact_stretches, impact_curve

if TYPE_CHECKING:
    from .results import Entry


@dataclass
class Curve:
    time: np.ndarray         #: since the reference's touch [s]
    penetration: np.ndarray  #: -gap [m]
    force: np.ndarray        #: > 0 pushes inwards [N]


@dataclass
class ImpactCurve:
    run: str
    source: str  #: measured | finite elements | reduced model
    speed: float | None
    reference: Curve
    law: Curve | None = None
    fitted: bool = True
    grazing: bool = False

    @property
    def name(self) -> str:
        return self.run.rstrip("/").split("/")[-1].removesuffix(".toml")


def read(path: str, data: dict[str, Any]) -> list[ImpactCurve]:
    """Of a checked curves.json. Throws DataError where lists differ in length."""
    return [_impact(path, i, item) for i, item in enumerate(data.get("impacts", []))]


def _impact(path: str, i: int, item: dict[str, Any]) -> ImpactCurve:
    curves = {part: _curve(f"{path}: impacts[{i}].{part}", item.get(part, {})) for part in ("reference", "law")}
    return ImpactCurve(item.get("run", ""), item.get("source", ""), item.get("approach_speed_m_s"), curves["reference"],
                       curves["law"], item.get("fitted", True), item.get("grazing", False))


def _curve(where: str, data: dict[str, Any]) -> Curve:
    values = [np.array(data.get(key, []), float) for key in ("time_s", "penetration_m", "force_N")]
    if len({len(column) for column in values}) > 1:
        raise DataError(f"{where}: time_s, penetration_m and force_N differ in length")
    if not all(np.all(np.isfinite(column)) for column in values):
        raise DataError(f"{where} holds a value that is not a number")
    return Curve(*values)


def of_entries(entries: list[Entry], law: str | None) -> list[ImpactCurve]:
    """The hardest impact of every run, with the reduced model's by `law` where the folder holds it."""
    found = []
    for entry in entries:
        reference = _hardest(entry.fe)
        if reference:
            found.append(ImpactCurve(entry.name, "finite elements", _speed(entry), reference,
                                     _hardest(next((run for run in (entry.law, entry.fitted) if run and run.get("reduced", "impact_law") == law), None))))
    return found


def _hardest(run: Run | None) -> Curve | None:
    parts = contact_stretches(run) if run is not None and run.signals else []
    if run is None or not parts:
        return None
    force = run.norm("impact")
    time, pushing, depth = impact_curve(run, max(parts, key=lambda part: force[part].max()))
    return Curve(time, depth, pushing)


def _speed(entry: Entry) -> float | None:
    speeds = [impact.get("approach_speed_m_s") for impact in (entry.fe.impacts if entry.fe else [])]
    return max((speed for speed in speeds if speed is not None), default=entry.speed)
