"""Fields of the VTU files: unit and meaning by name. A name that ends in a unit says it itself."""
from dataclasses import dataclass

UNIT_ENDINGS = {"_MPa": "MPa", "_Pa": "Pa", "_mm": "mm", "_m": "m", "_deg": "°", "_N": "N", "_kN": "kN", "_J": "J"}


@dataclass(frozen=True)
class FieldInfo:
    unit: str
    meaning: str


KNOWN = {
    "displacement": FieldInfo("m", "of the solid's points, from the undeformed model"),
    "von_mises_MPa": FieldInfo("MPa", "equivalent stress, of the mean stress of a cell"),
    "equivalent_plastic_strain": FieldInfo("–", "accumulated, of the most strained point of a cell"),
    "damage": FieldInfo("–", "of the worst point of a cell, by Johnson and Cook; a crack begins at 1"),
    "contact_pressure_MPa": FieldInfo("MPa", "on the touching surfaces, positive where they press"),
    "gap_mm": FieldInfo("mm", "distance of the touching surfaces along their normal; NaN where nothing is opposite"),
    "part": FieldInfo("–", "1 plate, 2 rim, 3 pad, 4 foot, 5 upper slider"),
    "arc_direction_deg": FieldInfo("°", "direction of the touched arc of the rim in plan"),
}


def info_of(name: str) -> FieldInfo:
    """Of any field; a name that is not known and ends in no unit has none."""
    ending = next((ending for ending in sorted(UNIT_ENDINGS, key=len, reverse=True) if name.endswith(ending)), "")
    return KNOWN.get(name, FieldInfo(UNIT_ENDINGS.get(ending, "–"), ""))
