"""Ground motions from arrays: files that scenes read."""
from __future__ import annotations

import hashlib
import os
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from rimpact.errors import DataError, InputError
from rimpact.scene import Scene

UNITS = {"m/s2": 1.0, "g": 9.80665, "cm/s2": 0.01}


def write_record(path: str | os.PathLike, time: ArrayLike, acceleration: ArrayLike, units: str = "m/s2") -> Path:
    """Writes a ground acceleration (CSV: time_s, acceleration_m/s2) that scenes and `motion` read. time [s] rises; units: "m/s2", "g"
    (9.80665 m/s2) or "cm/s2". Raises InputError for another unit, DataError for arrays that are no record.

    >>> rimpact.write_record("sine.csv", np.arange(0, 2, 0.01), np.sin(np.arange(0, 2, 0.01)), "g").name
    'sine.csv'
    """
    if units not in UNITS:
        raise InputError(f'units "{units}" is not known; known are {", ".join(UNITS)}')
    t, a = np.asarray(time, float), np.asarray(acceleration, float)
    if t.ndim != 1 or t.shape != a.shape or len(t) < 2:
        raise DataError(f"a record needs two arrays of the same length, two values or more; these have the shapes {t.shape} and {a.shape}")
    if not (np.isfinite(t).all() and np.isfinite(a).all()):
        raise DataError("a record holds finite numbers only")
    if not (np.diff(t) > 0).all():
        raise DataError(f"the time of a record rises; sample {int(np.argmin(np.diff(t) > 0)) + 1} does not")
    place = Path(path)
    rows = "\n".join(f"{instant:.17g},{value:.17g}" for instant, value in zip(t, UNITS[units] * a))
    place.write_text(f"time_s,acceleration_m/s2\n{rows}\n", encoding="utf-8")
    return place


def with_record(scene: Scene, folder: str | os.PathLike, time: ArrayLike, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None,
                units: str = "m/s2") -> Scene:
    """The scene under a recorded motion: ground accelerations over time [s] along x, and along y and z where they are given. They are
    written to `folder` (made where it is not there), each under a name of its own content (record-x-1f0c....csv), and the scene reads them there:
    another motion is another file, and a worker elsewhere needs the folder.

    >>> times = np.arange(0, 5, 0.01)
    >>> moved = rimpact.with_record(rimpact.Scene("ricker-0.78g-1.0s"), "motions", times, 2.0 * np.sin(4 * times))
    >>> moved["excitation.kind"]
    'record'
    """
    place = Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    settings: dict[str, str] = {"excitation.kind": "record"}
    for axis, values in (("x", x), ("y", y), ("z", z)):
        if values is not None:
            written = write_record(place / f"record-{axis}.part", time, values, units)
            named = place / f"record-{axis}-{hashlib.sha256(written.read_bytes()).hexdigest()[:12]}.csv"
            written.replace(named)
            settings[f"excitation.{axis}"] = os.path.abspath(named)
    return scene.with_settings(settings)
