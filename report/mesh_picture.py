"""python3 -m report.mesh_picture FILE.msh OUT.png: a gmsh 2.2 ASCII mesh of hexahedra, its groups in colour. Cells of second
order are drawn as curved as they are.

Left: the volumes; right: the surface groups. Bodies other than the plate and the rim are lifted clear of them."""
import argparse

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba
from matplotlib.patches import Patch

from .errors import DataError, run_main
from .hexahedra import from_gmsh, outlines, patches
from .painter import boundary_faces, paint, view
from .style import BLUE, FITTED, GREEN, INK, MUTED, PURPLE, RIM, SKY, YELLOW, plt, save

HEXAHEDRA, QUADRANGLES = {5: 8, 12: 27, 17: 20}, {3: 4, 10: 9, 16: 8}
VOLUME_COLOURS = ["#9fb3c8", SKY, YELLOW, GREEN, "#e8c9a0", PURPLE]
SURFACE_COLOURS = [BLUE, FITTED, GREEN, YELLOW, PURPLE, SKY, RIM, "#b8860b", "#4d7c8a", "#c97b84", INK, "#8fbc5a"]
GROUND = {"plate", "rim"}


class Mesh:
    """Cells in the order of hexahedra.py: with their middles where all of them have as many, else by their corners."""

    def __init__(self) -> None:
        self.names: dict[tuple[int, int], str] = {}  #: by (dimension, tag)
        self.nodes: np.ndarray = np.empty((0, 3))
        self.cells: np.ndarray = np.empty((0, 8), int)
        self.cell_tags: np.ndarray = np.empty(0, int)
        self.quads: np.ndarray = np.empty((0, 4), int)
        self.quad_tags: np.ndarray = np.empty(0, int)

    def name(self, dimension: int, tag: int) -> str:
        return self.names.get((dimension, tag), f"group {tag}")


def read(path: str) -> Mesh:
    """Throws DataError for anything but a gmsh 2.2 ASCII file with hexahedra."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            lines = file.read().splitlines()
        mesh = _parse(lines)
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None
    except (ValueError, IndexError, KeyError, StopIteration) as error:
        raise DataError(f"{path} is not a readable gmsh 2.2 ASCII mesh ({error})") from None
    if not len(mesh.cells):
        raise DataError(f"{path} holds no hexahedra")
    return mesh


def _parse(lines: list[str]) -> Mesh:
    sections = {line.strip(): i for i, line in enumerate(lines) if line.startswith("$")}
    version, kind, _ = lines[sections["$MeshFormat"] + 1].split()
    if not version.startswith("2") or kind != "0":
        raise ValueError(f"version {version}, type {kind}; 2.2 ASCII is needed")
    mesh = Mesh()
    if "$PhysicalNames" in sections:
        first = sections["$PhysicalNames"]
        for line in lines[first + 2:first + 2 + int(lines[first + 1])]:
            dimension, tag, name = line.split(maxsplit=2)
            mesh.names[int(dimension), int(tag)] = name.strip().strip('"')
    first = sections["$Nodes"]
    table = np.array([line.split() for line in lines[first + 2:first + 2 + int(lines[first + 1])]], dtype=float)
    index = {int(tag): i for i, tag in enumerate(table[:, 0])}
    mesh.nodes = table[:, 1:4]
    first = sections["$Elements"]
    _read_elements(mesh, lines[first + 2:first + 2 + int(lines[first + 1])], index)
    return mesh


def _read_elements(mesh: Mesh, lines: list[str], index: dict[int, int]) -> None:
    cells, cell_tags, quads, quad_tags = [], [], [], []
    for line in lines:
        item = [int(x) for x in line.split()]
        nodes, tag = item[3 + item[2]:], item[3] if item[2] else 0
        if item[1] in HEXAHEDRA:
            cells.append([index[n] for n in nodes[:HEXAHEDRA[item[1]]]])
            cell_tags.append(tag)
        elif item[1] in QUADRANGLES:
            quads.append([index[n] for n in nodes[:4]])
            quad_tags.append(tag)
    n = min(map(len, cells), default=8)
    whole = n if all(len(cell) == n for cell in cells) else 8
    mesh.cells = from_gmsh(np.array([cell[:whole] for cell in cells], int).reshape(-1, whole))
    mesh.quads = np.array(quads, int).reshape(-1, 4)
    mesh.cell_tags, mesh.quad_tags = np.array(cell_tags), np.array(quad_tags)


def draw(mesh: Mesh, path: str) -> str:
    faces, cell = boundary_faces(mesh.cells, np.arange(len(mesh.nodes)))
    tags = mesh.cell_tags[cell]
    lifted = np.array([mesh.name(3, tag) not in GROUND for tag in tags])
    nodes = mesh.nodes[faces]
    if lifted.any() and not lifted.all():
        nodes[lifted] += [0, 0, _clearance(nodes, lifted)]
    fig, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.7), layout="constrained")
    axes = view(205, 28)
    _panel(left, nodes, tags, 3, mesh, VOLUME_COLOURS, axes, "Volumes")
    _panel(right, nodes, _surface_tags(mesh, faces[:, :4]), 2, mesh, SURFACE_COLOURS, axes, "Surface groups")
    fig.suptitle(f"{len(mesh.cells)} hexahedra, {len(mesh.nodes)} nodes", fontsize=8, color=MUTED, x=0.01, ha="left")
    return save(fig, path)


def _clearance(nodes: np.ndarray, lifted: np.ndarray) -> float:
    """Lift that shows the rim's wall below the upper bodies [m]."""
    return 0.9 * (np.ptp(nodes[lifted][:, :, 2]) + np.ptp(nodes[~lifted][:, :, 2]))


def _surface_tags(mesh: Mesh, corners: np.ndarray) -> np.ndarray:
    """Surface group of each boundary face; 0 where it has none."""
    known = {tuple(sorted(quad)): tag for quad, tag in zip(mesh.quads.tolist(), mesh.quad_tags.tolist())}
    return np.array([known.get(tuple(sorted(face)), 0) for face in corners.tolist()])


def _panel(ax: Axes, nodes: np.ndarray, tags: np.ndarray, dimension: int, mesh: Mesh, colours: list[str], axes: np.ndarray,
           title: str) -> None:
    present = [tag for tag in np.unique(tags) if tag]
    colour_of = {tag: to_rgba(colours[i % len(colours)]) for i, tag in enumerate(present)} | {0: to_rgba("#eceff2")}
    fine = 6 if nodes.shape[1] > 4 else 1
    quads, number = patches(nodes, np.repeat(np.arange(len(nodes), dtype=float)[:, None], 4, axis=1), fine)
    face = np.rint(number).astype(int)
    paint(ax, quads, np.array([colour_of[tag] for tag in tags[face]]), axes, outlines=outlines(nodes, fine), edge=(0, 0, 0, 0.45),
          line_width=0.2)
    handles = [Patch(color=colour_of[tag], label=mesh.name(dimension, tag)) for tag in present]
    ax.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=4, handlelength=1.0)
    ax.set_title(title)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.mesh_picture", description=__doc__.splitlines()[0])
    parser.add_argument("msh")
    parser.add_argument("png")
    options = parser.parse_args(arguments)
    draw(read(options.msh), options.png)


if __name__ == "__main__":
    run_main(main, "mesh")
