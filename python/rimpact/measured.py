"""Measured curves from arrays, as files that `calibrate` and `compare` read."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from rimpact.errors import DataError, InputError
from rimpact.scene import Scene

COLUMNS = {"time": "s", "displacement_x": "m", "displacement_y": "m", "impact_x": "N", "impact_y": "N", "force_x": "N", "force_y": "N"}


@dataclass(frozen=True, eq=False)
class Measured:
    """One test in arrays: its scene (bearing, mass, motion), time [s], and signals at these instants: the slider's displacement [m] and
    the rim's force on the mass [N], which pushes back: negative where the displacement is positive.

    y components where the motion is not planar; force_x, force_y: all that the bearing does to the mass, where it is measured.
    uncertainty: what the noise of the arrays does not show, by the keys of [uncertainty]: {"gain": 0.02, "time_ms": 0.1}. estimate_lag: the
    force has a clock or a filter of its own, whose lag is found by momentum and taken off. Raises DataError for arrays that are no record.

    >>> flown = rimpact.run_reduced("impact-window").response
    >>> test = rimpact.Measured("impact-window", flown.index, flown.displacement_x, flown.impact_x, name="test-7")
    >>> test.write("tests").name
    'test-7.toml'
    """
    scene: Scene | str | os.PathLike
    time: ArrayLike
    displacement_x: ArrayLike
    impact_x: ArrayLike
    displacement_y: ArrayLike | None = None
    impact_y: ArrayLike | None = None
    force_x: ArrayLike | None = None
    force_y: ArrayLike | None = None
    name: str = "measured"
    uncertainty: Mapping[str, float] = field(default_factory=dict)
    estimate_lag: bool = False

    def __post_init__(self) -> None:
        if not self.name or "/" in self.name or self.name.startswith("."):
            raise InputError(f'a test\'s name is the name of its files; "{self.name}" is none')
        columns = self._columns()
        shape = columns["time"].shape
        for signal, values in columns.items():
            if values.ndim != 1 or values.shape != shape or len(values) < 2:
                raise DataError(f"{self.name}: {signal} has the shape {values.shape}, time {shape}; all are of one length, two values or more")
            if not np.isfinite(values).all():
                raise DataError(f"{self.name}: {signal} holds numbers that are not finite")

    def _columns(self) -> dict[str, np.ndarray]:
        given = {signal: getattr(self, signal) for signal in COLUMNS}
        return {signal: np.asarray(values, float) for signal, values in given.items() if values is not None}

    def write(self, folder: str | os.PathLike) -> Path:
        """Writes NAME.csv, NAME.toml (a mapping file) and the scene into a folder, and returns the mapping file: what `calibrate`,
        `compare` and the command read. Instants that do not rise (both sides of a step) are written once."""
        place = Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        columns = self._columns()
        kept = np.concatenate([[True], np.diff(columns["time"]) > 0])
        table = np.column_stack([values[kept] for values in columns.values()])
        np.savetxt(place / f"{self.name}.csv", table, fmt="%.17g", delimiter=",", header=",".join(columns), comments="")
        scene = self.scene if isinstance(self.scene, Scene) else Scene(self.scene)
        (place / f"{self.name}-scene.toml").write_text(scene.toml(), encoding="utf-8")
        lines = [f"scene = {json.dumps(self.name + '-scene.toml')}", f"file = {json.dumps(self.name + '.csv')}"]
        for signal in columns:
            lines += [f"[columns.{signal}]", f'column = "{signal}"', f'unit = "{COLUMNS[signal]}"']
            lines += ["estimate_lag = true"] if signal == "impact_x" and self.estimate_lag else []
        lines += ["[uncertainty]", *(f"{key} = {float(value)!r}" for key, value in self.uncertainty.items())] if self.uncertainty else []
        path = place / f"{self.name}.toml"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path
