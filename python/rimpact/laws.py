"""The rim's law as a function of the penetration."""
from __future__ import annotations

import os

import numpy as np
from numpy.typing import ArrayLike

from rimpact import _core
from rimpact.calibration import Calibration
from rimpact.scene import Scene


class Law:
    """Force of the rim on the slider [N], positive inwards. Call it with numbers or arrays."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._law = _core.Law(scene._core)

    @property
    def name(self) -> str:
        """E.g. elastoplastic."""
        return self._law.name

    @property
    def description(self) -> str:
        """One sentence."""
        return self._law.description

    @property
    def yields(self) -> bool:
        """Whether the rim remembers how deep it was pressed."""
        return self._law.yields

    @property
    def numbers(self) -> dict[str, float]:
        """The element's numbers, each with its unit in the name."""
        return self._law.numbers

    def __call__(self, penetration: ArrayLike, rate: ArrayLike = 0.0, deepest: ArrayLike | None = None) -> float | np.ndarray:
        """At a penetration [m] and its rate [m/s, > 0 while approaching]. `deepest` [m]: what this place had reached before; without it
        the first loading."""
        return self._law.force(penetration, rate, penetration if deepest is None else deepest)

    def path(self, penetration: ArrayLike, time: ArrayLike | None = None) -> np.ndarray:
        """Along a history of penetrations [m]; the deepest so far is carried along. `time` [s] gives the rates, zero without it."""
        penetration = np.asarray(penetration, float)
        rate = np.zeros_like(penetration) if time is None else np.gradient(penetration, np.asarray(time, float))
        return self._law.force(penetration, rate, np.maximum.accumulate(np.maximum(penetration, 0)))

    def __repr__(self) -> str:
        return f"Law({self.name!r}, {', '.join(f'{name}={value:.6g}' for name, value in self.numbers.items())})"


def law(source: Calibration | Scene | str | os.PathLike) -> Law:
    """The law of a calibration (or its folder), or of a scene's own [reduced]."""
    if isinstance(source, Scene):
        return Law(source)
    found = source if isinstance(source, Calibration) else Calibration.load(source)
    settings = {"reduced.calibration": os.path.abspath(found.folder)}
    if found.mass:
        settings |= {"load.mass_kg": found.mass}
    return Law(Scene("impact-window", settings))
