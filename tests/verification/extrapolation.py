"""The value that a row of meshes tends to."""
from collections.abc import Sequence


def extrapolated(values: Sequence[float]) -> float:
    """Of three meshes, each a given share finer than the last, whose error falls by one power: Aitken's."""
    a, b, c = values
    return c - (c - b) ** 2 / (c - 2 * b + a)
