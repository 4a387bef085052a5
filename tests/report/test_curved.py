"""Cells of second order: the order of their nodes, the shape functions of their faces, what the pictures make of them."""
import unittest

import numpy as np
import synthetic_mesh
from support import InFolder

from report import hexahedra, mesh_picture, rim_picture, vtu
from report.painter import boundary_faces, merged

RING = dict(shape=(2, 3, 2), mapping=lambda a, b, c: synthetic_mesh._polar(0.5 + 0.1 * a, 0.9 * b, 0.1 * c))


def curved_ring():
    points, cells = synthetic_mesh.block(**RING)
    return synthetic_mesh.second_order(points, cells)


class Faces(unittest.TestCase):
    def test_shape_functions_are_one_at_their_node_and_sum_to_one(self):
        s, t = np.array([0, 1, 1, 0, 0.5, 1, 0.5, 0, 0.5]), np.array([0, 0, 1, 1, 0, 0.5, 1, 0.5, 0.5])
        for n in (4, 8, 9):
            np.testing.assert_allclose(hexahedra.shape_functions(n, s[:n], t[:n]), np.eye(n), atol=1e-14)
            anywhere = hexahedra.shape_functions(n, *np.random.default_rng(1).uniform(size=(2, 50)))
            np.testing.assert_allclose(anywhere.sum(axis=0), 1.0)

    def test_the_wall_is_round_between_its_nodes(self):
        points, cells = curved_ring()
        faces, _ = boundary_faces(hexahedra.from_vtk(cells, points), merged(points))
        wall = np.all(np.abs(np.hypot(points[faces][..., 0], points[faces][..., 1]) - 0.6) < 1e-9, axis=1)
        self.assertEqual(wall.sum(), 3 * 2)
        quads, _ = hexahedra.patches(points[faces[wall]], np.zeros((6, 4)))
        off = np.abs(np.hypot(quads[..., 0], quads[..., 1]) - 0.6).max()
        chord = 0.6 * (1 - np.cos(0.15))
        self.assertLess(off, 0.03 * chord)

    def test_either_order_of_the_upright_edges_is_read(self):
        points, cells = curved_ring()
        swapped = cells.copy()
        swapped[:, [18, 19]] = cells[:, [19, 18]]
        np.testing.assert_array_equal(hexahedra.from_vtk(cells, points), hexahedra.from_vtk(swapped, points))

    def test_edges_and_faces_stand_between_their_corners(self):
        points, cells = synthetic_mesh.block((1, 1, 1), lambda a, b, c: (a, b, c))
        points, cells = synthetic_mesh.second_order(points + [2, 0, 0], cells)
        cell = hexahedra.from_vtk(cells, points)[0]
        corners = points[cell[:8]]
        for k, edge in enumerate(hexahedra.EDGES):
            np.testing.assert_allclose(points[cell[8 + k]][2], corners[list(edge)][:, 2].mean(), atol=1e-12)
            self.assertLess(np.linalg.norm(points[cell[8 + k]] - corners[list(edge)].mean(axis=0)), 0.1)
        for k, face in enumerate(hexahedra.FACES):
            self.assertLess(np.linalg.norm(points[cell[20 + k]] - corners[face].mean(axis=0)), 0.1)

    def test_a_linear_field_of_cells_stays_within_its_neighbours(self):
        place, body = np.array([0, 1, 1, 2]), np.zeros(4, int)
        np.testing.assert_allclose(hexahedra.smooth(np.array([1.0, 1.0, 3.0, 3.0]), place, body), [1, 2, 2, 3])
        np.testing.assert_allclose(hexahedra.smooth(np.array([1.0, 1.0, 3.0, 3.0]), place, np.array([0, 0, 1, 1])), [1, 1, 3, 3])


class Files(InFolder):
    def test_a_lagrange_file_keeps_its_middles(self):
        synthetic_mesh.write_vtu(self.path("a.vtu"), cell_type=72, curved=True)
        grid = vtu.read(self.path("a.vtu"))
        self.assertEqual(grid.hexahedra.shape[1], 27)
        model = rim_picture.Deformed(grid, scale=1.0)
        self.assertEqual(model.nodes.shape[1], 9)
        top, _ = rim_picture.draw(grid, self.path("rim.png"))
        self.assertAlmostEqual(top, rim_picture.largest_strain(grid))

    def test_gmshs_27_nodes_are_read_and_drawn(self):
        points, cells = curved_ring()
        ours = hexahedra.from_vtk(cells, points)
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
        lines += [f"{i + 1} {x:.12g} {y:.12g} {z:.12g}" for i, (x, y, z) in enumerate(points)]
        lines += ["$EndNodes", "$Elements", str(len(ours))]
        gmsh = np.empty_like(ours)
        gmsh[:, hexahedra.FROM_GMSH] = ours
        lines += [f"{i + 1} 12 2 1 1 {' '.join(str(n + 1) for n in cell)}" for i, cell in enumerate(gmsh)]
        mesh = mesh_picture.read(self.write("m.msh", "\n".join([*lines, "$EndElements", ""])))
        np.testing.assert_array_equal(mesh.cells, ours)
        mesh_picture.draw(mesh, self.path("m.png"))


if __name__ == "__main__":
    unittest.main()
