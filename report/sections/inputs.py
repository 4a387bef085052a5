"""Inputs and assumptions: every number of the resolved scene, those assumed marked as such."""
from collections.abc import Iterator
from typing import Any

from ..blocks import Section, note, table
from ..context import Context
from ..numbers import plain
from .common import title_of

UNITS = {"_kg_per_m3": "kg/m³", "_kN_per_m": "kN/m", "_m_per_s2": "m/s²", "_m_per_s": "m/s", "_s_per_m": "s/m",
         "_MPa": "MPa", "_mm": "mm", "_kN": "kN", "_kg": "kg", "_deg": "°", "_ms": "ms", "_m": "m", "_N": "N",
         "_g": "g", "_per_s": "1/s", "_s": "s"}
# A code that tells rims apart, or the plates a law was fitted between: the rim's dimensions stand above, and a doubt says where they differ.
FITTED_RIM = {"fitted_rim", "fitted_radius_m", "fitted_slider_height_mm", "fitted_slider_diameter_mm", "fitted_rim_height_mm", "fitted_capacity_m"}
LABELS = {
    "surface.R0": "radius of curvature at the vertex", "surface.a": "half-width of the ellipse",
    "surface.planar_radius": "planar radius of the dish", "surface.kind": "sliding surface", "surface.concave": "dishes", "slider.height": "slider's height on its axis",
    "slider.diameter": "diameter of the upper slider", "slider.bottom": "slider's bottom plane above the vertex",
    "slider.top": "slider's top plane above the vertex", "slider.edge_radius": "rounding of the slider's lower edge",
    "rim.height": "rim above the dish's edge", "rim.thickness": "thickness of the rim",
    "rim.ledge": "ledge between dish and rim", "rim.connection.kind": "rim's foot, joint", "rim.connection.throat": "rim's foot, throat of the welds",
    "rim.connection.strength": "rim's foot, strength of the welds", "rim.connection.correlation": "rim's foot, beta_w of the welds",
    "rim.connection.number": "rim's foot, bolts", "rim.connection.size": "rim's foot, size of the bolts", "rim.connection.grade": "rim's foot, grade of the bolts",
    "rim.connection.circle": "rim's foot, circle of the bolts", "rim.connection.partial_factor": "rim's foot, partial factor", "plate.base": "bottom of the plate below the vertex",
    "slider.mu_interface": "friction between the slider's halves", "slider.interface_gap": "slip of the slider's halves to their stop",
    "pad.inner_radius": "pad, inner radius", "pad.outer_radius": "pad, outer radius",
    "pad.thickness": "pad, thickness", "pad.recess": "pad, depth in the foot",
    "pad.shape_radius": "pad, radius its face is shaped to", "foot.radius": "foot, radius",
    "foot.bottom": "foot, flat bottom above the vertex", "foot.shoulder": "foot, shoulder above the vertex",
    "foot.cap_radius": "foot, radius of the spherical cap", "material.steel.E": "steel, Young's modulus",
    "material.steel.nu": "steel, Poisson's ratio", "material.steel.yield": "steel, yield stress",
    "material.steel.tangent_modulus": "steel, tangent modulus past yield", "material.steel.density": "steel, density",
    "material.steel.grade": "steel, grade", "material.steel.hardness_HB": "steel, Brinell hardness",
    "material.steel.hardening": "steel, law of hardening", "material.steel.curve": "steel, curve", "material.steel.curve_kind": "steel, kind of curve",
    "material.steel.hardening_K": "steel, K of the hardening", "material.steel.hardening_e0": "steel, e0 of the hardening",
    "material.steel.hardening_n": "steel, n of the hardening", "material.steel.hardening_Q": "steel, Q of the hardening",
    "material.steel.hardening_b": "steel, b of the hardening", "material.steel.fracture_D1": "steel, D1 of the damage",
    "material.steel.fracture_D2": "steel, D2 of the damage", "material.steel.fracture_D3": "steel, D3 of the damage",
    "material.steel.rate": "steel, law of the strain rate", "material.steel.rate_D": "steel, rate that doubles the flow stress",
    "material.steel.rate_q": "steel, exponent of the rate's law", "material.steel.rate_C": "steel, growth by e-fold of the rate",
    "material.steel.rate_reference": "steel, rate without growth",
    "material.ertalyte.E": "Ertalyte, Young's modulus", "material.ertalyte.nu": "Ertalyte, Poisson's ratio",
    "material.ertalyte.yield": "Ertalyte, yield stress (∞: elastic)",
    "material.ertalyte.density": "Ertalyte, density", "contact.steel_steel": "friction steel on steel",
    "contact.steel_ertalyte": "friction steel on Ertalyte", "contact.rim": "friction slider on rim",
    "contact.pad_foot": "pad on foot", "load.vertical": "dead load W", "load.mass": "supported mass",
    "load.gravity": "gravity", "model.rho_inf": "generalised-α, spectral radius ρ∞", "model.step": "step in contact (0: planned)",
    "reduced.k_i": "impact stiffness k_i", "reduced.restitution": "coefficient of restitution e",
    "reduced.mu_fast": "friction at speed", "reduced.mu_slow": "friction at rest", "reduced.rate": "rate of the velocity law",
    "reduced.normal_force": "normal force from", "reduced.elastic_slip": "elastic slip (park-wen)",
}
PARTS = {"bearing": "Bearing", "isolator": "Bearing of rigid bodies", "load": "Load", "superstructure": "Building",
         "model": "Finite-element model", "reduced": "Reduced model of the first run"}


def make(context: Context) -> Section | None:
    section = Section("inputs", "Inputs and assumptions")
    if not context.scene:
        return None
    section.lead = ("As resolved for the first run, every default written out. An assumption is a value that the bearing file "
                    "marks so; the results depend on it.")
    parts = {part: title for part, title in PARTS.items() if not (part == "bearing" and context.rigid_bodies or part == "model" and context.measured)}
    if context.rigid_bodies:
        parts["isolator"] = context.rigid_bodies.capitalize()
    rows = [row for part, title in parts.items() for row in _rows(context, part, title)]
    section.add(table(["quantity", "value", "unit", ""], rows, left=(0, 2, 3)))
    if not context.assumed:
        section.add(note("The bearing file marks no value as an assumption."))
    section.add(_excitations(context))
    return section


def _rows(context: Context, part: str, title: str) -> list[Any]:
    rows = []
    for key, value in _flat(context.scene.get(part, {})):
        if key in FITTED_RIM:
            continue
        name, unit = split_unit(key)
        marked = (key if part == "bearing" else f"{part}.{key}") in context.assumed
        rows.append([_label(part, name), plain(value), unit,
                     "assumption" if marked else ""])
    return [{"span": title}, *rows] if rows else []


def _label(part: str, name: str) -> str:
    if name.startswith("inner.rims."):  # of a triple pendulum: an element as [reduced] has one
        return "inner rims: " + _label("reduced", name.removeprefix("inner.rims."))
    return LABELS.get(f"{part}.{name}") or LABELS.get(name) or _plain_key(name)


def _flat(tree: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for key, value in tree.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def split_unit(key: str) -> tuple[str, str]:
    """rim.height_mm -> ("rim.height", "mm"); a key without unit is a number or a name."""
    for suffix, unit in UNITS.items():
        if key.endswith(suffix):
            return key.removesuffix(suffix), unit
    return key, ""


def _excitations(context: Context) -> dict[str, Any] | None:
    rows = []
    for entry in context.results.entries:
        run = entry.any_run
        values = run.get("excitation", default={}) if run else {}
        said = ", ".join(f"{_plain_key(split_unit(k)[0])} {plain(v)} {split_unit(k)[1]}".replace(" °", "°").strip()
                         for k, v in values.items() if k not in ("kind", "scale") and v not in ("", []))
        if run:
            rows.append([context.doubts.marked(entry.name, title_of(entry.name)), values.get("kind", ""), plain(values.get("scale")), said])
    return table(["excitation", "kind", "scale", "what it is made of"], rows, left=4, prose=True)


def _plain_key(key: str) -> str:
    return key.replace("_", " ").replace(".", ", ")
