"""GetFEM's steel of steel.py: a cube of one cell pulled and pushed back along x, free across, against the closed form."""
import math
import sys
import unittest

try:
    import getfem as gf
except ImportError:
    print("skipped: GetFEM (Debian's python3-getfem) is not installed")
    sys.exit(77)
import numpy as np
from steel import Body, Steel, newton

WALLS = {"x": 1, "y": 2, "z": 3, "pulled": 4}


def closed_form(steel: Steel, strains: list[float]) -> list[tuple[float, float]]:
    """Kirchhoff stress and accumulated plastic strain along logarithmic strains of a bar: e = tau / E + e_p, |tau| <= sigma_0 + H alpha."""
    plastic = alpha = 0.0
    found = []
    for strain in strains:
        trial = steel.E * (strain - plastic)
        over = max(0.0, abs(trial) - steel.yielding - steel.hardening * alpha) / (steel.E + steel.hardening)
        plastic, alpha = plastic + math.copysign(over, trial), alpha + over
        found.append((steel.E * (strain - plastic), alpha))
    return found


class Cube:
    def __init__(self, steel: Steel) -> None:
        mesh = gf.Mesh("empty", 3)
        corners = np.array([(x, y, z) for z in (0, 0.5, 1) for y in (0, 0.5, 1) for x in (0, 0.5, 1)])
        mesh.add_convex(gf.GeoTrans("GT_QK(3,2)"), corners.T)
        faces = mesh.outer_faces()
        normals = mesh.normal_of_faces(faces)
        for name, axis, sign in (("x", 0, -1), ("y", 1, -1), ("z", 2, -1), ("pulled", 0, 1)):
            mesh.set_region(WALLS[name], faces[:, sign * normals[axis] > 0.5])
        self.model = gf.Model("real")
        self.body = Body(self.model, mesh, "c", steel)
        self.model.add_initialized_data("aim", [0.0])
        for axis, name in enumerate("xyz", 1):
            self.model.add_linear_term(self.body.full, f"1e12*uc({axis})*Test_uc({axis})", WALLS[name])
        self.model.add_nonlinear_term(self.body.full, "1e12*(uc(1)-aim)*Test_uc(1)", WALLS["pulled"])

    def stretch(self, strain: float) -> tuple[float, float]:
        """Logarithmic; Kirchhoff stress along x and plastic strain, means over the cube."""
        self.model.set_variable("aim", [math.expm1(strain)])
        assert newton(self.model, lambda: self.model.variable("uc"), 1e-12).converged
        s = self.body.steel
        stress = f"({s.shear}*(1-2*Kc)*Dc+{s.bulk}*log(Det(Fc))*Id(3))"
        tau = float(gf.asm_generic(self.body.full, 0, f"{stress}(1,1)", -1, self.model))
        self.body.accept()
        return tau, self.body.largest_strain()


class UniaxialSteel(unittest.TestCase):
    """Bounds: GetFEM's matrix exponential and logarithm are good to some 5e-6 of the elastic strain."""

    def test_pulled_and_pushed_back_it_follows_the_closed_form(self):
        gf.util_trace_level(0)
        steel = Steel()
        strains = [0.0015, 0.003, 0.02, 0.05, 0.048, 0.03, -0.02]
        cube = Cube(steel)
        for strain, (stress, alpha) in zip(strains, closed_form(steel, strains)):
            tau, plastic = cube.stretch(strain)
            self.assertAlmostEqual(tau / stress, 1, delta=2e-5, msg=f"stress at {strain}")
            self.assertAlmostEqual(plastic, alpha, delta=1e-7, msg=f"plastic strain at {strain}")
        self.assertAlmostEqual(cube.body.work(), steel.yielding * alpha + steel.hardening * alpha ** 2 / 2, delta=2e-5 * cube.body.work())


if __name__ == "__main__":
    unittest.main()
