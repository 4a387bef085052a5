"""The picture of the deformed bearing, on a made-up pad and slider: nothing is solved."""
import unittest

import numpy as np
import synthetic_mesh
from support import InFolder

from report import stack_picture
from report.errors import DataError
from report.vtu import Grid


def bearing(travel, angle=0.0, side=1):
    """A ring-shaped pad on the vertex and a slider above it, the half y >= 0 (side 1) or y <= 0, moved."""
    polar = synthetic_mesh._polar
    parts = [synthetic_mesh.block((3, 8, 2), lambda a, b, c: polar(0.02 + 0.05 * a, side * np.pi * b, 0.04 * c)),
             synthetic_mesh.block((4, 8, 3), lambda a, b, c: polar(0.01 + 0.11 * a, side * np.pi * b, 0.06 + 0.1 * c))]
    points = np.concatenate([xyz[corner].reshape(-1, 3) for xyz, corner in parts])
    cells = np.arange(len(points)).reshape(-1, 8)
    if side < 0:
        cells = cells[:, [3, 2, 1, 0, 7, 6, 5, 4]]
    moved = np.tile(travel * np.array([np.cos(angle), np.sin(angle), 0.0]), (len(points), 1))
    pressure = np.where(points[:, 2] < 1e-9, 50.0 + 1e3 * points[:, 0] * np.cos(angle), 0.0)
    return Grid(points, cells, {"displacement": moved, "contact_pressure_MPa": pressure,
                                "von_mises_MPa": np.full(len(points), 100.0)}, {})


def with_plate(grid):
    """A plate below it, whose base faces down as the pad does."""
    points, cells = synthetic_mesh.block((3, 6, 1), lambda a, b, c: synthetic_mesh._polar(0.01 + 0.5 * a, np.pi * b, 0.05 * c - 0.05))
    below, number = points[cells].reshape(-1, 3), np.arange(cells.size).reshape(-1, 8) + len(grid.points)
    zeros = {name: np.zeros((len(below),) + values.shape[1:]) for name, values in grid.point_data.items()}
    return Grid(np.concatenate([grid.points, below]), np.concatenate([grid.hexahedra, number]),
                {name: np.concatenate([values, zeros[name]]) for name, values in grid.point_data.items()}, {})


def between_dishes(travel):
    """Half a slider between two dishes, wider than any pad and curved, whose half of the face moves sideways by a little."""
    def place(a, b, c):
        x, y, z = synthetic_mesh._polar(0.01 + 0.29 * a, np.pi * b, 0.05 * c)
        return [x, y, z + (x**2 + y**2) / 3.1]
    xyz, corner = synthetic_mesh.block((4, 8, 2), place)
    points = xyz[corner].reshape(-1, 3)
    moved = np.tile([travel, 1e-4, 0.0], (len(points), 1))
    return Grid(points, np.arange(len(points)).reshape(-1, 8),
                {"displacement": moved, "contact_pressure_MPa": np.full(len(points), 12.0), "von_mises_MPa": np.full(len(points), 100.0),
                 "part": np.full(len(points), 5.0)}, {})


class StackPicture(InFolder):
    def test_a_slider_between_two_dishes_is_drawn_whole(self):
        stack = stack_picture.Stack(between_dishes(0.3))
        self.assertEqual(len(stack.pad()[0]), 2 * 4 * 8)
        self.assertEqual(len(stack.cut()[0]), 2 * 4 * 2)

    def test_the_plates_base_is_no_pad(self):
        self.assertEqual(len(stack_picture.Stack(with_plate(bearing(0.3))).pad()[0]), 2 * 3 * 8)

    def test_the_pads_face_is_found_and_mirrored(self):
        flat, pressure = stack_picture.Stack(bearing(0.3)).pad()
        self.assertEqual(len(flat), 2 * 3 * 8)
        np.testing.assert_allclose(np.hypot(flat[..., 0], flat[..., 1]).max(), 70.0, rtol=1e-9)
        self.assertLess(flat[..., 1].min(), -60)
        self.assertAlmostEqual(pressure.max(), 120.0)

    def test_travel_to_the_other_side_looks_the_same(self):
        here, there = stack_picture.Stack(bearing(0.3)), stack_picture.Stack(bearing(0.3, np.pi, side=-1))
        for one, other in zip(here.cut(), there.cut()):
            self.assertEqual(one.shape, other.shape)
            np.testing.assert_allclose(one.reshape(-1).max(), other.reshape(-1).max(), rtol=1e-9)
        front = lambda stack: stack.pad()[1][stack.pad()[0][..., 0] > 65].max()  # noqa: E731
        self.assertAlmostEqual(front(here), front(there))

    def test_picture_with_the_dish(self):
        x = np.linspace(-0.5, 0.5, 20)
        path = stack_picture.draw(bearing(0.3), self.path("a.png"), (x, 0.2 * x**2))
        with open(path, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_a_file_without_the_fields_is_refused(self):
        grid = bearing(0.1)
        del grid.point_data["von_mises_MPa"]
        with self.assertRaisesRegex(DataError, "von_mises_MPa"):
            stack_picture.draw(grid, self.path("a.png"))


if __name__ == "__main__":
    unittest.main()
