#!/usr/bin/env python3
"""Cross-check of the contact engine: Hertz and Cattaneo-Mindlin, a rigid cylinder on an elastic strip, by another method
and another program. Nodal multipliers are unknowns of a semismooth Newton method on Alart and Curnier's (1991) functions
  lambda_n - max(0, lambda_n - c g) = 0,   lambda_t - proj(lambda_t + c s, |.| <= mu max(0, lambda_n - c g)) = 0;
no penalty is left in the solution, no Gauss point carries contact. Small strains, nine-node elements, plane strain, the mesh
of verify_contact hertz-cylinder and mindlin-cylinder. alart_curnier.py [BASELINES]: compares with the stored tables; exit 1
when the two methods differ by more than 1.5 %."""
import pathlib
import sys

import numpy as np
import scipy.optimize
import scipy.sparse as sparse
import scipy.sparse.linalg

E, RADIUS, LOAD = 200e9, 0.1, 1e6  # [Pa], [m], [N/m]
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(3)
POINTS2, WEIGHTS2 = np.polynomial.legendre.leggauss(2)


def graded(n, first):
    """[0, 1] -> [0, 1], exponential, the first of n cells `first` long (as setups.h)."""
    g = scipy.optimize.brentq(lambda g: np.expm1(g / n) / np.expm1(g) - first, 1e-6, 30)
    return lambda s: np.expm1(g * s) / np.expm1(g)


def line(x):
    """Quadratic shape functions on [-1, 1] and their derivatives."""
    return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]), np.array([x - 0.5, -2 * x, x + 0.5])


def stiffness(nodes, nu):
    """Of one nine-node cell, nodes (3, 3, 2); the volumetric part at 2 x 2 points, so that nu = 0.49 does not lock."""
    lame, shear = E * nu / (1 + nu) / (1 - 2 * nu), E / 2 / (1 + nu)
    bulk = lame + 2 * shear / 3
    K = np.zeros((18, 18))
    for points, weights, deviatoric in ((POINTS, WEIGHTS, True), (POINTS2, WEIGHTS2, False)):
        for x, wx in zip(points, weights):
            for z, wz in zip(points, weights):
                (Nx, dNx), (Nz, dNz) = line(x), line(z)
                d = np.array([np.outer(dNx, Nz).ravel(), np.outer(Nx, dNz).ravel()])
                J = d @ nodes.reshape(9, 2)
                g = np.linalg.solve(J, d)
                B = np.zeros((3, 18))
                B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = g[0], g[1], g[1], g[0]
                m = np.array([1.0, 1.0, 0.0])
                D = shear * (np.diag([2.0, 2.0, 1.0]) - 2 / 3 * np.outer(m, m)) if deviatoric else bulk * np.outer(m, m)
                K += wx * wz * np.linalg.det(J) * B.T @ D @ B
    return K


class Strip:
    """Top nodes' compliance: u = C f, for forces along x and z; sides and bottom are held."""

    def __init__(self, nu, b, cells):
        L, first = 40 * b, b / (0.45 * cells)
        grade = graded(cells, first / L)
        half = L * grade(np.arange(2 * cells + 1) / (2 * cells))
        half[1::2] = L * grade((np.arange(cells) + 0.5) / cells)
        x, z = np.concatenate([-half[:0:-1], half]), -half[::-1]
        number = np.arange(len(x) * len(z)).reshape(len(x), len(z))
        rows, columns, values = [], [], []
        for i in range(0, len(x) - 1, 2):
            for k in range(0, len(z) - 1, 2):
                nodes = np.stack(np.meshgrid(x[i:i + 3], z[k:k + 3], indexing="ij"), axis=-1)
                ids = number[i:i + 3, k:k + 3].ravel()
                dofs = np.stack([2 * ids, 2 * ids + 1], axis=1).ravel()
                rows.append(np.repeat(dofs, 18)), columns.append(np.tile(dofs, 18))
                values.append(stiffness(nodes, nu).ravel())
        n = 2 * number.size
        K = sparse.csc_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (n, n))
        held = np.unique(np.concatenate([number[0], number[-1], number[:, 0]]))
        free = np.setdiff1d(np.arange(n), np.concatenate([2 * held, 2 * held + 1]))
        near = np.abs(x) < 2.5 * b
        top = number[near, -1]
        loaded = np.searchsorted(free, np.concatenate([2 * top, 2 * top + 1]))
        unit = np.zeros((len(free), len(loaded)))
        unit[loaded, np.arange(len(loaded))] = 1
        solved = scipy.sparse.linalg.splu(K[free][:, free]).solve(unit)[loaded]
        self.x, m = x[near], near.sum()
        ends = np.flatnonzero(near)
        share = np.zeros(len(x))
        for i in range(0, len(x) - 1, 2):
            share[i:i + 3] += (x[i + 2] - x[i]) * np.array([1, 4, 1]) / 6
        self.weight = share[ends]
        self.xx, self.xz, self.zx, self.zz = solved[:m, :m], solved[:m, m:], solved[m:, :m], solved[m:, m:]
        self.unknowns = len(free)


def contact(strip, mu, normal, tangential, slip_from, start):
    """Newton on (lambda_n, lambda_t, depth, shift); tractions on the strip: lambda_n downwards, lambda_t along x."""
    m, w, x = len(strip.x), strip.weight, strip.x
    c = E / (x[1] - x[0]) / 10  # any positive number: it scales, it does not enter the solution
    v, iterations = start.copy(), 0
    scale = LOAD * np.concatenate([np.ones(2 * m) / w.sum(), [1, 1]])
    while True:
        ln, lt, depth, shift = v[:m], v[m:2 * m], v[-2], v[-1]
        g = x**2 / (2 * RADIUS) - depth - (strip.zz @ (-w * ln) + strip.zx @ (w * lt))
        s = shift - (strip.xx @ (w * lt) + strip.xz @ (-w * ln) - slip_from)
        dg = np.hstack([strip.zz * w, -strip.zx * w, -np.ones((m, 1)), np.zeros((m, 1))])
        ds = np.hstack([strip.xz * w, -strip.xx * w, np.zeros((m, 1)), np.ones((m, 1))])
        eye_n, eye_t = np.eye(m, 2 * m + 2), np.eye(m, 2 * m + 2, m)
        pressing = ln - c * g > 0
        pressure = np.where(pressing, ln - c * g, 0)
        d_pressure = pressing[:, None] * (eye_n - c * dg)
        trial, d_trial = lt + c * s, eye_t + c * ds
        sticks = np.abs(trial) < mu * pressure
        friction = np.where(sticks, trial, mu * pressure * np.sign(trial))
        d_friction = np.where(sticks[:, None], d_trial, (mu * np.sign(trial))[:, None] * d_pressure)
        balance = np.zeros((2, 2 * m + 2))
        balance[0, :m], balance[1, m:2 * m] = w, w
        R = np.concatenate([ln - pressure, lt - friction, [w @ ln - normal, w @ lt - tangential]])
        J = np.vstack([eye_n - d_pressure, eye_t - d_friction, balance])
        if mu == 0:  # without friction nothing holds the shift
            J[-1], R[-1] = 0, 0
            J[-1, -1] = 1
        if np.abs(R / scale).max() < 1e-10:
            return v, iterations, sticks
        if iterations == 60:
            raise RuntimeError("Newton did not converge")
        column = np.concatenate([np.full(2 * m, LOAD / w.sum()), [1e-6, 1e-6]])
        v = v - column * np.linalg.solve(J * column / scale[:, None], R / scale)
        iterations += 1


def mean_profile(c, r):
    """Mean of sqrt(1 - x^2/c^2) over |x| < r."""
    return 0.5 * (np.sqrt(1 - (r / c)**2) + c / r * np.arcsin(r / c))


def run(nu, mu, cells):
    b = np.sqrt(4 * LOAD * RADIUS * (1 - nu**2) / (np.pi * E))
    strip = Strip(nu, b, cells)
    m, w, x = len(strip.x), strip.weight, strip.x
    even = LOAD / (2 * b) * (np.abs(x) < b)
    start = np.concatenate([even, np.zeros(m), [(strip.zz @ (w * even)).max(), 0]])
    v, iterations, _ = contact(strip, 0.0, LOAD, 0.0, np.zeros(m), start)
    p, moved = v[:m], strip.xz @ (-w * v[:m])
    inside = (p > 0) & (np.abs(x) < 0.8 * b)
    slope, height = np.polyfit((x[inside] / b)**2, p[inside]**2, 1, w=np.sqrt(w[inside]))
    result = {"b": np.sqrt(4 * (w * p) @ x**2 / (w @ p)), "p0": np.sqrt(height), "b_exact": b,
              "p0_exact": 2 * LOAD / np.pi / b, "iterations": iterations, "unknowns": strip.unknowns}
    if mu > 0:
        for share in (0.125, 0.25, 0.375, 0.5):
            v, more, _ = contact(strip, mu, LOAD, share * mu * LOAD, moved, v)
            result["iterations"] += more
        r = 0.4 * b
        # Integrals of the quadratic traction over |x| < r, as verify_contact takes them over its Gauss points.
        edges = np.linspace(-r, r, 2001)
        middle = 0.5 * (edges[1:] + edges[:-1])
        q = np.interp(middle, x, v[m:2 * m]).mean() / (mu * np.interp(middle, x, v[:m]).mean())
        result["stick"] = scipy.optimize.brentq(
            lambda c: c * mean_profile(c * b, r) - (1 - q) * mean_profile(b, r), 0.4 + 1e-9, 1)
    return result


def stored(path, quantity):
    """Last value of a quantity of a stored table."""
    lines = [line for line in path.read_text().splitlines() if line.startswith(quantity)]
    return float(lines[-1][max(34, len(quantity)):].split()[1])


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "baselines"
    rows = []
    for cells in (15, 22, 33):
        r = run(0.3, 0.0, cells)
        rows.append(("half-width b [mm]", cells, 1e3 * r["b"], 1e3 * r["b_exact"], r, "hertz-cylinder.txt"))
        rows.append(("peak pressure [MPa]", cells, 1e-6 * r["p0"], 1e-6 * r["p0_exact"], r, "hertz-cylinder.txt"))
        r = run(0.49, 0.3, cells)
        rows.append(("stick ratio, by traction", cells, r["stick"], np.sqrt(0.5), r, "mindlin-cylinder.txt"))
    print(f"{'# quantity':<28} {'cells':>5} {'value':>10} {'theory':>10} {'error':>10} {'engine':>10} {'apart':>10} {'unknowns':>9} {'newton':>6}")
    apart = {}
    for quantity, cells, value, exact, r, name in rows:
        engine = stored(folder / name, quantity)
        apart[quantity] = value / engine - 1
        print(f"{quantity:<28} {cells:>5} {value:>10.6g} {exact:>10.6g} {value / exact - 1:>10.2e} {engine:>10.6g} "
              f"{apart[quantity]:>10.2e} {r['unknowns']:>9} {r['iterations']:>6}")
    worst = max(abs(value) for value in apart.values())
    print(f"# engine: its finest mesh; the methods' finest meshes differ by {worst:.1e} at most (bound 1.5e-2)")
    return 0 if worst <= 0.015 else 1


if __name__ == "__main__":
    sys.exit(main())
