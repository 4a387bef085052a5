"""Writes motion.csv: a near-fault-like ground acceleration in g, a Gabor pulse of 2.4 s with a shorter one upon it."""
import numpy as np

time = np.arange(0, 16, 0.005)


def pulse(amplitude: float, period: float, centre: float, cycles: float) -> np.ndarray:
    width = cycles * period / 2
    return amplitude * np.exp(-((time - centre) / width) ** 2) * np.cos(2 * np.pi * (time - centre) / period)


acceleration = pulse(0.24, 2.4, 6.0, 1.6) + pulse(0.12, 0.7, 5.6, 2.5)
np.savetxt("motion.csv", np.column_stack([time, acceleration]), delimiter=",", header="time_s,acceleration_g", comments="", fmt="%.6g")
