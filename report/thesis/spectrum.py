"""Response spectra of records, 5 % damping: Figure 2-23 and its kind."""
import os
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..errors import DataError
from ..style import FAINT, FE, FITTED, MUTED
from .runs import Runs


def read_at2(path: str) -> tuple[float, np.ndarray]:
    """(time step [s], acceleration [g]) of a PEER file: four lines of header, the last with NPTS and DT."""
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            lines = file.read().splitlines()
        words = lines[3].upper().replace("=", " ").replace(",", " ").split()
        return float(words[words.index("DT") + 1]), np.array(" ".join(lines[4:]).split(), float)
    except (OSError, ValueError, IndexError) as error:
        raise DataError(f"{path} is no AT2 record ({error})") from None


def pseudo_acceleration(dt: float, ground: np.ndarray, periods: np.ndarray, damping: float = 0.05) -> np.ndarray:
    """Largest w^2 |u| of oscillators under the record, in the unit of `ground`: exact for its straight lines between samples, by
    the recursion of Nigam and Jennings (1969), read twenty times a shortest period."""
    n = max(1, int(np.ceil(20 * dt / np.min(periods))))
    fine = np.interp(np.arange((len(ground) - 1) * n + 1) / n, np.arange(len(ground)), ground)
    w, h, xi = 2 * np.pi / np.asarray(periods), dt / n, damping
    wd, decay = w * np.sqrt(1 - xi * xi), np.exp(-xi * w * h)
    s, c = decay * np.sin(wd * h), decay * np.cos(wd * h)
    uu, uv, vu, vv = c + xi * w / wd * s, s / wd, -w * w / wd * s, c - xi * w / wd * s
    u, v, largest = np.zeros_like(w), np.zeros_like(w), np.zeros_like(w)
    for g0, g1 in zip(fine[:-1], fine[1:]):
        slope = (g1 - g0) / h  # u'' + 2 xi w u' + w^2 u = -(g0 + slope t) has a straight line as its particular solution
        lag, rate = 2 * xi * slope / w, -slope / w ** 2
        du, dv = u + (g0 - lag) / w ** 2, v - rate
        u, v = uu * du + uv * dv - (g1 - lag) / w ** 2, vu * du + vv * dv + rate
        np.maximum(largest, np.abs(u), out=largest)
    return w * w * largest


def design_spectrum(periods: np.ndarray, s_s: float, s_1: float, f_a: float = 1.2, f_v: float = 1.4, long_period: float = 8.0) -> np.ndarray:
    """ASCE/SEI 7-16 two-point spectrum [g]; site class C."""
    ms, m1 = f_a * s_s, f_v * s_1
    t_s = m1 / ms
    t = np.asarray(periods)
    return np.where(t < 0.2 * t_s, ms * (0.4 + 3 * t / t_s), np.where(t < t_s, ms, np.where(t < long_period, m1 / t, m1 * long_period / t ** 2)))


def draw_spectra(ax: Axes, panel: dict[str, Any], runs: Runs) -> bool:
    periods = np.geomspace(0.05, 5.0, 60)
    found = [path for path in (os.path.join(runs.records, name) for name in panel.get("records", [])) if os.path.isfile(path)]
    spectra = [pseudo_acceleration(*read_at2(path), periods) for path in found]
    mean_only = panel.get("of") == "mean"
    for k, spectrum in enumerate([] if mean_only else spectra):
        ax.plot(periods, spectrum, color=MUTED if k % 2 else FAINT, lw=0.6, label="records, as recorded" if k == 1 else None)
    if spectra:
        ax.plot(periods, np.mean(spectra, axis=0), color=FE, lw=1.6, label=f"mean of {len(spectra)}, as recorded")
    ax.plot(periods, design_spectrum(periods, 1.67, 0.62), color=FITTED, lw=1.6, label="MCE, ASCE/SEI 7-16, site class C")
    return True
