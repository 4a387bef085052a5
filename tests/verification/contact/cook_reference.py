#!/usr/bin/env python3
"""Cook's membrane by an independent code: plane strain, Q2, neo-Hooke (the published 14.74 mm) and Hencky (the solid's).

The published value belongs to a neo-Hookean law; the solid's elastic law is Hencky's. This program meets the published
value with the one and gives the reference of verify_contact's `cook-membrane` with the other.
"""
import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import spsolve

G, NU, TRACTION = 422.5e-3, 0.3, 62.5e-3  # N/mm2, -, N/mm2
K = 2 * G * (1 + NU) / (3 * (1 - 2 * NU))


def neo_hooke(F):
    """First Piola stress in the plane of W = K/4 (J^2 - 1 - 2 ln J) + G/2 (J^(-2/3) tr b - 3)."""
    J = np.linalg.det(F)
    inverse_t = np.swapaxes(np.linalg.inv(F), -1, -2)
    trace = (F ** 2).sum((-1, -2)) + 1
    j = J[..., None, None]
    return K / 2 * (j ** 2 - 1) * inverse_t + G * j ** (-2 / 3) * (F - trace[..., None, None] / 3 * inverse_t)


def hencky(F):
    """First Piola stress in the plane of W = K/2 (ln J)^2 + G |dev ln U|^2."""
    left, s, right = np.linalg.svd(F)
    log = np.log(s)
    volume = log.sum(-1, keepdims=True)
    kirchhoff = K * volume + 2 * G * (log - volume / 3)
    return (left * (kirchhoff / s)[..., None, :]) @ right


def gauss():
    x = np.array([-np.sqrt(0.6), 0, np.sqrt(0.6)])
    w = np.array([5, 8, 5]) / 9
    return x, w


def line(x):
    return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]), np.array([x - 0.5, -2 * x, x + 0.5])


def tip(n, stress, steps=10):
    side = 2 * n + 1
    s, t = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side), indexing="ij")
    nodes = np.stack([48 * s, 44 * s + t * (44 + 16 * s - 44 * s)], -1).reshape(-1, 2)
    cells = np.array([[(2 * i + a) * side + 2 * j + b for a in range(3) for b in range(3)] for i in range(n) for j in range(n)])
    points, weights = gauss()
    gradients, volumes = [], []
    for px, wx in zip(points, weights):
        for py, wy in zip(points, weights):
            (N, dN), (M, dM) = line(px), line(py)
            local = np.stack([np.outer(dN, M).ravel(), np.outer(N, dM).ravel()], -1)
            jacobian = np.einsum("ca i,aj->cij".replace(" ", ""), nodes[cells], local)
            gradients.append(np.einsum("aj,cji->cai", local, np.linalg.inv(jacobian)))
            volumes.append(np.linalg.det(jacobian) * wx * wy)
    dofs = (2 * cells[:, :, None] + np.arange(2)).reshape(len(cells), -1)
    load = np.zeros(2 * len(nodes))
    for j in range(n):  # right edge, traction upwards
        edge = [(side - 1) * side + 2 * j + b for b in range(3)]
        load[2 * np.array(edge) + 1] += TRACTION * 16 / n * np.array([1, 4, 1]) / 6
    free = np.setdiff1d(np.arange(2 * len(nodes)), np.repeat(2 * np.arange(side), 2) + np.tile([0, 1], side))
    u = np.zeros(2 * len(nodes))
    for k in range(1, steps + 1):
        for _ in range(30):
            force, matrix = np.zeros_like(u), sp.csr_matrix((len(u), len(u)))
            local_u = u.reshape(-1, 2)[cells]
            for B, volume in zip(gradients, volumes):
                F = np.eye(2) + np.einsum("cai,caj->cij", local_u, B)
                P = stress(F)
                tangent = np.empty(P.shape + (2, 2))
                for p in range(2):
                    for q in range(2):
                        d = np.zeros((2, 2))
                        d[p, q] = 1e-6
                        tangent[..., p, q] = (stress(F + d) - stress(F - d)) / 2e-6
                np.add.at(force, dofs.ravel(), np.einsum("c,cij,caj->cai", volume, P, B).ravel())
                block = np.einsum("c,cipkq,cap,cbq->caibk", volume, tangent.transpose(0, 1, 2, 3, 4), B, B, optimize=True)
                block = block.reshape(len(cells), dofs.shape[1], -1)
                rows = np.repeat(dofs, dofs.shape[1], 1).ravel()
                columns = np.tile(dofs, (1, dofs.shape[1])).ravel()
                matrix += sp.csr_matrix((block.ravel(), (rows, columns)), matrix.shape)
            residual = (k / steps * load - force)[free]
            if np.abs(residual).max() < 1e-10 * np.abs(load).max():
                break
            u[free] += spsolve(matrix[free][:, free], residual)
        else:
            raise SystemExit("no convergence")
    return u[-1]


if __name__ == "__main__":
    print("# Cook's membrane, tip's rise [mm] by an independent plane-strain Q2 code; published (neo-Hooke): 14.74")
    for n in (4, 8, 16):
        print(f"{n:3d} x {n:<3d} neo-Hooke {tip(n, neo_hooke):.4f}   Hencky {tip(n, hencky):.4f}", flush=True)
