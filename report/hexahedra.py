"""Hexahedra of 8, 20 or 27 nodes, their faces, and the shape functions that fill a face.

One order of nodes for all readers: the corners as VTK has them, the middles of EDGES, the middles of FACES, the centre."""
from collections.abc import Sequence

import numpy as np

#: the six faces by their corners, outward
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))

_GMSH_EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7))
_GMSH_FACES = ((0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7))
_VTK_FACES = ((0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7))
SIZES = (8, 20, 27)


def _order(edges: Sequence[tuple], faces: Sequence[tuple]) -> list[int]:
    """Where the nodes of the common order stand among a program's own."""
    edge_at = {frozenset(edge): 8 + i for i, edge in enumerate(edges)}
    face_at = {frozenset(face): 20 + i for i, face in enumerate(faces)}
    return [*range(8), *(edge_at[frozenset(edge)] for edge in EDGES), *(face_at[frozenset(face.tolist())] for face in FACES), 26]


FROM_GMSH = _order(_GMSH_EDGES, _GMSH_FACES)
FROM_VTK = _order(EDGES, _VTK_FACES)


def from_gmsh(cells: np.ndarray) -> np.ndarray:
    """(m, 8, 20 or 27) node numbers in gmsh's order, in the common one."""
    return cells[:, FROM_GMSH[:cells.shape[1]]]


def from_vtk(cells: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(m, 8, 20 or 27) node numbers in VTK's order (types 12, 25, 29, and 72 of second order), in the common one. Files of
    type 72 differ in which of the last two upright edges comes first: the places of the nodes tell."""
    cells = cells[:, FROM_VTK[:cells.shape[1]]]
    if cells.shape[1] == 8:
        return cells
    middles = [points[cells[:, list(EDGES[k])]].mean(axis=1) for k in (10, 11)]
    first, last = points[cells[:, 18]], points[cells[:, 19]]
    apart = lambda a, b: np.linalg.norm(a - b, axis=1).sum()  # noqa: E731
    if apart(first, middles[1]) + apart(last, middles[0]) < apart(first, middles[0]) + apart(last, middles[1]):
        cells[:, [18, 19]] = cells[:, [19, 18]]
    return cells


def face_nodes(cells: np.ndarray) -> np.ndarray:
    """(6 m, 4, 8 or 9) nodes of every face: its corners, the middles of its edges from the first corner on, its middle."""
    edge_at = {frozenset(edge): 8 + i for i, edge in enumerate(EDGES)}
    rows = []
    for i, face in enumerate(FACES.tolist()):
        middles = [edge_at[frozenset((face[k], face[(k + 1) % 4]))] for k in range(4)]
        rows.append(face + (middles if cells.shape[1] > 8 else []) + ([20 + i] if cells.shape[1] == 27 else []))
    return cells[:, np.array(rows)].reshape(-1, len(rows[0]))


def shape_functions(n_nodes: int, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """(n_nodes, ...) weights of a face's 4, 8 or 9 nodes at the places (s, t) in 0..1."""
    corners = np.array([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t])
    if n_nodes == 4:
        return corners
    x, y = 2 * s - 1, 2 * t - 1
    if n_nodes == 8:
        middles = np.array([(1 - x * x) * (1 - y), (1 + x) * (1 - y * y), (1 - x * x) * (1 + y), (1 - x) * (1 - y * y)]) / 2
        return np.concatenate([corners - (middles + np.roll(middles, 1, axis=0)) / 2, middles])
    a, b = ([v * (v - 1) / 2, 1 - v * v, v * (v + 1) / 2] for v in (x, y))
    places = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1))
    return np.array([a[i] * b[j] for i, j in places])


def on_grid(values: np.ndarray, fine: int) -> np.ndarray:
    """(n, fine + 1, fine + 1[, d]): values (n, 4, 8 or 9[, d]) at a face's nodes, on an even grid over it."""
    steps = np.linspace(0.0, 1.0, fine + 1)
    weights = shape_functions(values.shape[1], *np.meshgrid(steps, steps, indexing="ij"))
    return np.einsum("kij,nk...->nij...", weights, values)


def patches(nodes: np.ndarray, values: np.ndarray, fine: int = 4) -> tuple[np.ndarray, np.ndarray]:
    """Faces as fine x fine patches: their corners (n, 4, d) and their mean values (n,). `nodes`: (m, 4, 8 or 9, d) places of a
    face's nodes; `values`: (m, 4, 8 or 9)."""
    points, shades = on_grid(nodes, fine), on_grid(values, fine)
    around = [(slice(a, fine + a), slice(b, fine + b)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    corners = np.stack([points[:, i, j] for i, j in around], axis=3).reshape(-1, 4, points.shape[-1])
    return corners, np.mean([shades[:, i, j] for i, j in around], axis=0).reshape(-1)


def outlines(nodes: np.ndarray, fine: int = 4) -> np.ndarray:
    """(m, 4 fine, d): the curved edge around each face, from its first corner on."""
    if nodes.shape[1] == 4:
        return nodes
    points = on_grid(nodes, fine)
    return np.concatenate([points[:, :-1, 0], points[:, -1, :-1], points[:, :0:-1, -1], points[:, 0, :0:-1]], axis=1)


def smooth(values: np.ndarray, place: np.ndarray, body_of_point: np.ndarray) -> np.ndarray:
    """What stands in a cell (one value at all its nodes) as values at nodes: the mean of a body's cells that meet there."""
    key = np.unique(np.column_stack([place, body_of_point]), axis=0, return_inverse=True)[1].reshape(-1)
    return (np.bincount(key, values) / np.maximum(np.bincount(key), 1))[key]
