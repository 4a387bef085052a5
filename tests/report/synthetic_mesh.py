"""A coarse rim sector and slider as a VTU file, in the form deal.II writes (cell-wise nodes, base64, zlib), and as a
gmsh 2.2 file. For the tests of the report only: the strain field is painted on, nothing is solved."""
import base64
import functools
import struct
import zlib
from collections.abc import Callable

import numpy as np

Array = np.ndarray
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def block(shape: tuple[int, int, int], mapping: Callable[[Array, Array, Array], tuple[Array, Array, Array]]) -> tuple[Array, Array]:
    """(points, cells) of a structured block: `mapping` takes (3, n) numbers in 0..1 to points."""
    grids = np.meshgrid(*(np.linspace(0, 1, n + 1) for n in shape), indexing="ij")
    points = np.array(mapping(*(g.ravel() for g in grids))).T
    number = np.arange(len(points)).reshape([n + 1 for n in shape])
    cells = [[number[i + a, j + b, k + c] for a, b, c in CORNERS]
             for i in range(shape[0]) for j in range(shape[1]) for k in range(shape[2])]
    return points, np.array(cells)


def _polar(r: Array, angle: Array, z: Array, x0: float = 0.0) -> tuple[Array, Array, Array]:
    return x0 + r * np.cos(angle), r * np.sin(angle), z


def solids() -> list[tuple[str, int, Array, Array]]:
    """[(name, volume tag, points, cells)]: plate, rim (welded to it), slider; the half y >= 0."""
    plate = block((8, 12, 3), lambda a, b, c: _polar(0.40 + 0.16 * a, 0.9 * b**1.5, -0.05 + 0.137 * c))
    rim = block((2, 12, 6), lambda a, b, c: _polar(0.52 + 0.04 * a, 0.9 * b**1.5, 0.087 + 0.06 * c))
    slider = block((5, 14, 6), lambda a, b, c: _polar(0.03 + 0.09 * a, np.pi * b**1.5, 0.10 + 0.10 * c, x0=0.40))
    return [("plate", 1, *plate), ("rim", 2, *rim), ("upper_slider", 5, *slider)]


def _field(points: Array, dent: float) -> tuple[Array, Array]:
    """Displacement and plastic strain: the wall is pushed outwards near the touched line."""
    near = np.exp(-(points[:, 1] / 0.07)**2 - ((points[:, 2] - 0.125) / 0.035)**2)
    outward = dent * near * np.clip((0.60 - points[:, 0]) / 0.08, 0, 1)
    return np.column_stack([outward, 0 * near, -0.15 * outward]), 2.0 * dent * near * (points[:, 0] > 0.46)


def write_vtu(path: str, dent: float = 0.004, style: str = "zlib", cell_type: int = 12, curved: bool = False, stress: bool = False, push: float = 0.0) -> None:
    """style: zlib | base64 | ascii | appended-raw. `curved`: 27 nodes a cell; `stress`: with the other fields of a run;
    `push`: travel of the slider [m]."""
    copied, numbered, start = list[Array](), list[Array](), 0
    for _, _, xyz, corner in solids():
        copies, numbers = second_order(xyz, corner) if curved else (xyz[corner].reshape(-1, 3), np.arange(corner.size).reshape(-1, 8))
        copied.append(copies)
        numbered.append(numbers + start)
        start += len(copies)
    points, cells = np.concatenate(copied), np.concatenate(numbered)
    moved, strain = _field(points, dent)
    moved[:, 0] += push * (points[:, 2] > 0.0999) * (np.hypot(points[:, 0] - 0.4, points[:, 1]) < 0.121)
    others = {"von_mises_MPa": 5e4 * strain, "contact_pressure_MPa": 1e4 * strain} if stress else {}
    appended = list[bytes]()
    arrays = functools.partial(_array, style=style, appended=appended)
    n = len(cells)
    body = "\n".join([
        f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{n}"><Points>',
        arrays("points", points, "Float64"), "</Points><Cells>", arrays("connectivity", cells, "Int32"),
        arrays("offsets", cells.shape[1] * np.arange(1, n + 1), "Int32"), arrays("types", np.full(n, cell_type), "UInt8"),
        "</Cells><PointData>", arrays("displacement", moved, "Float32"),
        arrays("equivalent_plastic_strain", strain, "Float32"),
        *(arrays(name, values, "Float32") for name, values in others.items()), "</PointData></Piece></UnstructuredGrid>"])
    compressor = ' compressor="vtkZLibDataCompressor"' if style == "zlib" else ""
    with open(path, "wb") as file:
        file.write(f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1"{compressor} '
                   f'byte_order="LittleEndian">\n{body}\n'.encode())
        if appended:
            file.write(b'<AppendedData encoding="raw">_' + b"".join(appended) + b"</AppendedData>")
        file.write(b"</VTKFile>\n")


def _array(name: str, values: Array, kind: str, style: str, appended: list[bytes]) -> str:
    code = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "UInt8": "u1"}[kind]
    raw = np.ascontiguousarray(values, dtype=code).tobytes()
    width = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 and name != "connectivity" else ""
    head = f'<DataArray type="{kind}" Name="{name}"{width} '
    if style == "zlib":
        packed = zlib.compress(raw)
        header = struct.pack("<4I", 1, len(raw), len(raw), len(packed))
        text = base64.b64encode(header).decode() + base64.b64encode(packed).decode()
        return head + f'format="binary">{text}</DataArray>'
    if style == "base64":
        return head + f'format="binary">{base64.b64encode(struct.pack("<I", len(raw)) + raw).decode()}</DataArray>'
    if style == "appended-raw":
        offset = sum(map(len, appended))
        appended.append(struct.pack("<I", len(raw)) + raw)
        return head + f'format="appended" offset="{offset}"/>'
    return head + 'format="ascii">' + " ".join(f"{x:.9g}" for x in np.ravel(values)) + "</DataArray>"


def write_msh(path: str) -> None:
    names = {(3, 1): "plate", (3, 2): "rim", (3, 5): "upper_slider", (2, 12): "rim_wall", (2, 18): "slider_side"}
    nodes, elements, start = list[list[float]](), list[tuple[int, int, list[int]]](), 0
    for name, tag, points, cells in solids():
        nodes += points.tolist()
        elements += [(5, tag, (cell + start + 1).tolist()) for cell in cells]
        group, face = {"rim": (12, (0, 3, 7, 4)), "upper_slider": (18, (1, 2, 6, 5))}.get(name, (0, ()))
        wall = np.hypot(points[:, 0] - (0.4 if name == "upper_slider" else 0.0), points[:, 1])
        level = {12: 0.52, 18: 0.12}.get(group, -1)
        elements += [(3, group, (cell[list(face)] + start + 1).tolist()) for cell in cells
                     if group and np.allclose(wall[cell[list(face)]], level)]
        start += len(points)
    with open(path, "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + f"{len(names)}\n")
        file.writelines(f'{d} {t} "{n}"\n' for (d, t), n in names.items())
        file.write(f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n")
        file.writelines(f"{i + 1} {x:.12g} {y:.12g} {z:.12g}\n" for i, (x, y, z) in enumerate(nodes))
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        file.writelines(f"{i + 1} {kind} 2 {tag} {tag} {' '.join(map(str, ids))}\n"
                        for i, (kind, tag, ids) in enumerate(elements))
        file.write("$EndElements\n")


def second_order(points: Array, cells: Array) -> tuple[Array, Array]:
    """(points, cells of 27 nodes in VTK's Lagrange order, cell-wise) of eight-cornered ones bent to the circles about the axis."""
    edges = [(0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (2, 6), (3, 7)]
    faces = [(0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7)]
    groups = [*((k,) for k in range(8)), *edges, *faces, tuple(range(8))]
    r, angle = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])

    def mean(values: Array) -> Array:
        return np.stack([values[cells[:, list(group)]].mean(axis=1) for group in groups], axis=1).reshape(-1)
    radius, turn = mean(r), mean(angle)
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), mean(points[:, 2])]), np.arange(27 * len(cells)).reshape(-1, 27)
