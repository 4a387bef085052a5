"""Rung rim in GetFEM on our exported mesh: rim and plate, slider, supports, and their contact.  mm, N, MPa; half a bearing.

Contact is sought along the slider's deformed normals by GetFEM's ray tracing. Two ways to carry it:
`points`: pressure = stiffness x depth at every Gauss point of the slider's side (as CalculiX's faces do);
`multipliers`: GetFEM's augmented Lagrangian brick, traction as unknowns of degree 1 or 2 on the slider's side, with Coulomb's friction."""
import pathlib
import sys
from collections.abc import Iterable
from dataclasses import dataclass

import getfem as gf
import numpy as np
from steel import Body, Report, Steel, newton, points

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "verification/explicit_rim"))
from explicit_rim import PLACES, Mesh  # noqa: E402

ORDER = [PLACES[i, j, k] for k in range(3) for j in range(3) for i in range(3)]
GROUPS = {"top": 1, "fixed": 2, "symmetry": 3, "sector_end": 4, "slider_side": 5, "rim_wall": 6}
HELD = 1e9  # spring of planes that hold [MPa/mm]


@dataclass(frozen=True)
class Contact:
    stiffness: float = 1e5  # [MPa/mm]; of multipliers only their scale
    degree: int = 0         # of multipliers; 0: at Gauss points
    friction: float = 0.0   # with multipliers
    reach: float = 15.0     # of the ray tracing [mm]


def getfem_mesh(mesh: Mesh, volumes: Iterable[str]) -> "gf.Mesh":
    """Its cells of these volumes, and its groups as regions numbered as in GROUPS."""
    found, trans = gf.Mesh("empty", 3), gf.GeoTrans("GT_QK(3,2)")
    for volume in volumes:
        for cell in mesh.whole[volume]:
            found.add_convex(trans, np.array([mesh.nodes[cell[i]] for i in ORDER]).T)
    places = found.pts()
    key = lambda x: tuple(np.round(x, 5))
    wanted: dict[str, set[frozenset[tuple[float, ...]]]] = {}
    for group, corners in mesh.quads:
        wanted.setdefault(group, set()).add(frozenset(key(mesh.nodes[n]) for n in corners))
    faces: dict[str, list[tuple[int, int]]] = {}
    for cell, face in found.outer_faces().T:
        own = {key(places[:, p]) for p in found.pid_in_faces(np.array([[cell], [face]]))}
        for group in GROUPS:
            if any(corners <= own for corners in wanted.get(group, ())):
                faces.setdefault(group, []).append((cell, face))
    for group, own in faces.items():
        found.set_region(GROUPS[group], np.array(own).T)
    return found


class RimModel:
    """The slider's top goes where it is told (`target`), or, `free`, along x as one (`way`), its height held."""

    def __init__(self, mesh: Mesh, steel: Steel, contact: Contact, volumetric: int = 3, free: bool = False) -> None:
        self.model, self.contact, self.free = gf.Model("real"), contact, free
        self.rim = Body(self.model, getfem_mesh(mesh, ("plate", "rim")), "r", steel, volumetric)
        self.slider = Body(self.model, getfem_mesh(mesh, ("upper_slider",)), "s", steel, volumetric)
        self.side = gf.MeshIm(self.slider.mesh, points(5))
        self.hold()
        self.touch_by_multipliers() if contact.degree else self.touch_at_points()

    def hold(self) -> None:
        model, rim, slider = self.model, self.rim, self.slider
        model.add_Dirichlet_condition_with_simplification("ur", GROUPS["fixed"])
        for body in (rim, slider):
            model.add_linear_term(body.full, f"{HELD}*{body.u}(2)*Test_{body.u}(2)", GROUPS["symmetry"])
        model.add_linear_term(rim.full, f"{HELD}*(ur.Normal)*(Test_ur.Normal)", GROUPS["sector_end"])
        if self.free:
            model.add_variable("way", 1)
            model.add_linear_term(slider.full, f"{HELD}*((us(1)-way)*(Test_us(1)-Test_way)+us(2)*Test_us(2)+us(3)*Test_us(3))", GROUPS["top"])
        else:
            model.add_initialized_data("target", [0.0, 0.0, 0.0])
            model.add_Dirichlet_condition_with_simplification("us", GROUPS["top"], "target")

    def touch_at_points(self) -> None:
        model, stiffness = self.model, self.contact.stiffness
        if self.contact.friction:
            raise ValueError(f"friction {self.contact.friction} needs multipliers: contact at points has none")
        model.add_raytracing_transformation("rays", self.contact.reach)
        model.add_master_contact_boundary_to_raytracing_transformation("rays", self.rim.mesh, "ur", GROUPS["rim_wall"])
        model.add_slave_contact_boundary_to_raytracing_transformation("rays", self.slider.mesh, "us", GROUPS["slider_side"])
        model.add_macro("outwards", "Transformed_unit_vector(Grad_us, Normal)")
        model.add_macro("depth", "neg_part((Interpolate(X,rays)+Interpolate(ur,rays)-X-us).outwards)")
        model.add_nonlinear_term(self.side, f"Interpolate_filter(rays, {stiffness}*depth*(outwards.(Test_us-Interpolate(Test_ur,rays))), 1)", GROUPS["slider_side"])

    def touch_by_multipliers(self) -> None:
        model, slider = self.model, self.slider
        self.tractions = gf.MeshFem(slider.mesh, 3)  # kept here, for GetFEM's model does not keep it
        self.tractions.set_fem(gf.Fem(f"FEM_QK(3,{self.contact.degree})"))
        self.wall = gf.MeshIm(self.rim.mesh, points(5))
        model.add_filtered_fem_variable("traction", self.tractions, GROUPS["slider_side"])
        for name, value in (("scale", self.contact.stiffness), ("mu", self.contact.friction), ("share", 1.0)):
            model.add_initialized_data(name, value)
        before = ("", "")
        if self.contact.friction:
            model.add_fem_data("before_s", slider.space), model.add_fem_data("before_r", self.rim.space)
            before = ("before_s", "before_r")
        brick = model.add_integral_large_sliding_contact_brick_raytracing("scale", self.contact.reach, "mu", "share", 0)
        model.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, self.side, GROUPS["slider_side"], "us", "traction", before[0])
        model.add_master_contact_boundary_to_large_sliding_contact_brick(brick, self.wall, GROUPS["rim_wall"], "ur", before[1])

    def names(self) -> list[str]:
        """Of the unknowns."""
        return ["ur", "us", *(["way"] if self.free else []), *(["traction"] if self.contact.degree else [])]

    def state(self) -> dict[str, np.ndarray]:
        return {name: self.model.variable(name).copy() for name in self.names()}

    def put(self, state: dict[str, np.ndarray]) -> None:
        for name, values in state.items():
            self.model.set_variable(name, values)

    def solve(self) -> Report:
        return newton(self.model, lambda: np.concatenate([self.model.variable("ur"), self.model.variable("us")]))

    def accept(self) -> None:
        self.rim.accept(), self.slider.accept()
        if self.contact.friction:
            self.model.set_variable("before_s", self.model.variable("us")), self.model.set_variable("before_r", self.model.variable("ur"))

    def force(self) -> np.ndarray:
        """Of the rim on the slider [N]."""
        of = "traction({0})" if self.contact.degree else f"Interpolate_filter(rays, -{self.contact.stiffness}*depth*(outwards({{0}})), 1)"
        return np.array([float(gf.asm_generic(self.side, 0, of.format(i), GROUPS["slider_side"], self.model)) for i in (1, 2, 3)])
