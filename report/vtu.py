"""Reads the unstructured grids of .vtu files with numpy alone: ASCII, inline base64, appended (base64 or raw),
zlib-compressed or not. Hexahedra of VTK types 12, 25, 29 and Lagrange type 72 of 8 or 27 nodes; a finer Lagrange cell is
read by its eight corners."""
import base64
import re
import xml.etree.ElementTree as tree
import zlib
from dataclasses import dataclass

import numpy as np

from .errors import DataError
from .hexahedra import SIZES, from_vtk

TYPES = {"Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4", "Int64": "i8",
         "UInt64": "u8", "Float32": "f4", "Float64": "f8"}
HEXAHEDRA = (12, 25, 29, 72)


@dataclass
class Grid:
    points: np.ndarray      #: (n, 3) [m]
    hexahedra: np.ndarray   #: (m, 8, 20 or 27) indices in the order of hexahedra.py; the first eight are the corners
    point_data: dict[str, np.ndarray]
    cell_data: dict[str, np.ndarray]  #: of the hexahedra only


def read(path: str) -> Grid:
    """Throws DataError when the file is not a readable unstructured grid with hexahedra."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise DataError(f"cannot read {path}: {error.strerror}") from None
    try:
        return _parse(content)
    except (tree.ParseError, ValueError, KeyError, IndexError, AttributeError, zlib.error) as error:
        raise DataError(f"{path} is not a readable VTU file ({error})") from None


def _parse(content: bytes) -> Grid:
    content, appended = _split_appended(content)
    root = tree.fromstring(content)
    reader = _ArrayReader(root, appended)
    piece = _child(root, "UnstructuredGrid/Piece")
    points = reader.array(_child(piece, "Points/DataArray")).astype(float)
    cells = {item.get("Name", ""): reader.array(item) for item in _child(piece, "Cells")}
    ends = cells["offsets"].astype(np.int64)
    chosen = np.isin(cells["types"], HEXAHEDRA)
    if not chosen.any():
        raise ValueError("no hexahedra in it")
    starts = np.concatenate([[0], ends[:-1]])[chosen]
    sizes = np.diff(ends, prepend=0)[chosen]
    n = int(sizes[0]) if sizes[0] in SIZES and np.all(sizes == sizes[0]) else 8
    nodes = cells["connectivity"].astype(np.int64)[starts[:, None] + np.arange(n)]
    point_data = {item.get("Name", ""): reader.array(item) for item in _children(piece, "PointData")}
    cell_data = {item.get("Name", ""): reader.array(item)[chosen] for item in _children(piece, "CellData")}
    points = points.reshape(-1, 3)
    return Grid(points, from_vtk(nodes, points), point_data, cell_data)


def _child(element: tree.Element, name: str) -> tree.Element:
    found = element.find(name)
    if found is None:
        raise ValueError(f"no {name} in it")
    return found


def _children(piece: tree.Element, name: str) -> list[tree.Element]:
    part = piece.find(name)
    return [] if part is None else list(part)


def _split_appended(content: bytes) -> tuple[bytes, tuple[str, bytes] | None]:
    """Raw appended bytes are no XML: cut them out. Gives the XML without them, and (encoding, bytes) or None."""
    match = re.search(rb"<AppendedData[^>]*encoding=\"(\w+)\"[^>]*>\s*_", content)
    if not match:
        return content, None
    end = content.rindex(b"</AppendedData>")
    head = content[:match.start()] + b"</VTKFile>"
    return head, (match.group(1).decode(), content[match.end():end])


class _ArrayReader:
    def __init__(self, root: tree.Element, appended: tuple[str, bytes] | None) -> None:
        self.compressed = bool(root.get("compressor"))
        self.order = "<" if root.get("byte_order", "LittleEndian") == "LittleEndian" else ">"
        self.header = np.dtype(self.order + TYPES[root.get("header_type", "UInt32")])
        self.appended = appended

    def array(self, item: tree.Element) -> np.ndarray:
        kind = np.dtype(self.order + TYPES[item.get("type", "")])
        if item.get("format", "ascii") == "ascii":
            values = np.array((item.text or "").split(), dtype=float if kind.kind == "f" else np.int64).astype(kind)
        else:
            values = np.frombuffer(self._bytes(item), dtype=kind)
        width = int(item.get("NumberOfComponents", "1") or 1)
        return values.reshape(-1, width) if width > 1 else values

    def _bytes(self, item: tree.Element) -> bytes:
        if item.get("format") == "appended":
            if self.appended is None:
                raise ValueError("no appended data in it")
            encoding, data = self.appended
            data = data[int(item.get("offset", "")):]
            return self._decode(data, raw=encoding == "raw")
        return self._decode("".join((item.text or "").split()).encode(), raw=False)

    def _decode(self, data: bytes, raw: bool) -> bytes:
        size = self.header.itemsize
        if not self.compressed:
            if raw:
                n = int(np.frombuffer(data[:size], self.header)[0])
                return data[size:size + n]
            n = int(np.frombuffer(_base64(data, size), self.header)[0])
            return _base64(data, size + n)[size:]
        first = np.frombuffer(data[:size] if raw else _base64(data, size), self.header)
        length = size * (3 + int(first[0]))
        head = data[:length] if raw else _base64(data, length)
        sizes = np.frombuffer(head, self.header)[3:].astype(int)
        body = data[length:length + int(sizes.sum())] if raw else _base64(data[4 * -(-length // 3):], int(sizes.sum()))
        edges = np.concatenate([[0], np.cumsum(sizes)])
        return b"".join(zlib.decompress(body[a:b]) for a, b in zip(edges[:-1], edges[1:]))


def _base64(data: bytes, n_bytes: int) -> bytes:
    """The first n_bytes that base64 text stands for."""
    return base64.b64decode(data[:4 * -(-n_bytes // 3)])[:n_bytes]
