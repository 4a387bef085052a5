"""A body of GetFEM whose steel is ours: J2 at finite strain, logarithmic elastic strain, linear isotropic hardening.

With the elastic left Cauchy-Green tensor of the trial step, b = F C_p^-1 F', and D = dev log b (twice the deviatoric strain)
  |G D| - sqrt(2/3) (sigma_0 + H alpha) > 0:   d gamma = that / (2 G + 2 H / 3),   tau' = (G - G^2 2 d gamma / |G D|) D,
  alpha + sqrt(2/3) d gamma,   log b - 2 d gamma D / |D|  (Simo, 1992),
and the pressure kappa log J at 2 x 2 x 2 points, all else at 3 x 3 x 3. GetFEM assembles the forms and derives their tangents. Its own
brick of this law (Simo_Miehe) has the plastic multiplier as a further unknown; Newton's method got no further than 0.27 mm of a push with it.
mm, N, MPa."""
import math
from collections.abc import Callable
from dataclasses import dataclass

import getfem as gf
import numpy as np


@dataclass(frozen=True)
class Steel:
    """[MPa]; `hardening` is the slope over plastic strain, an infinite `yielding` none at all. Density [t/mm^3]."""
    E: float = 200000.0
    nu: float = 0.3
    yielding: float = 360.0
    tangent: float = 1450.0
    density: float = 7.85e-9

    @property
    def shear(self) -> float:
        return self.E / 2 / (1 + self.nu)

    @property
    def bulk(self) -> float:
        return self.E / 3 / (1 - 2 * self.nu)

    @property
    def hardening(self) -> float:
        return self.tangent / (1 - self.tangent / self.E)


def points(degree: int) -> "gf.Integ":
    """Gauss points exact to `degree` a direction: 5 has 3 of them, 3 has 2."""
    return gf.Integ(f"IM_GAUSS_PARALLELEPIPED(3,{degree})")


class Body:
    """One mesh of 27-node cells in a model: displacement `u` + name, plastic strain `a` + name, C_p^-1 `c` + name at the points."""

    def __init__(self, model: "gf.Model", mesh: "gf.Mesh", name: str, steel: Steel, volumetric: int = 3) -> None:
        self.model, self.mesh, self.name, self.steel = model, mesh, name, steel
        self.u = "u" + name
        self.space = gf.MeshFem(mesh, 3)
        self.space.set_fem(gf.Fem("FEM_QK(3,2)"))
        self.full, self.reduced = gf.MeshIm(mesh, points(5)), gf.MeshIm(mesh, points(volumetric))
        self.one, self.nine = gf.MeshImData(self.full, -1, [1]), gf.MeshImData(self.full, -1, [3, 3])
        model.add_fem_variable(self.u, self.space)
        model.add_im_data("a" + name, self.one), model.add_im_data("c" + name, self.nine)
        model.set_variable("c" + name, np.tile(np.eye(3).ravel(), self.nine.nbpts()))
        self.law()

    def law(self) -> None:
        """P : grad v with the first Piola-Kirchhoff stress; written so, GetFEM's tangent takes a sixth of the time of tau : grad v F^-1."""
        s, n, add = self.steel, self.name, self.model.add_macro
        yielding = s.yielding if math.isfinite(s.yielding) else 1e9
        add(f"F{n}", f"(Id(3)+Grad_{self.u})")
        add(f"D{n}", f"Deviator(Logm(F{n}*c{n}*F{n}'))")
        add(f"N{n}", f"({s.shear:.17g}*Norm(D{n})+1e-9)")
        add(f"Y{n}", f"({math.sqrt(2 / 3):.17g}*({yielding:.17g}+{s.hardening:.17g}*a{n}))")
        add(f"G{n}", f"(pos_part(N{n}-Y{n})*{1 / (2 * s.shear + 2 * s.hardening / 3):.17g})")
        add(f"K{n}", f"({s.shear:.17g}*G{n}/N{n})")
        self.model.add_nonlinear_term(self.full, f"({s.shear:.17g}*(1-2*K{n})*D{n}*Inv(F{n})'):Grad_Test_{self.u}")
        self.model.add_nonlinear_term(self.reduced, f"({s.bulk:.17g}*log(Det(F{n}))*Inv(F{n})'):Grad_Test_{self.u}")

    def accept(self) -> None:
        """The plastic state of the step's end becomes that of the next one's start."""
        n, ask = self.name, self.model.interpolation
        back = f"Inv(F{n})*Expm(-K{n}*D{n})*F{n}"
        state = ask(f"{back}*c{n}*({back})'", self.nine)
        strain = ask(f"a{n}+{math.sqrt(2 / 3):.17g}*G{n}", self.one)
        self.model.set_variable("c" + n, state), self.model.set_variable("a" + n, strain)

    def work(self) -> float:
        """Plastic work so far [N mm]: int sigma_0 alpha + H alpha^2 / 2."""
        s, n = self.steel, self.name
        return float(gf.asm_generic(self.full, 0, f"{s.yielding:.17g}*a{n}+{s.hardening / 2:.17g}*a{n}*a{n}", -1, self.model)) if math.isfinite(s.yielding) else 0.0

    def largest_strain(self) -> float:
        return float(self.model.variable("a" + self.name).max())


@dataclass
class Report:
    """Of one solution by Newton's method."""
    converged: bool
    iterations: int


def newton(model: "gf.Model", moved: Callable[[], np.ndarray], tolerance: float = 1e-6, most: int = 15, limit: float = 20.0) -> Report:
    """Whole steps until displacements (`moved`) change by less than `tolerance` [mm]; given up where they change by `limit`."""
    for iteration in range(1, most + 1):
        model.assembly("build_all")
        step = gf.linsolve_mumps(model.tangent_matrix(), model.rhs()).ravel()
        before = moved()
        if not np.all(np.isfinite(step)):
            return Report(False, iteration)
        model.to_variables(model.from_variables() + step)
        change = float(np.abs(moved() - before).max())
        if change > limit:
            return Report(False, iteration)
        if change < tolerance:
            return Report(True, iteration)
    return Report(False, most)
