"""The rim's law as a function of the penetration."""
from __future__ import annotations

import os
import tomllib
import warnings
from functools import cached_property

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from rimpact import _core
from rimpact.calibration import Calibration
from rimpact.results import html_of
from rimpact.scene import Scene


class Law:
    """Force of the rim on the slider [N], positive inwards. Call it with numbers or arrays. Beyond `known_depth`, and at rates beyond
    `known_speeds`, it is extrapolated, which a UserWarning says with the bound.

    >>> law = rimpact.law(rimpact.Scene("impact-window", {"reduced.impact_law": "elastoplastic", "reduced.k_i_kN_per_m": 9e5}))
    >>> law.name, law.yields, float(law(1e-3)) > 0
    ('elastoplastic', True, True)
    """

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

    @cached_property
    def known_depth(self) -> tuple[float, str]:
        """How deep the law holds [m], and why. That is what its fastest fitted impact reaches at most, by its energy, or, where no
        range of speeds is known or that lies deeper, the rim's thickness: beyond it a rim has failed."""
        scene = tomllib.loads(self.scene.toml())
        reduced = scene.get("reduced", {})
        thickness = 1e-3 * scene.get("bearing", {}).get("rim", {}).get("thickness_mm", np.inf)  # a double concave one has none
        speed = reduced.get("fitted_to_m_per_s")
        if speed is not None and np.isfinite(thickness):
            mass = reduced.get("fitted_speeds_mass_kg", reduced.get("fitted_mass_kg", self.scene.mass))
            depths = np.linspace(0, thickness, 4001)
            force = np.asarray(self._law.force(depths, 0.0, depths))
            work = np.concatenate([[0], np.cumsum((force[1:] + force[:-1]) / 2 * np.diff(depths))])
            reached = int(np.searchsorted(work, mass * speed**2 / 2))
            if reached < len(depths):
                return float(depths[reached]), f"the law is fitted up to {speed:.3g} m/s, which reaches it at {mass:.6g} kg"
        return thickness, "the rim is no thicker"

    @cached_property
    def known_speeds(self) -> tuple[float, float] | None:
        """Slowest and fastest approach [m/s] that it was fitted to; None where that is not said. A rim's own law was fitted to energies: at
        the mass of `scene` these are other speeds, by the square root of the masses."""
        reduced = tomllib.loads(self.scene.toml()).get("reduced", {})
        ends = reduced.get("fitted_from_m_per_s", 0.0), reduced.get("fitted_to_m_per_s")
        if ends[1] is None:
            return None
        by_mass = np.sqrt(reduced.get("fitted_speeds_mass_kg", self.scene.mass) / self.scene.mass)
        return float(ends[0] * by_mass), float(ends[1] * by_mass)

    def _warn_faster(self, rate: ArrayLike) -> None:
        fastest = float(np.nanmax(np.append(np.abs(np.asarray(rate, float)), 0.0)))
        if self.known_speeds and fastest > self.known_speeds[1] * (1 + 1e-9):
            warnings.warn(f"a rate of {fastest:.4g} m/s lies beyond {self.known_speeds[1]:.4g} m/s, the fastest approach that law {self.name} was fitted to: "
                          "its force there is extrapolated", UserWarning, stacklevel=3)

    def _warn_beyond(self, *penetrations: ArrayLike) -> None:
        deepest = max((float(np.nanmax(np.append(np.asarray(each, float), -np.inf))) for each in penetrations), default=0.0)
        bound, why = self.known_depth
        if deepest > bound * (1 + 1e-9):
            warnings.warn(f"a penetration of {1e3 * deepest:.4g} mm lies beyond {1e3 * bound:.4g} mm, how deep law {self.name} is known: "
                          f"{why}. Its force there is extrapolated; penetrations are in metres", UserWarning, stacklevel=3)

    def __call__(self, penetration: ArrayLike, rate: ArrayLike = 0.0, deepest: ArrayLike | None = None) -> float | np.ndarray:
        """At a penetration [m] and its rate [m/s, > 0 while approaching]. `deepest` [m]: what this place had reached before; without it
        the first loading."""
        self._warn_beyond(penetration, *(() if deepest is None else (deepest,)))
        self._warn_faster(rate)
        return self._law.force(penetration, rate, penetration if deepest is None else deepest)

    def path(self, penetration: ArrayLike, time: ArrayLike | None = None) -> np.ndarray:
        """Along a history of penetrations [m]; the deepest so far is carried along. `time` [s] gives the rates, zero without it."""
        penetration = np.asarray(penetration, float)
        self._warn_beyond(penetration)
        rate = np.zeros_like(penetration) if time is None else np.gradient(penetration, np.asarray(time, float))
        self._warn_faster(rate)
        return self._law.force(penetration, rate, np.maximum.accumulate(np.maximum(penetration, 0)))

    def plot(self, path: str | os.PathLike | None = None) -> object:
        """Force over penetration up to `known_depth`: a matplotlib figure, written to `path` where one is given."""
        from rimpact.drawing import draw_law
        return draw_law(self, path)

    def _repr_html_(self) -> str:
        bound, why = self.known_depth
        facts = {"says": self.description, **self.numbers, "known to a depth of": f"{1e3 * bound:.4g} mm ({why})"}
        if self.known_speeds:
            facts["fitted to approaches of"] = f"{self.known_speeds[0]:.4g} to {self.known_speeds[1]:.4g} m/s at {self.scene.mass:.6g} kg"
        depths = np.linspace(0, bound, 6)[1:]
        table = pd.DataFrame({"penetration (mm)": 1e3 * depths, "first loading (kN)": 1e-3 * np.asarray(self._law.force(depths, 0.0, depths))})
        return html_of(f"law {self.name}", facts, table, [])

    def __repr__(self) -> str:
        return f"Law({self.name!r}, {', '.join(f'{name}={value:.6g}' for name, value in self.numbers.items())})"


def law(source: Calibration | Scene | str | os.PathLike) -> Law:
    """The law of a calibration (or its folder), or of a scene's own [reduced].

    >>> law = rimpact.law(rimpact.Scene("impact-window", {"reduced.impact_law": "no-tension", "reduced.k_i_kN_per_m": 4e5}))
    >>> round(float(law(1e-3)) / 1e3)                      # kN at 1 mm, standing still
    400
    """
    if isinstance(source, Scene):
        return Law(source)
    found = source if isinstance(source, Calibration) else Calibration.load(source)
    settings = {"reduced.calibration": os.path.abspath(found.folder)}
    if found.mass:
        settings |= {"load.mass_kg": found.mass}
    return Law(Scene("impact-window", settings))
