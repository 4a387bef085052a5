"""Damages checkpoints as a user's disk, hand or older version might, with or without making their checksum right again."""
import hashlib
import os
import shutil
from collections.abc import Callable, Iterator

import h5py
import numpy as np

Numbers = dict[str, np.ndarray]
HEADER = 512
MARK = b"rimpact checkpoint, format 10\nsha256 "


def reseal(path: str) -> None:
    """The checksum of what the file holds now: what is wrong in it is then for the reader's checks of each field."""
    with open(path, "rb") as file:
        body = file.read()[HEADER:]
    head = MARK + hashlib.sha256(body).hexdigest().encode() + b"\n"
    with open(path, "wb") as file:
        file.write(head.ljust(HEADER, b"\0") + body)


def numbers(path: str) -> Numbers:
    with h5py.File(path) as file:
        return {name: data[()] for name, data in file["numbers"].items()}


def replace(path: str, name: str, values: np.ndarray | None, sealed: bool = True) -> None:
    """values None: the field is taken away."""
    with h5py.File(path, "r+") as file:
        del file["numbers"][name]
        if values is not None:
            file["numbers"].create_dataset(name, data=np.asarray(values))
    if sealed:
        reseal(path)


def with_entry(values: np.ndarray, index: int, value: float) -> np.ndarray:
    changed = np.array(values, dtype=float)
    changed[index] = value
    return changed


def every_field(kept: Numbers) -> Iterator[tuple[str, str, np.ndarray | None]]:
    """(field, what, values) for each field: taken away, emptied, cut short, or one of its numbers made impossible, in turn."""
    ways: list[tuple[str, Callable[[np.ndarray], np.ndarray | None]]] = [
        ("missing", lambda v: None), ("empty", lambda v: v[:0]), ("short", lambda v: v[:-1]), ("nan", lambda v: with_entry(v, 0, np.nan)),
        ("1e300", lambda v: with_entry(v, -1, 1e300))]
    turn = 0
    for name, values in sorted(kept.items()):
        what, way = ways[turn % len(ways)] if len(values) else ways[0]
        turn += 1
        yield name, what, way(values)


def copy_of(folder: str, name: str) -> str:
    target = os.path.join(os.path.dirname(folder), name)
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(folder, target)
    return target
