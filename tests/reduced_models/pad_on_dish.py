#!/usr/bin/env python3
"""Slope of the finite pad's lift (reduced_models/bearings/pad_on_dish.h) by another program: a finer quadrature, energies
minimised by Nelder and Mead, differences over 2 mm. Printed for test_riding_height.cc; needs SciPy."""
import numpy as np
from scipy.optimize import minimize

A, B, RO, RI, SHAPE, LOAD = 562.5, 140.625, 70.19, 20.0, 1400.0, 853e3  # [mm, N]
LAYER = 3200.0 * 0.7 / (1.3 * 0.4) / 40.0  # [N/mm^3]
points, weights = np.polynomial.legendre.leggauss(12)
rho = (RO + RI) / 2 + (RO - RI) / 2 * points
angles = (np.arange(96) + 0.5) * np.pi / 96
X = np.outer(rho, np.cos(angles))
Y = np.outer(rho, np.sin(angles))
Z = np.outer(rho**2 / (2 * SHAPE), np.ones(96))
W = np.outer(weights * (RO - RI) / 2 * rho, np.full(96, 2 * np.pi / 96))


def height(r):
    return B - B * np.sqrt(1 - (r / A) ** 2)


def slope(r):
    return B * r / A**2 / np.sqrt(1 - (r / A) ** 2)


def energy(r):
    def of(q):
        x, z = r + np.cos(q[1]) * X - np.sin(q[1]) * Z, q[0] + np.sin(q[1]) * X + np.cos(q[1]) * Z
        radius = np.hypot(x, Y)
        overlap = np.maximum((height(radius) - z) / np.sqrt(1 + slope(radius) ** 2), 0)
        return q[0] + LAYER / 2 * (W * overlap**2).sum() / LOAD

    start = [height(r) - 0.5, np.arctan(slope(r))]
    return minimize(of, start, method="Nelder-Mead", options=dict(xatol=1e-11, fatol=1e-12, maxiter=9000)).fun


for r in (100.0, 310.0, 390.0):
    print(f"{r:5.0f} mm: {(energy(r + 1) - energy(r - 1)) / 2 - slope(r):.6f}")
