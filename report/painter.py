"""Draws the boundary of hexahedral meshes with matplotlib alone: boundary faces, bodies, painter's algorithm."""
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from .hexahedra import FACES, face_nodes


def merged(points: np.ndarray, tolerance: float = 5e-7) -> np.ndarray:
    """For each point the number of its place: cell-wise copies of a node get the same number, also where single
    precision has moved them by a few units in the last place. Per coordinate, values with smaller gaps than
    `tolerance` [m] count as one."""
    place = np.empty(points.shape, dtype=np.int64)
    for axis in range(3):
        order = np.argsort(points[:, axis], kind="stable")
        steps = np.diff(points[order, axis], prepend=points[order[:1], axis]) > tolerance
        place[order, axis] = np.cumsum(steps)
    return np.unique(place, axis=0, return_inverse=True)[1].reshape(-1)


def boundary_faces(cells: np.ndarray, place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(nodes of the faces (n, 4, 8 or 9) as face_nodes() has them, cell of each) of faces that only one cell has; `place` as
    from merged()."""
    faces = face_nodes(cells)
    keys = np.sort(place[faces[:, :4]], axis=1)
    _, first, count = np.unique(keys, axis=0, return_index=True, return_counts=True)
    alone = np.sort(first[count == 1])
    return faces[alone], alone // 6


def bodies(cells: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Number of the connected body of each cell. Cells are connected through a common face, so bodies that only
    touch stay apart."""
    keys = np.sort(place[cells[:, FACES].reshape(-1, 4)], axis=1)
    order = np.lexsort(keys.T)
    same = np.all(keys[order][1:] == keys[order][:-1], axis=1)
    one, other = order[:-1][same] // 6, order[1:][same] // 6
    label = np.arange(len(cells))
    while True:
        lowest = label.copy()
        np.minimum.at(lowest, one, label[other])
        np.minimum.at(lowest, other, label[one])
        lowest = lowest[lowest]
        if np.array_equal(lowest, label):
            return np.unique(label, return_inverse=True)[1]
        label = lowest


def body_of_points(cells: np.ndarray, body: np.ndarray, n_points: int) -> np.ndarray:
    """Body of every point; cell-wise copies of a node are points of their own."""
    of_point = np.zeros(n_points, dtype=np.int64)
    of_point[cells] = body[:, None]
    return of_point


def view(azimuth: float, elevation: float) -> np.ndarray:
    """Orthographic axes (right, up, towards the viewer) for a viewer at azimuth and elevation [deg] around z."""
    a, e = np.radians([azimuth, elevation])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.array([right, np.cross(towards, right), towards])


def turned(vectors: np.ndarray, angle: float) -> np.ndarray:
    """As seen in axes that stand at `angle` [rad] about z."""
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([c * vectors[:, 0] + s * vectors[:, 1], c * vectors[:, 1] - s * vectors[:, 0], vectors[:, 2]])


def normals(rings: np.ndarray) -> np.ndarray:
    """Unit normals of faces (n, 4 k, 3) given by their edge, from the diagonals of its four corners."""
    k = rings.shape[1] // 4
    n = np.cross(rings[:, 2 * k] - rings[:, 0], rings[:, 3 * k] - rings[:, k])
    return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)


def paint(ax: Axes, quads: np.ndarray, colours: np.ndarray, axes: np.ndarray, outlines: np.ndarray | None = None,
          edge: tuple = (0.1, 0.15, 0.2, 0.4), line_width: float = 0.25, shading: float = 0.35) -> None:
    """Draws faces (n, 4, 3) in (n, 4) RGBA colours, far ones first, darker where they turn from the viewer. Faces
    turned away are left out. `outlines`: rings (m, 4 k, 3) whose lines are drawn, hidden like the faces; without it
    every face is outlined."""
    facing = normals(quads) @ axes[2]
    seen = facing > 1e-9
    quads, colours, facing = quads[seen], colours[seen].copy(), facing[seen]
    colours[:, :3] *= (1 - shading + shading * facing)[:, None]
    edges = np.tile(edge, (len(quads), 1)) if outlines is None else colours
    depth = quads.mean(axis=1) @ axes[2]
    flat = list(np.stack([quads @ axes[0], quads @ axes[1]], axis=-1))
    if outlines is not None:
        rings = outlines[normals(outlines) @ axes[2] > 1e-9]
        size = np.linalg.norm(rings[:, rings.shape[1] // 2] - rings[:, 0], axis=1)
        flat += list(np.stack([rings @ axes[0], rings @ axes[1]], axis=-1))
        depth = np.concatenate([depth, rings.mean(axis=1) @ axes[2] + size])
        colours = np.concatenate([colours, np.zeros((len(rings), 4))])
        edges = np.concatenate([edges, np.tile(edge, (len(rings), 1))])
    order = np.argsort(depth)
    ax.add_collection(PolyCollection([flat[i] for i in order], facecolors=colours[order], edgecolors=edges[order],
                                     linewidths=line_width))
    ax.set_aspect("equal", adjustable="datalim")
    ax.autoscale_view()
    ax.axis("off")
