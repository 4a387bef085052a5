#!/usr/bin/env python3
"""Modal frequencies of buildings against an assembly of its own: members by integrating their
flexibility, all dofs kept, massless ones left to the inverse problem of the pencil (M, K). No formula is shared with buildings/."""
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from scipy.linalg import eigh
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

ECCENTRIC = """name = "eccentric"
x_m = [0.0, 5.0, 12.0]
y_m = [0.0, 4.0, 10.0]
storeys_m = [4.0, 3.0]
load_kN_per_m2 = 8.0
column_x_mm = 400.0
column_y_mm = 600.0
eccentricity = [0.1, -0.3]
shear = {shear}
"""


def member(row, a, b):
    """Stiffness of a cantilever inverted from its flexibility at the far end, carried to both ends by statics."""
    E, G, A, Iy, Iz, J, Asy, Asz = (row[k] for k in ("E_Pa", "G_Pa", "A_m2", "Iy_m4", "Iz_m4", "J_m4", "Asy_m2", "Asz_m2"))
    L = np.linalg.norm(b - a)
    x = (b - a) / L
    z = np.array([row["up_x"], row["up_y"], row["up_z"]])
    z = z - x * (x @ z)
    z /= np.linalg.norm(z)
    axes = np.array([x, np.cross(z, x), z])
    points, weights = np.polynomial.legendre.leggauss(4)
    F = np.zeros((6, 6))
    compliance = np.diag([1 / (E * A), 1 / (G * Asy) if Asy else 0, 1 / (G * Asz) if Asz else 0, 1 / (G * J), 1 / (E * Iy), 1 / (E * Iz)])
    def carry(arm):  # forces and moments at a point from those applied `arm` further along x
        C = np.eye(6)
        C[4, 2], C[5, 1] = -arm, arm
        return C
    for p, w in zip(points, weights):
        s = (p + 1) * L / 2
        F += w * L / 2 * carry(L - s).T @ compliance @ carry(L - s)
    H = np.vstack([-carry(L), np.eye(6)])
    R = np.kron(np.eye(4), axes)
    return R.T @ (H @ np.linalg.inv(F) @ H.T) @ R


def frequencies(folder):
    read = lambda name: np.atleast_1d(np.genfromtxt(folder / f"{name}.csv", delimiter=",", names=True))
    nodes, elements, slabs = read("nodes"), read("elements"), read("diaphragms")
    n, at = len(nodes), np.column_stack([nodes["x_m"], nodes["y_m"], nodes["z_m"]])
    K = np.zeros((6 * n, 6 * n))
    for row in elements:
        i, j = int(row["i"]) - 1, int(row["j"]) - 1
        dofs = np.r_[6 * i : 6 * i + 6, 6 * j : 6 * j + 6]
        K[np.ix_(dofs, dofs)] += member(row, at[i], at[j])
    columns, masses, column_of = [], [], []
    for d, slab in enumerate(slabs):
        inside = np.flatnonzero(nodes["diaphragm"] == d + 1)
        for k in range(3):
            c = np.zeros(6 * n)
            for i in inside:
                if k < 2:
                    c[6 * i + k] = 1
                else:
                    c[6 * i], c[6 * i + 1], c[6 * i + 5] = slab["y_m"] - at[i, 1], at[i, 0] - slab["x_m"], 1
            columns.append(c)
            masses.append(slab["mass_kg"] if k < 2 else slab["inertia_kg_m2"])
            column_of.append(d == 0)
    for i in range(n):
        for k, mass in ((2, nodes["vertical_mass_kg"][i]), (3, 0.0), (4, 0.0)):
            c = np.zeros(6 * n)
            c[6 * i + k] = 1
            columns.append(c)
            masses.append(mass)
            column_of.append(k == 2 and nodes["bearing"][i] == 1)
    keep = ~np.array(column_of)
    T, M = np.array(columns).T[:, keep], np.array(masses)[keep]
    inverse = eigh(np.diag(M), T.T @ K @ T, eigvals_only=True)[::-1]  # 1 / omega^2, zero where no mass is
    return 1 / np.sqrt(inverse[: np.count_nonzero(M)])


def main(program):
    worst = 0
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        cases = ["thesis-2.4"]
        for shear in ("true", "false"):
            cases.append(scratch / f"eccentric-{shear}.toml")
            cases[-1].write_text(ECCENTRIC.format(shear=shear))
        for case in cases:
            ours = np.array(subprocess.run([program, case, scratch], check=True, capture_output=True, text=True).stdout.split(), float)
            theirs = frequencies(scratch)
            assert len(ours) == len(theirs) > 10, (len(ours), len(theirs))
            error = np.abs(ours / theirs - 1).max()
            worst = max(worst, error)
            print(f"{case}: {len(ours)} modes, first periods {2 * np.pi / ours[:3]} s, largest difference {error:.1e}")
    return 0 if worst < 1e-8 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
