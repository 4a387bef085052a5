"""VTU and mesh files, boundary faces, and the pictures made of them."""
import os
import unittest

import numpy as np
import synthetic_mesh
from support import InFolder, command, in_process

from report import mesh_picture, motion, rim_picture, vtu
from report.errors import DataError
from report.painter import bodies, boundary_faces, merged, normals, view


def is_png(path):
    with open(path, "rb") as file:
        return file.read(8) == b"\x89PNG\r\n\x1a\n"


class Vtu(InFolder):
    def test_every_encoding_reads_the_same(self):
        grids = {}
        for style in ("zlib", "base64", "ascii", "appended-raw"):
            synthetic_mesh.write_vtu(self.path("a.vtu"), style=style)
            grids[style] = vtu.read(self.path("a.vtu"))
        for style, grid in grids.items():
            with self.subTest(style):
                np.testing.assert_allclose(grid.points, grids["zlib"].points, atol=1e-8)
                np.testing.assert_array_equal(grid.hexahedra, grids["zlib"].hexahedra)
                np.testing.assert_allclose(grid.point_data["displacement"], grids["zlib"].point_data["displacement"],
                                           atol=1e-9)

    def test_lagrange_hexahedra(self):
        synthetic_mesh.write_vtu(self.path("a.vtu"), cell_type=72)
        self.assertEqual(vtu.read(self.path("a.vtu")).hexahedra.shape[1], 8)

    def test_many_zlib_blocks(self):
        import base64
        import struct
        import zlib
        values = np.arange(1000, dtype="<f8")
        raw = values.tobytes()
        parts = [raw[i:i + 3000] for i in range(0, len(raw), 3000)]
        packed = [zlib.compress(part) for part in parts]
        header = struct.pack(f"<{3 + len(parts)}I", len(parts), 3000, len(parts[-1]), *map(len, packed))
        text = base64.b64encode(header).decode() + base64.b64encode(b"".join(packed)).decode()
        import xml.etree.ElementTree as tree
        root = tree.fromstring(f'<VTKFile compressor="z"><DataArray type="Float64" format="binary">{text}</DataArray>'
                               "</VTKFile>")
        np.testing.assert_array_equal(vtu._ArrayReader(root, None).array(root[0]), values)

    def test_damage_is_said(self):
        synthetic_mesh.write_vtu(self.path("a.vtu"))
        with open(self.path("a.vtu"), encoding="utf-8") as file:
            content = file.read()
        for damaged in (content[:len(content) // 2], content.replace('format="binary">', 'format="binary">AAAA', 1),
                        content.replace("Piece", "Pizza"), ""):
            with self.assertRaisesRegex(DataError, "not a readable VTU file"):
                vtu.read(self.write("b.vtu", damaged))


class Boundary(unittest.TestCase):
    def test_faces_of_a_block(self):
        points, cells = synthetic_mesh.block((2, 3, 4), lambda a, b, c: (a, b, c))
        faces, _ = boundary_faces(cells, merged(points))
        self.assertEqual(len(faces), 2 * (2 * 3 + 3 * 4 + 2 * 4))
        outward = points[faces].mean(axis=1) - 0.5
        self.assertTrue(np.all(np.sum(normals(points[faces]) * outward, axis=1) > 0))

    def test_cell_wise_nodes_are_joined_and_touching_bodies_stay_apart(self):
        one, cells = synthetic_mesh.block((2, 2, 2), lambda a, b, c: (a, b, c))
        two, _ = synthetic_mesh.block((2, 2, 2), lambda a, b, c: (a + 1.0, b + 1.0, c))  # touches along an edge
        points = np.concatenate([one[cells].reshape(-1, 3), two[cells].reshape(-1, 3)])
        cells = np.arange(len(points)).reshape(-1, 8)
        body = bodies(cells, merged(points))
        self.assertEqual(body.tolist(), [0] * 8 + [1] * 8)

    def test_nodes_in_single_precision_are_joined(self):
        points, cells = synthetic_mesh.block((9, 7, 5), lambda a, b, c: (0.4 + 0.12345 * a, 0.3 * b, 0.1 * c))
        copies = np.concatenate([points[cell] for cell in cells])
        copies = copies + np.random.default_rng(2).uniform(-6e-8, 6e-8, copies.shape)
        self.assertEqual(len(np.unique(merged(copies))), len(points))

    def test_views_are_right_handed(self):
        axes = view(205, 28)
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
        np.testing.assert_allclose(np.cross(axes[0], axes[1]), axes[2], atol=1e-12)


class Rim(InFolder):
    def model(self, **options):
        synthetic_mesh.write_vtu(self.path("a.vtu"), **options)
        return vtu.read(self.path("a.vtu"))

    def test_bodies_and_symmetry_are_told_apart(self):
        model = rim_picture.Deformed(self.model(dent=0.004), scale=1.0)
        self.assertTrue(model.half)
        on_slider = model.nodes[model.on_slider]
        self.assertLess(np.hypot(on_slider[..., 0] - 0.4, on_slider[..., 1]).max(), 0.13)
        self.assertGreater(model.nodes[~model.on_slider][..., 0].max(), 0.559)
        self.assertLess(np.abs(model.nodes[model.on_cut][..., 1]).max(), 1e-9)

    def test_picture(self):
        top, scale = rim_picture.draw(self.model(dent=0.004), self.path("rim.png"))
        self.assertTrue(is_png(self.path("rim.png")))
        self.assertAlmostEqual(top, 0.008, delta=2e-4)
        self.assertIn(scale, (1, 2, 5, 10))

    def test_an_elastic_model_has_no_strain_to_colour(self):
        self.assertEqual(rim_picture.draw(self.model(dent=0.0), self.path("rim.png"))[0], 0.0)

    def test_command(self):
        self.model()
        done = in_process("report.rim_picture", self.path("a.vtu"), self.path("rim.png"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(command("report.rim_picture", self.path("no.vtu"), self.path("rim.png")).returncode, 3)
        self.assertEqual(in_process("report.rim_picture", self.path("a.vtu"), "/proc/no/rim.png").returncode, 6)


class Mesh(InFolder):
    def test_groups_and_picture(self):
        synthetic_mesh.write_msh(self.path("m.msh"))
        mesh = mesh_picture.read(self.path("m.msh"))
        self.assertEqual(mesh.name(3, 5), "upper_slider")
        self.assertEqual(len(mesh.cells), sum(len(cells) for *_, cells in synthetic_mesh.solids()))
        self.assertEqual((mesh.quad_tags == 12).sum(), 12 * 6)
        self.assertTrue(is_png(mesh_picture.draw(mesh, self.path("m.png"))))

    def test_other_files_are_refused(self):
        for content in ("", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nx\n"):
            with self.assertRaises(DataError):
                mesh_picture.read(self.write("m.msh", content))


class Motion(InFolder):
    def test_units_and_picture(self):
        time = np.linspace(0, 10, 2001)
        rows = "\n".join(f"{t},{0.5 * np.sin(t)}" for t in time)
        columns = motion.read(self.write("g.csv", "time_s,acceleration_g\n" + rows))
        self.assertAlmostEqual(np.max(columns["acceleration"]), 0.5 * 9.81, places=4)
        self.assertTrue(is_png(motion.draw(columns, self.path("g.png"))))

    def test_bad_tables_are_refused(self):
        for content in ("", "time,acceleration\n0,1\n", "time,acceleration\n0,1\n1,nan\n", "a,b\n0,1\n1,2\n"):
            with self.assertRaises(DataError):
                motion.read(self.write("g.csv", content))
        self.assertFalse(os.path.exists(self.path("g.png")))


if __name__ == "__main__":
    unittest.main()
