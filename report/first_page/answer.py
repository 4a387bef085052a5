"""The answer on the first page: the law's picture and numbers, the table over speed, the pair, where it holds, the steel.

Everything is taken from calibration.json's `answer`, the one record; nothing is worked out here."""
import re
from typing import Any

from markupsafe import Markup

from ..context import Context
from ..doubts import MARK
from ..figures import law as law_figure
from ..markup import sentence
from ..numbers import DASH, fixed, integer, interval, is_number, percent, percent_up, plain, sig
from ..plain_words import for_page
from ..results import Results
from .error_bars import bars

NAMES = {"k_i": "k_i", "e": "e"}
LABELS = {"k_i": "initial stiffness", "e": "restitution", "yield_force": "yield force", "hardening": "hardening",
          "unloading_gain": "unloading gain", "hardening_exponent": "hardening exponent",
          "unloading_exponent": "unloading exponent", "exponent": "exponent", "mu_fast": "friction at speed",
          "capacity_offset": "rim begins beyond L_c by"}


def make(context: Context) -> dict[str, Any]:
    """A dictionary for the template; `missing` says why there is no answer."""
    results, answer = context.results, context.results.answer
    law = answer.get("law", {})
    figure = context.pictures.figure("law", "", law_figure.draw, results.impacts, law.get("name", "")) if law else None
    if not law:
        return {"missing": _why_none(results), "figure": None}
    return {"missing": "", "law": law.get("name", DASH), "figure": figure,
            "no_figure": "" if figure else "No curve of a fitted impact is stored, so the law's picture is not drawn.",
            "remark": for_page(law.get("remark") or ""), "belongs": _belongs(law, answer),
            "numbers": _numbers(law), "table": _table(answer), "pair": _pair(answer), "holds": for_page(_holds(law, answer)),
            "band": _band(answer.get("steel_band")), "strain": _strain(answer.get("strain"), answer.get("rim_foot") or {}), "bars": bars(answer.get("errors") or []),
            "findings": [for_page(said) for said in answer.get("finding_sentences") or []],
            "mesh_error": for_page(answer.get("mesh_error", {}).get("sentence") or "")}


def _why_none(results: Results) -> str:
    if results.calibration:
        return "The calibration in this folder holds no answer: it was made by an earlier version. rimpact calibrate makes it anew."
    return "No impact law was fitted to these runs, so there are no numbers to type in."


def _belongs(law: dict[str, Any], answer: dict[str, Any]) -> str:
    if law.get("belongs_to") == "rim":
        return "The law belongs to the rim: it holds for any mass."
    if law.get("belongs_to") == "mass":
        return f"The law belongs to the mass: it holds for {plain(answer.get('mass_kg'))} kg only."
    return ""


def value_of(number: float | None, unit: str | None) -> str:
    """Three figures with the unit; a number without one stands alone."""
    unit = "" if unit in (None, "", "-") else f"\u00a0{unit}"
    return sig(number, 3) + unit


def _numbers(law: dict[str, Any]) -> list[dict[str, Any]]:
    rows = []
    order = {name: place for place, name in enumerate(LABELS)}
    for name, p in sorted(law.get("parameters", {}).items(), key=lambda item: order.get(item[0], len(order))):
        limits = interval(*p["interval_95"]) if len(p.get("interval_95", [])) == 2 else DASH
        verdict = p.get("verdict") or {True: "determined", False: "not identifiable"}.get(p.get("identifiable"), DASH)
        doubt = p.get("identifiable") is False
        symbol = sentence(name if name in NAMES else "")
        label = sentence(LABELS.get(name, name.replace("_", " ")))
        rows.append({"label": label + Markup(" ") + symbol if symbol else label, "value": value_of(p.get("value"), p.get("unit")),
                     "interval": limits, "verdict": verdict, "doubt": MARK if doubt else ""})
    return rows


def _table(answer: dict[str, Any]) -> dict[str, Any]:
    """The rows and what the marks beside them mean. Where a constant pair is given it is the page's one pair: the rows have none."""
    rows = []
    for row in answer.get("table", []):
        left_out = row.get("error_from") == "left out"
        outside = row.get("inside_fit") is False
        rows.append([fixed(row.get("speed_m_s"), 3), integer(row.get("peak_force_kN")), fixed(row.get("penetration_mm"), 2),
                     fixed(row.get("contact_time_ms"), 1), fixed(row.get("restitution"), 3),
                     percent_up(row.get("peak_force_error")), percent_up(row.get("rebound_error")),
                     "runs left out" if left_out else "runs fitted" if row.get("error_from") else DASH,
                     sig(row.get("k_i_kN_per_m"), 3), fixed(row.get("e"), 3), MARK if outside else ""])
    return {"rows": rows, "outside": any(row[-1] for row in rows), "pair_law": answer.get("pair_law", ""),
            "with_pairs": not answer.get("pair") and any(is_number(row.get("e")) for row in answer.get("table", []))}


def _pair(answer: dict[str, Any]) -> dict[str, Any]:
    pair = answer.get("pair")
    if not pair:
        return {"given": False, "sentence": for_page(answer.get("no_pair") or "No constant pair is given.")}
    said = [f"k_i = {sig(pair.get('k_i_kN_per_m'), 3)} kN/m, e = {fixed(pair.get('e'), 3)}"]
    if is_number(pair.get("c_i_kN_s_per_m")):
        said.append(f"c_i = {sig(pair['c_i_kN_s_per_m'], 3)} kN s/m")
    values = f"{', '.join(said)} (law {pair.get('law', DASH)}, {plain(pair.get('mass_kg'))} kg"
    values += f", {sig(pair.get('from_m_s'), 2)} to {sig(pair.get('to_m_s'), 2)} m/s)"
    errors = f"Worst errors there: peak force {percent_up(pair.get('worst_peak_force_error'))}, rebound {percent_up(pair.get('worst_rebound_error'))}."
    return {"given": True, "stated": values, "errors": errors, "sentence": for_page(_beyond(pair.get("sentence", "")))}


def _beyond(sentence: str) -> str:
    """Of the pair's sentence what the values above do not say: how far off it is below and beyond its speeds."""
    return " ".join(part for part in re.split(r"(?<=\.) ", sentence) if part.startswith(("Below", "Beyond")))


def _holds(law: dict[str, Any], answer: dict[str, Any]) -> str:
    """Sentences of where the law holds, made where the record has none."""
    if answer.get("validity"):
        return answer["validity"]
    low, high = law.get("valid_from_m_s"), law.get("valid_to_m_s")
    if is_number(low) and is_number(high):
        return f"From {sig(low, 2)} to {sig(high, 2)} m/s, within {percent(law.get('tolerance'), 0, False)} of runs left out of the fit."
    return "Nowhere is it shown to hold: no neighbouring runs left out of the fit are met within the tolerance."


def _telling(rows: list[dict[str, Any]], limit: float | None) -> list[dict[str, Any]]:
    """Of rows by speed the slowest, the fastest, and the two between which the limit lies."""
    below = [row for row in rows if is_number(limit) and is_number(row.get("strain")) and row["strain"] <= limit]
    beyond = [row for row in rows if row not in below]
    told = [*rows[:1], *below[-1:], *beyond[:1], *rows[-1:]]
    return [row for place, row in enumerate(told) if row not in told[:place]]


def _band(band: dict[str, Any] | None) -> dict[str, Any] | None:
    """Static and fast steel at the twins' speeds: force, depth and rebound by pairs, the law's own steel named."""
    if not band or not band.get("rows"):
        return None
    columns = (("peak_force_kN", integer), ("penetration_mm", lambda x: fixed(x, 2)), ("restitution", lambda x: fixed(x, 3)))
    rows = [[fixed(row.get("speed_m_s"), 3), *(said(row.get(steel, {}).get(key)) for key, said in columns for steel in ("static", "fast"))]
            for row in band["rows"]]
    return {"rows": rows, "sentences": [for_page(said) for said in band.get("sentences", [])], "law_is_of": band.get("law_is_of", DASH)}


def _strain(strain: dict[str, Any] | None, foot: dict[str, Any]) -> dict[str, Any] | None:
    if not strain:
        return None
    limit = f"limit {percent(strain.get('limit'), 0, False)}"
    source = "an assumption of ours" if strain.get("limit_is_assumption") else "from the bearing file"
    return {"exceeded": strain.get("exceeded") is True or foot.get("goes_at_m_s") is not None, "sentence": strain.get("sentence", ""),
            "beside": [strain[key] for key in ("crack_sentence", "slider_sentence") if strain.get(key)],
            "places": [*(row["sentence"] for row in strain.get("places") or [] if row.get("sentence")), *([foot["sentence"]] if foot.get("sentence") else [])],
            "limit": f"{limit}, {source}", "largest": percent(strain.get("largest"), 1, False),
            "rows": [[sig(row.get("speed_m_s"), 2), percent(row.get("strain"), 1, False)] for row in _telling(strain.get("rows", []), strain.get("limit"))]}
