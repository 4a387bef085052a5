"""What the client's pages say, without a word of any language: keys of words.csv, and numbers as the first page writes them."""
from typing import Any

from ..bearing import is_double_concave
from ..context import Context
from ..first_page.device import assumptions
from ..first_page.error_bars import bars
from ..numbers import DASH, fixed, integer, is_number, percent, percent_up, plain, scaled, sig

ORDER = ("k_i", "e", "yield_force", "hardening", "unloading_gain", "hardening_exponent", "unloading_exponent", "exponent")
QUANTITIES = {"Peak force": "peak_force", "Depth": "depth", "Rebound": "rebound", "k_i": "k_i", "e": "e", "Strain": "strain"}


def of(context: Context) -> dict[str, Any]:
    """Parts of the page by name; `law` is None where the folder holds no answer."""
    answer = context.results.answer
    law = answer.get("law") or None
    return {"device": _device(context), "law": _law(law, answer) if law else None, "speeds": _speeds(answer), "pair": _pair(answer.get("pair")),
            "errors": [_error(row) for row in bars(answer.get("errors") or [])], "strength": _strength(answer.get("strain")),
            "assumptions": assumptions(context),
            "doubts": [{"runs": line.runs, "sentence": line.sentence, "length": len(line.sentence)} for line in context.doubts.lines],
            "n_runs": integer((law or {}).get("n_runs")),
            "source": [part for part in str(answer.get("source") or "").split(" and ") if part]}


def _row(key: str, value: Any, factor: float, decimals: int | None, unit: str, assumed: bool = False) -> dict[str, Any] | None:
    if not is_number(value):
        return None
    text = plain(value * factor) if decimals is None else scaled(value, factor, decimals)
    return {"key": key, "value": f"{text}\u00a0{unit}".strip(), "assumed": assumed}


def _device(context: Context) -> dict[str, Any]:
    bearing, load, assumed = context.scene.get("bearing", {}), context.scene.get("load", {}), context.assumed
    surface = bearing.get("surface", {})

    def of_bearing(key: str, part: str, name: str, unit: str) -> dict[str, Any] | None:
        return _row(key, bearing.get(part, {}).get(name), 1, None, unit, f"{part}.{name}" in assumed)

    pick = lambda key: next((s[key] for s in (context.results.main.get("load", {}), context.results.answer, load) if is_number(s.get(key))), None)  # noqa: E731
    rows = [of_bearing("radius", "surface", "R0_m", "m"), of_bearing("half_width", "surface", "a_m", "m"),
            of_bearing("dish", "surface", "planar_radius_mm", "mm"), of_bearing("slider", "slider", "diameter_mm", "mm"),
            of_bearing("rim_height", "rim", "height_mm", "mm"), of_bearing("rim_thickness", "rim", "thickness_mm", "mm"),
            _row("capacity", context.capacity, 1e3, 1, "mm") if surface else None,
            _row("yield", bearing.get("material", {}).get("steel", {}).get("yield_MPa"), 1, None, "MPa", "material.steel.yield_MPa" in assumed),
            _row("weight", pick("vertical_kN"), 1, None, "kN"), _row("mass", pick("mass_kg"), 1, None, "kg")]
    return {"name": bearing.get("name") or context.results.answer.get("bearing", ""), "surface": _kind(context, bearing),
            "rows": [row for row in rows if row]}


def _kind(context: Context, bearing: dict[str, Any]) -> str:
    """A word of the table."""
    if context.scene.get("reduced", {}).get("model") == "tfp":
        return "triple"
    return "double" if context.rigid_bodies or is_double_concave(bearing) else bearing.get("surface", {}).get("kind", "ellipse")


def span(ends: Any, unit: str = "") -> str:
    """Two numbers, or a dash."""
    if not isinstance(ends, (list, tuple)) or len(ends) != 2 or not all(is_number(end) for end in ends):
        return DASH
    return f"{sig(ends[0], 3)} – {sig(ends[1], 3)}" + (f"\u00a0{unit}" if unit else "")


def _law(law: dict[str, Any], answer: dict[str, Any]) -> dict[str, Any]:
    parameters = law.get("parameters", {})
    rows = []
    for name in sorted(parameters, key=lambda each: ORDER.index(each) if each in ORDER else len(ORDER)):
        p = parameters[name]
        unit = "" if p.get("unit") in (None, "", "-") else f"\u00a0{p['unit']}"
        rows.append({"key": name, "value": sig(p.get("value"), 3) + unit, "interval": span(p.get("interval_95")), "determined": p.get("identifiable") is not False})
    low, high = law.get("valid_from_m_s"), law.get("valid_to_m_s")
    return {"name": law.get("name", DASH), "rows": rows, "belongs": {"rim": "belongs_rim", "mass": "belongs_mass"}.get(law.get("belongs_to", ""), ""),
            "valid": span((low, high), "m/s") if is_number(low) and is_number(high) else ""}


def _speeds(answer: dict[str, Any]) -> list[dict[str, Any]]:
    return [{"cells": [fixed(row.get("speed_m_s"), 3), integer(row.get("peak_force_kN")), fixed(row.get("penetration_mm"), 2),
                       fixed(row.get("contact_time_ms"), 1), fixed(row.get("restitution"), 3), percent_up(row.get("peak_force_error")),
                       percent_up(row.get("rebound_error"))],
             "judged": row.get("error_from") or "", "outside": row.get("inside_fit") is False} for row in answer.get("table", [])]


def _pair(pair: dict[str, Any] | None) -> list[dict[str, str]]:
    if not pair:
        return []
    rows = [("k_i", f"{sig(pair.get('k_i_kN_per_m'), 3)}\u00a0kN/m"), ("e", fixed(pair.get("e"), 3))]
    if is_number(pair.get("c_i_kN_s_per_m")):
        rows.append(("damping", f"{sig(pair['c_i_kN_s_per_m'], 3)}\u00a0kN\u00a0s/m"))
    rows += [("mass", f"{plain(pair.get('mass_kg'))}\u00a0kg"), ("pair_range", span((pair.get("from_m_s"), pair.get("to_m_s")), "m/s")),
             ("force_error", percent_up(pair.get("worst_peak_force_error"))), ("rebound_error", percent_up(pair.get("worst_rebound_error")))]
    return [{"key": key, "value": value} for key, value in rows]


def _error(row: dict[str, Any]) -> dict[str, Any]:
    return {"key": QUANTITIES[row["label"]], "total": row["total"], "unknown": ["of_law" if source == "law" else source for source in row["unknown"]]}


def _strength(strain: dict[str, Any] | None) -> dict[str, Any] | None:
    if not strain or not is_number(strain.get("largest")):
        return None
    below = strain.get("largest_speed_below_limit_m_s")
    return {"largest": percent(strain["largest"], 1, False), "limit": percent(strain.get("limit"), 0, False), "exceeded": strain.get("exceeded") is True,
            "assumed": bool(strain.get("limit_is_assumption")), "below": f"{sig(below, 2)}\u00a0m/s" if is_number(below) and strain.get("exceeded") is True else ""}
