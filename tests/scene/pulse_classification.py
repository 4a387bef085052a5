#!/usr/bin/env python3
"""Pulses of pairs of records as the authors' program finds them: Shahi and Baker (BSSA 104, 2014), PulseClassification on GitHub, and the two
functions of MATLAB that it stands on (cwt, wavefun), written again step by step in NumPy. It shares nothing with io/records/velocity_pulse.cc.

    pulse_classification.py FOLDER PAIRS.csv    prints PAIRS.csv (columns first, second, period_s) with the periods found; empty: no pulse"""
import csv
import pathlib
import re
import sys

import numpy as np

LOW = np.array([0.23037781330885523, 0.7148465705525415, 0.6308807679295904, -0.02798376941698385, -0.18703481171888114, 0.030841381835986965,
                0.032883011666982945, -0.010597401784997278])  #: db4, reconstruction
HIGH = np.array([(-1) ** k * LOW[7 - k] for k in range(8)])


def wavefun(steps: int) -> np.ndarray:
    """psi on [0, 7] in steps of 2^-steps: a zero, the cascade, zeros."""
    values = HIGH
    for _ in range(steps - 1):
        spread = np.zeros(2 * len(values) - 1)
        spread[::2] = values
        values = np.convolve(spread, LOW)
    return np.concatenate([[0], np.sqrt(2.0) ** steps * values, np.zeros(7 * 2 ** steps - len(values))])


INTEGRAL = np.cumsum(wavefun(10)) / 1024
DRAWN = wavefun(4)


def cwt(signal: np.ndarray, scales: np.ndarray) -> np.ndarray:
    rows = []
    for scale in scales:
        nodes = (np.arange(7 * scale + 1) * 1024 // scale).astype(int)
        filtered, length = INTEGRAL[nodes][::-1], len(signal) + 7 * scale
        size = 1 << int(length).bit_length()
        steps = np.diff(np.fft.irfft(np.fft.rfft(signal, size) * np.fft.rfft(filtered, size), size)[:length])
        first = (len(steps) - len(signal)) // 2
        rows.append(-np.sqrt(scale) * steps[first:first + len(signal)])
    return np.array(rows)


def approximation_energy(signal: np.ndarray) -> float:
    """Of what dwt() returns first."""
    extended = np.concatenate([signal[:7][::-1], signal, signal[-7:][::-1]])
    return float(np.sum(np.convolve(extended, LOW[::-1], "valid")[1::2] ** 2))


def analyse(signal: np.ndarray, place: int, row: int, scales: np.ndarray) -> tuple[float, bool, int]:
    """Indicator, whether it is late, scale."""
    fine = np.arange(scales[max(0, row - 1)], scales[min(len(scales) - 1, row + 1)] + 1)
    scale = int(fine[np.argmax(np.abs(cwt(signal, fine)[:, place]))])
    rest, pulse, samples = signal.copy(), np.zeros(len(signal)), np.arange(len(signal))
    near = slice(max(0, place - int(np.ceil(0.4 * scale))), place + int(np.ceil(0.4 * scale)) + 1)
    for _ in range(10):
        heights = cwt(rest, np.array([scale]))[0]
        at = near.start + int(np.argmax(np.abs(heights[near])))
        grid = np.linspace(0, 7, len(DRAWN)) * scale
        pulse += np.interp(samples, grid + at - np.median(grid), DRAWN * heights[at] / np.sqrt(scale), left=0, right=0)
        rest = signal - pulse
    of_signal, of_pulse = (np.cumsum(each ** 2) / np.sum(each ** 2) for each in (signal, pulse))
    late = bool(of_signal[np.nonzero(of_pulse <= 0.05)[0][-1]] >= 0.17)
    pgv = np.abs(signal).max()
    component = 0.63 * np.abs(rest).max() / pgv + 0.777 * approximation_energy(rest) / approximation_energy(signal)
    p, v = (component - 1.208421) / 0.2462717, (pgv - 11.58861) / 18.88015
    return -7.817 - 0.5679 * p ** 2 - 0.1516 * v ** 2 - 3.0253 * p - 1.7396 * v - 2.7156 * p * v, late, scale


def pulse_period(first: np.ndarray, second: np.ndarray, dt: float) -> float | None:
    shortest = int(0.25 / 1.4 / dt)
    scales = shortest + int(np.ceil((15 / 1.4 / dt - shortest) / 50)) * np.arange(51)
    one, two = cwt(first, scales), cwt(second, scales)
    strength, samples = one ** 2 + two ** 2, np.arange(len(first))
    for _ in range(5):
        row, place = np.unravel_index(np.argmax(strength), strength.shape)
        angle = np.arctan(two[row, place] / one[row, place])
        indicator, late, scale = analyse(first * np.cos(angle) + second * np.sin(angle), int(place), int(row), scales)
        if indicator > 0 and not late:
            return 1.4 * scale * dt
        strength[:, np.abs(samples - place) < 0.4 * scales[row]] = 0
    return None


def velocity(path: pathlib.Path) -> tuple[np.ndarray, float]:
    """Of a file of PEER [cm/s], and its step [s]."""
    lines = path.read_text(encoding="latin-1").splitlines()
    interval = re.search(r"DT=\s*([.\d]+)", lines[3])
    if interval is None:
        raise SystemExit(f"{path}: its fourth line has no DT")
    dt = float(interval.group(1))
    return np.cumsum([float(value) for line in lines[4:] for value in line.split()]) * dt * 981, dt


def main(folder: str, table: str) -> None:
    print("first,second,period_s")
    with open(table, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            found = [list(pathlib.Path(folder).rglob(row[each] + ".AT2")) for each in ("first", "second")]
            if not all(found):
                raise SystemExit(f"{row['first']} and {row['second']} are not in {folder}")
            (one, dt), (two, _) = (velocity(each[0]) for each in found)
            length = min(len(one), len(two))
            period = pulse_period(one[:length], two[:length], dt)
            print('"{first}","{second}",'.format(**row) + ("" if period is None else f"{period:.4f}"))


if __name__ == "__main__":
    main(*sys.argv[1:])
