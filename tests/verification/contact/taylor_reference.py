#!/usr/bin/env python3
"""Taylor's copper bar by an independent program: axisymmetric, explicit in time, four-node cells with an averaged volume
change, incremental J2 with Jaumann's rate, frictionless rigid wall. taylor_reference.py [--rate LAW] [CELLS_ACROSS ...]: prints final
length and mushroom radius after 80 us. What verify_contact taylor-bar and taylor-bar-rate take as their reference."""
import argparse
import time

import numpy as np

RADIUS, LENGTH, SPEED, END = 3.2e-3, 32.4e-3, 227.0, 80e-6
E, NU, DENSITY, YIELD, HARDENING = 117e9, 0.35, 8930.0, 400e6, 100e6
G, BULK = E / 2 / (1 + NU), E / 3 / (1 - 2 * NU)
RATES = {"none": None, "cowper-symonds": lambda rate: (rate / 1e6)**0.25, "johnson-cook": lambda rate: 0.025 * np.log(np.maximum(1, rate))}  #: relative overstress
GAUSS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / np.sqrt(3)
CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
N = 0.25 * (1 + np.outer(GAUSS[:, 0], CORNERS[:, 0])) * (1 + np.outer(GAUSS[:, 1], CORNERS[:, 1]))
DN = 0.25 * np.stack([CORNERS[:, 0] * (1 + np.outer(GAUSS[:, 1], CORNERS[:, 1])),
                      CORNERS[:, 1] * (1 + np.outer(GAUSS[:, 0], CORNERS[:, 0]))], axis=1)  # [gauss, direction, corner]


def gradients(x):
    """dN/dx [cell, gauss, direction, corner], volume over 2 pi of each point, its radius; x [cell, corner, 2]."""
    J = np.einsum("gdc,ecx->egdx", DN, x)
    det = J[..., 0, 0] * J[..., 1, 1] - J[..., 0, 1] * J[..., 1, 0]
    inverse = np.stack([np.stack([J[..., 1, 1], -J[..., 0, 1]], -1), np.stack([-J[..., 1, 0], J[..., 0, 0]], -1)], -2) / det[..., None, None]
    r = np.einsum("gc,ec->eg", N, x[..., 0])
    return np.einsum("egxd,gdc->egxc", inverse, DN), det * r, r


def flow(over, strain, dt, overstress):
    """Plastic strain of a step beyond the static yield surface, by bisection where there is a law of the rate."""
    high = over / (3 * G + HARDENING)
    if overstress is None:
        return high
    at, low = over > 0, 0.0
    over, strain, high, all_points = over[at], strain[at], high[at], np.zeros_like(over)
    for _ in range(30):
        middle = 0.5 * (low + high)
        too_far = (3 * G + HARDENING) * middle + (YIELD + HARDENING * (strain + middle)) * overstress(middle / dt) > over
        low, high = np.where(too_far, low, middle), np.where(too_far, middle, high)
    all_points[at] = 0.5 * (low + high)
    return all_points


def update(stress, strain, grad, volume, r, dv, dt, overstress):
    """Stress [cell, gauss, (rr, zz, tt, rz)] and plastic strain after the increments dv [cell, corner, 2] of position."""
    L = np.einsum("egxc,eci->egix", grad, dv)
    de = np.stack([L[..., 0, 0], L[..., 1, 1], np.einsum("gc,ec->eg", N, dv[..., 0]) / r, 0.5 * (L[..., 0, 1] + L[..., 1, 0])], -1)
    swell = de[..., :3].sum(-1)
    mean = (swell * volume).sum(1) / volume.sum(1)  # one volume change a cell
    de[..., :3] -= swell[..., None] / 3
    w = 0.5 * np.arctan(0.5 * (L[..., 0, 1] - L[..., 1, 0])) * 2  # rotation of the increment, from z to r
    c, s = np.cos(w), np.sin(w)
    rr, zz, tt, rz = (stress[..., i] for i in range(4))
    turned = np.stack([c * c * rr + 2 * c * s * rz + s * s * zz, s * s * rr - 2 * c * s * rz + c * c * zz, tt,
                       (c * c - s * s) * rz + c * s * (zz - rr)], -1)
    p = turned[..., :3].sum(-1) / 3
    trial = turned + 2 * G * de
    trial[..., :3] -= p[..., None]
    size = np.sqrt(1.5 * ((trial[..., :3]**2).sum(-1) + 2 * trial[..., 3]**2))
    over = np.maximum(0, size - YIELD - HARDENING * strain)
    step = flow(over, strain, dt, overstress)
    result = trial * (1 - 3 * G * step / np.maximum(size, 1))[..., None]
    result[..., :3] += (p + BULK * mean[:, None])[..., None]
    return result, strain + step


def run(across, overstress):
    along = 5 * across
    nodes = np.array([[RADIUS * i / across, LENGTH * k / along] for k in range(along + 1) for i in range(across + 1)])
    first = (np.arange(along)[:, None] * (across + 1) + np.arange(across)).ravel()
    cells = np.stack([first, first + 1, first + across + 2, first + across + 1], 1)
    x, v = nodes.copy(), np.zeros_like(nodes)
    v[:, 1] = -SPEED
    mass = np.zeros(len(x))
    _, volume, _ = gradients(x[cells])
    np.add.at(mass, cells, DENSITY * np.einsum("eg,gc->ec", volume, N))
    stress, strain, t, steps = np.zeros((len(cells), 4, 4)), np.zeros((len(cells), 4)), 0.0, 0
    axis = nodes[:, 0] == 0
    sound = np.sqrt((BULK + 4 * G / 3) / DENSITY)
    while t < END:
        grad, volume, r = gradients(x[cells])
        sr, sz, st, srz = (volume * stress[..., i] for i in range(4))
        f = np.zeros_like(x)
        fr = np.einsum("eg,egc->ec", sr, grad[..., 0, :]) + np.einsum("eg,egc->ec", srz, grad[..., 1, :]) + np.einsum("eg,gc->ec", st / r, N)
        fz = np.einsum("eg,egc->ec", srz, grad[..., 0, :]) + np.einsum("eg,egc->ec", sz, grad[..., 1, :])
        np.add.at(f, cells, np.stack([fr, fz], -1))
        dt = 0.4 / (sound * np.sqrt((grad**2).sum((2, 3)).max() / 2))
        v -= dt * f / mass[:, None]
        v[axis, 0] = 0
        v[:, 1] = np.maximum(v[:, 1], -x[:, 1] / dt)  # the wall: nothing gets below z = 0
        old = x
        x = x + dt * v
        middle, volume, r = gradients(0.5 * (old + x)[cells])
        stress, strain = update(stress, strain, middle, volume, r, (x - old)[cells], dt, overstress)
        t += dt
        steps += 1
    foot = x[:across + 1]
    return x[:, 1].max(), x[:, 0].max(), foot[:, 0].max(), strain.max(), steps


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--rate", choices=RATES, default="none")
    parser.add_argument("across", type=int, nargs="*", default=(5, 8, 12))
    given = parser.parse_args()
    print(f"{'# cell [mm]':>11} {'length [mm]':>12} {'radius [mm]':>12} {'plastic strain':>15} {'steps':>7} {'seconds':>8}")
    for across in given.across:
        start = time.process_time()
        length, radius, foot, strain, steps = run(across, RATES[given.rate])
        print(f"{1e3 * RADIUS / across:11.3f} {1e3 * length:12.4f} {1e3 * radius:12.4f} {strain:15.3f} {steps:7d} {time.process_time() - start:8.1f}")
