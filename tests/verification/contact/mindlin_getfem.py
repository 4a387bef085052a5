#!/usr/bin/env python3
"""Hertz's and Cattaneo-Mindlin's cylinders in GetFEM: its augmented Lagrangian of contact and Coulomb's friction, on the mesh of
verify_contact hertz-cylinder and mindlin-cylinder. mindlin_getfem.py [BASELINES]: compares with the stored tables.

Exit codes: 0; 1 where the two programs differ by more than 1.5 %; 77 where GetFEM (Debian's python3-getfem) is absent (CTest: skipped)."""
import pathlib
import sys

import numpy as np
import scipy.optimize
from alart_curnier import LOAD, RADIUS, E, graded, mean_profile, stored

try:
    import getfem as gf
except ImportError:
    print("skipped: GetFEM (Debian's python3-getfem) is not installed, so there is nothing to compare with")
    sys.exit(77)

TOP, HELD, BOUND = 1, 2, 0.015
SHARES = (0.125, 0.25, 0.375, 0.5)  # of mu P, the tangential load's steps


class Strip:
    """A rigid parabola on an elastic strip, plane strain, small strains; nine-node cells, the volume's part at 2 x 2 points.

    Unknowns are displacement, traction on the strip (quadratic along the top), the parabola's depth and its shift [m, Pa]."""

    def __init__(self, nu: float, b: float, cells: int) -> None:
        self.mesh = self.strip(b, cells)
        self.model = gf.Model("real")
        space, traction = gf.MeshFem(self.mesh, 2), gf.MeshFem(self.mesh, 2)
        space.set_fem(gf.Fem("FEM_QK(2,2)")), traction.set_fem(gf.Fem("FEM_QK(2,2)"))
        full, reduced = (gf.MeshIm(self.mesh, gf.Integ(f"IM_GAUSS_PARALLELEPIPED(2,{degree})")) for degree in (5, 3))
        model, shear, bulk = self.model, E / 2 / (1 + nu), E / 3 / (1 - 2 * nu)
        model.add_fem_variable("u", space), model.add_filtered_fem_variable("t", traction, TOP)
        model.add_variable("depth", 1), model.add_variable("shift", 1)
        width = float(gf.asm_generic(full, 0, "1", TOP, model))
        for name, value in (("scale", E / b), ("mu", 0.0), ("Q", 0.0), ("held", 1.0), ("shift_before", 0.0)):
            model.add_initialized_data(name, value)
        model.add_fem_data("before", space)
        model.add_linear_term(full, f"{2 * shear}*(Sym(Grad_u)-Div_u/3*Id(2)):Grad_Test_u")
        model.add_linear_term(reduced, f"{bulk}*Div_u*Div_Test_u")
        model.add_Dirichlet_condition_with_simplification("u", HELD)
        gap = f"(X(1)*X(1)/{2 * RADIUS}-depth-u(2))"
        slip = "(u-before-[shift-shift_before;0])"
        model.add_nonlinear_term(full, "-t.Test_u", TOP)
        model.add_nonlinear_term(full, f"-(1/scale)*(t-Coulomb_friction_coupled_projection(t,Normal,{slip},{gap},mu,scale)).Test_t", TOP)
        model.add_nonlinear_term(full, f"{1 / width}*(t(2)*{width}+{LOAD})*Test_depth", TOP)
        model.add_nonlinear_term(full, f"(held*{E}*shift+(1-held)*(t(1)-Q*{1 / width}))*Test_shift", TOP)
        model.set_variable("depth", [2 * b * b / RADIUS])  # near the load's; held at first, for without contact nothing holds it

    def strip(self, b: float, cells: int) -> "gf.Mesh":
        """Forty half-widths deep and to each side, graded towards the middle of the top."""
        half = 40 * b * graded(cells, b / (0.45 * cells) / (40 * b))(np.arange(cells + 1) / cells)
        x, z = np.concatenate([-half[:0:-1], half]), -half[::-1]
        mesh = gf.Mesh("cartesian", x, z)
        faces = mesh.outer_faces()
        normals = mesh.normal_of_faces(faces)
        mesh.set_region(TOP, faces[:, normals[1] > 0.5]), mesh.set_region(HELD, faces[:, normals[1] < 0.5])
        return mesh

    def solve(self) -> int:
        """Iterations of Newton's method."""
        size = np.inf
        for iteration in range(1, 60):
            self.model.assembly("build_all")
            step = gf.linsolve_mumps(self.model.tangent_matrix(), self.model.rhs()).ravel()
            self.model.to_variables(self.model.from_variables() + step)
            first, count = self.model.interval_of_variable("u")
            size = float(np.abs(step[first:first + count]).max() / np.abs(self.model.variable("u")).max())
            if size < 1e-9:
                return iteration
        raise RuntimeError(f"Newton's method did not converge: the last of 59 steps was {size:.1e} of the displacement")

    def traction(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Pressure and shear [Pa] at places along the top."""
        values = self.model.interpolation("t", np.vstack([x, np.zeros_like(x)]), self.mesh).reshape(-1, 2)
        return -values[:, 1], values[:, 0]


def run(nu: float, mu: float, cells: int) -> dict[str, float]:
    b = float(np.sqrt(4 * LOAD * RADIUS * (1 - nu ** 2) / (np.pi * E)))
    strip = Strip(nu, b, cells)
    strip.model.disable_variable("depth")
    iterations = strip.solve()
    strip.model.enable_variable("depth")
    iterations += strip.solve()
    x = np.linspace(-1.5 * b, 1.5 * b, 6001)
    p = strip.traction(x)[0].clip(0)
    inside = (p > 0) & (np.abs(x) < 0.8 * b)
    found = {"b": np.sqrt(4 * (p @ x ** 2) / p.sum()),
             "p0": np.sqrt(np.polyfit((x[inside] / b) ** 2, p[inside] ** 2, 1)[1]), "b_exact": b, "p0_exact": 2 * LOAD / np.pi / b, "unknowns": strip.model.nbdof()}
    for share in SHARES if mu > 0 else ():
        strip.model.set_variable("before", strip.model.variable("u")), strip.model.set_variable("shift_before", strip.model.variable("shift"))
        for name, value in (("mu", mu), ("held", 0.0), ("Q", share * mu * LOAD)):
            strip.model.set_variable(name, [value])
        iterations += strip.solve()
    if mu > 0:
        r = 0.4 * b
        p, q = strip.traction(np.linspace(-r, r, 2001))
        ratio = q.mean() / (mu * p.mean())
        found["stick"] = scipy.optimize.brentq(lambda c: c * mean_profile(c * b, r) - (1 - ratio) * mean_profile(b, r), 0.4 + 1e-9, 1)
    return {**found, "iterations": iterations}


def main() -> int:
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "baselines"
    gf.util_trace_level(0)
    print(f"{'# quantity':<28} {'cells':>5} {'GetFEM':>10} {'theory':>10} {'error':>10} {'engine':>10} {'apart':>10} {'unknowns':>9} {'newton':>6}")
    apart: dict[str, float] = {}
    for cells in (10, 15, 22):
        hertz, mindlin = run(0.3, 0.0, cells), run(0.49, 0.3, cells)
        for quantity, value, exact, of, name in (
                ("half-width b [mm]", 1e3 * hertz["b"], 1e3 * hertz["b_exact"], hertz, "hertz-cylinder.txt"),
                ("peak pressure [MPa]", 1e-6 * hertz["p0"], 1e-6 * hertz["p0_exact"], hertz, "hertz-cylinder.txt"),
                ("stick ratio, by traction", mindlin["stick"], np.sqrt(0.5), mindlin, "mindlin-cylinder.txt")):
            engine = stored(folder / name, quantity)
            apart[quantity] = value / engine - 1
            print(f"{quantity:<28} {cells:>5} {value:>10.6g} {exact:>10.6g} {value / exact - 1:>10.2e} {engine:>10.6g} {apart[quantity]:>10.2e}"
                  f" {of['unknowns']:>9} {of['iterations']:>6}")
    worst = max(abs(value) for value in apart.values())
    print(f"# engine: its finest mesh; on GetFEM's finest the programs differ by {worst:.1e} at most (bound {BOUND:g})")
    return 0 if worst <= BOUND else 1


if __name__ == "__main__":
    sys.exit(main())
