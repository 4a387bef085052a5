"""The bearing and its load on the first page: a drawing to scale and the numbers, assumptions with an asterisk."""
import re
from collections.abc import Callable
from typing import Any

from markupsafe import Markup, escape

from .. import bearing as geometry
from ..context import Context
from ..figures import bearing as drawing
from ..figures import triple
from ..markup import sentence
from ..numbers import is_number, plain, scaled
from ..triple import faces

STAR = Markup("<b class=\"star\">*</b>")
RIGID = {"radius_m": ("radius of both plates", "m"), "capacity_m": ("travel to the rims", "m"), "travel_mm": ("travel on a plate", "mm"),
         "slider_diameter_mm": ("slider", "mm"), "rim_height_mm": ("rim height", "mm"), "slider_mass_kg": ("slider's mass", "kg")}
INNER = {"radius_m": ("radius of the inner slider's faces", "m"), "travel_mm": ("travel of the inner slider on a slide plate", "mm"),
         "diameter_mm": ("inner slider", "mm")}


def make(context: Context) -> dict[str, Any]:
    scene = context.scene
    if not scene:
        return {"name": context.results.answer.get("bearing", ""), "rows": _load(context), "figure": None,
                "remark": "The bearing's dimensions are not stored with these results."}
    if context.rigid_bodies:
        table = scene.get("isolator", {})
        figure = context.pictures.figure("bearing", "", triple.section, table) if faces(table) and "inner" in table else None
        return {"name": table.get("name") or context.rigid_bodies, "rows": _rigid(table) + _load(context), "figure": figure,
                "remark": "Section to scale; dashed: at rest, filled: where the last rim is touched." if figure else ""}
    bearing = scene.get("bearing", {})
    figure = context.pictures.figure("bearing", "", drawing.draw, bearing, context.capacity, context.whole_bearing)
    remark = "Section to scale, mm; dashed: at rest, filled: where it touches the rim." if figure else ""
    if figure and {"pad.outer_radius_mm", "pad.thickness_mm"} <= context.assumed:
        remark += " The pad is an assumption."
    return {"name": bearing.get("name", ""), "rows": _rows(bearing, context.capacity, context.assumed) + _load(context), "figure": figure,
            "remark": remark + ("" if context.whole_bearing or not figure else " Pad and foot do not take part in what was run.")}


RATES = {"cowper-symonds": ("Cowper and Symonds", (("rate_D_per_s", "D", "\u00a01/s"), ("rate_q", "q", ""))),
         "johnson-cook": ("Johnson and Cook", (("rate_C", "C", ""), ("rate_reference_per_s", "from", "\u00a01/s")))}


def _rate_row(steel: dict[str, Any], mark: Callable[[str], str]) -> list[list[Any]]:
    """The law of the strain rate, where the steel has one."""
    if steel.get("rate") not in RATES:
        return []
    name, constants = RATES[steel["rate"]]
    value = Markup(f"grows with its rate, {name}")
    for key, symbol, unit in constants:
        value += Markup(f", {symbol}\u00a0{plain(steel.get(key))}{unit}") + mark(key)
    return [["Steel at speed", value]]


HARDENING = {"table": ("a table", ()), "swift": ("Swift", (("hardening_K_MPa", "K", "\u00a0MPa"), ("hardening_e0", "e0", ""), ("hardening_n", "n", ""))),
             "voce": ("Voce", (("hardening_Q_MPa", "Q", "\u00a0MPa"), ("hardening_b", "b", ""))),
             "ludwik": ("Ludwik", (("hardening_K_MPa", "K", "\u00a0MPa"), ("hardening_n", "n", "")))}


def _hardening(steel: dict[str, Any], mark: Callable[[str], str]) -> Markup:
    """Behind the yield stress: the tangent of two straight lines, or the law and its constants."""
    if steel.get("hardening") not in HARDENING:
        tangent = steel.get("tangent_modulus_MPa")
        return Markup(f", tangent {plain(tangent)}\u00a0MPa") + mark("tangent_modulus_MPa") if is_number(tangent) else Markup("")
    name, constants = HARDENING[steel["hardening"]]
    value = Markup(f", then {name}")
    if steel["hardening"] == "table" and isinstance(steel.get("curve"), list):
        value += f" of {len(steel['curve'])} rows"
    for key, symbol, unit in constants:
        value += Markup(f", {symbol}\u00a0{plain(steel.get(key))}{unit}") + mark(key)
    return value


JOINTS: dict[str, Callable[[dict[str, Any]], str]] = {
    "fillet": lambda joint: f"two fillet welds, throat {plain(joint.get('throat_mm'))}\u00a0mm",
    "bolts": lambda joint: f"{plain(joint.get('number'))} bolts {joint.get('size')} {joint.get('grade')} on Ø {plain(joint.get('circle_mm'))}\u00a0mm"}


def _rows(bearing: dict[str, Any], capacity: float | None, assumed: set[str]) -> list[list[Any]]:
    """[label, value] pairs of what shapes an impact."""
    def number(part: str, key: str, unit: str = "") -> Markup:
        found = bearing.get(part, {}).get(key)
        text = escape(plain(found) + unit)
        return text + STAR if f"{part}.{key}" in assumed else text

    surface = bearing.get("surface", {})
    kind = surface.get("kind", "ellipse")
    if geometry.is_double_concave(bearing):
        kind = f"{kind}, two dishes"
    shape = Markup(f"{escape(kind)}, ") + Markup("<i>R</i><sub>0</sub> ") + number("surface", "R0_m", "\u00a0m") \
        if is_number(surface.get("R0_m")) else Markup(escape(kind))
    if is_number(surface.get("a_m")):
        shape += Markup(", <i>a</i> ") + number("surface", "a_m", "\u00a0m")
    tall = Markup(", ") + number("slider", "height_mm", "\u00a0mm high") if "height_mm" in bearing.get("slider", {}) else Markup("")
    rows = [["Surface", shape], ["Planar radius", number("surface", "planar_radius_mm", "\u00a0mm")],
            ["Slider", Markup("Ø ") + number("slider", "diameter_mm", "\u00a0mm") + tall],
            ["Rim", number("rim", "height_mm", "\u00a0mm") + Markup(" high, ") + number("rim", "thickness_mm", "\u00a0mm") + Markup(" thick")]]
    joint = bearing.get("rim", {}).get("connection", {})
    if joint.get("kind") in JOINTS:
        rows.append(["Rim's foot", JOINTS[joint["kind"]](joint)])
    if capacity:
        rows.append([Markup("Travel to the rim, ") + sentence("L_c"), f"{scaled(capacity, 1e3, 1)}\u00a0mm"])
    steel = bearing.get("material", {}).get("steel", {})
    if is_number(steel.get("yield_MPa")):
        mark = lambda key: STAR if f"material.steel.{key}" in assumed else ""  # noqa: E731
        named = f"{escape(steel['grade'])}, " if steel.get("grade", "none") != "none" else ""
        value = Markup(f"{named}yields at {plain(steel['yield_MPa'])}\u00a0MPa") + mark("yield_MPa") + _hardening(steel, mark)
        rows.append(["Steel", value])
        rows += _rate_row(steel, mark)
    return rows


def _rigid(isolator: dict[str, Any]) -> list[list[str]]:
    return [[label, f"{plain(table[key])}\u00a0{unit}"] for table, words in ((isolator, RIGID), (isolator.get("inner", {}), INNER))
            for key, (label, unit) in words.items() if is_number(table.get(key))]


def _load(context: Context) -> list[list[Any]]:
    """What main.json, the answer or the scene says, in this order; with an asterisk where nobody gave it."""
    results = context.results
    scene = context.scene.get("load", {})
    sources = (results.main.get("load", {}), results.answer, scene)
    pick = lambda key: next((s[key] for s in sources if is_number(s.get(key))), None)  # noqa: E731
    rows: list[list[Any]] = []
    for key, label, unit in (("vertical_kN", "Dead load", "kN"), ("mass_kg", "Supported mass", "kg")):
        if pick(key) is not None:
            text = escape(f"{plain(pick(key))}\u00a0{unit}")
            rows.append([label, text + STAR if _load_is_assumed(context) else text])
    return rows


def _load_is_assumed(context: Context) -> bool:
    """As main.json says, else by the marks of the scene, both of its keys."""
    said = context.results.main.get("load", {}).get("assumed")
    return bool(said) if said is not None else {"load.vertical_kN", "load.mass_kg"} <= context.assumed


STACK = ("pad.", "foot.", "material.ertalyte.", "contact.pad_foot", "contact.steel_ertalyte")


def takes_part(context: Context, key: str) -> bool:
    return context.whole_bearing or not key.startswith(STACK)


def as_number(value: Any) -> Any:
    """Of a text that is a number with a point: the answer has values as the bearing file writes them, to the last digit."""
    return float(value) if isinstance(value, str) and re.fullmatch(r"-?\d+\.\d+", value) else value


def assumptions(context: Context) -> list[list[str]]:
    """[key, value] under the names of the bearing file, numbers to six digits; those of the answer, else of the scene's marks. Of pad and foot only where they
    take part in what was run."""
    listed = context.results.answer.get("assumptions")
    if listed:
        return [[item.get("key", ""), plain(as_number(item.get("value")))] for item in listed if takes_part(context, item.get("key", ""))]
    bearing, found = context.scene.get("bearing", {}), []
    for key in sorted(key for key in context.assumed if takes_part(context, key)):
        value = bearing
        for part in key.split("."):
            value = value.get(part) if isinstance(value, dict) else None
        if value is not None and not isinstance(value, dict):
            found.append([key, plain(value)])
    return found
