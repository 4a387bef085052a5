"""The result of one run on its first page: peaks, the response, the building it carries, whether the steel bears it."""
from typing import Any

from ..context import Context
from ..figures import response_panels
from ..numbers import DASH, fixed, integer, is_number, percent, scaled, sig
from ..run_folder import Run
from ..sections.common import hardest
from ..series import shown_part

AT_REST = 5e-3  # [m/s]
PLACES = {"rim_wall": "the rim's wall", "rim_root": "the rim's root", "dish": "the dish below the rim", "slider_edge": "the slider's edge"}


def make(context: Context) -> dict[str, Any]:
    run = context.results.only
    drawn = run.has("time", "displacement_x", "displacement_y")
    role = "fitted" if run.rung == "reduced" else "fe"
    figure = context.pictures.figure("first-response", "", response_panels.draw, [(role, shown_part(run))],
                                     {role: "reduced model" if role == "fitted" else "finite elements"}, context.capacity, dpi=300) if drawn else None
    return {"figure": figure, "no_figure": "" if figure else "No response is stored, so nothing is drawn.", "rows": _peaks(run, context.capacity),
            "building": _building(run), "strain": _strain(run), "foot": _foot(run.summary.get("rim_foot")), "law": _law(run), "estimate": _estimate(run)}


def _peaks(run: Run, capacity: float | None) -> list[list[str]]:
    s, impact = run.summary, hardest(run)
    rows = [["Peak displacement", _unit(scaled(s.get("peak_displacement_m"), 1e3, 1), "mm") + (f" of L_c = {scaled(capacity, 1e3, 0)}\u00a0mm" if capacity else "")],
            ["Peak lateral force", _unit(scaled(s.get("peak_lateral_force_N"), 1e-3, 0), "kN")],
            ["Peak impact force", _unit(scaled(s.get("peak_impact_force_N"), 1e-3, 0), "kN")],
            ["Impacts", integer(s.get("n_impacts", len(run.impacts)))]]
    if impact and run.kind in ("push", "cyclic", "figure-eight", "path"):  # pressed without inertia: a speed has no meaning
        rows.append(["Hardest: penetration", _unit(scaled(impact.get("peak_penetration_m"), 1e3, 2), "mm")])
    elif impact:
        rows += [["Hardest: approach, rebound", f"{fixed(impact.get('approach_speed_m_s'), 3)}, {fixed(impact.get('rebound_speed_m_s'), 3)}\u00a0m/s"],
                 ["Hardest: penetration", _unit(scaled(impact.get("peak_penetration_m"), 1e3, 2), "mm")]]
    rows.append([residual_title(s), _unit(scaled(s.get("residual_displacement_m"), 1e3, 1), "mm")])
    if halves := s.get("interface"):
        rows.append(["Slip of the slider's halves, largest and left", f"{scaled(halves['largest_interface_slip_m'], 1e3, 1)}, "
                                                                      f"{scaled(halves['residual_interface_slip_m'], 1e3, 1)}\u00a0mm"])
    if is_number(s.get("max_plastic_strain")):
        rows.append(["Largest plastic strain", percent(s["max_plastic_strain"], 2, False)])
    return [row for row in rows if not row[1].startswith(DASH)]


def residual_title(summary: dict[str, Any]) -> str:
    """A place of rest is called residual; where the run ends in motion, its speed is said."""
    speed = summary.get("final_speed_m_s")
    return f"Displacement at the end, at {fixed(speed, 2)}\u00a0m/s" if is_number(speed) and speed >= AT_REST else "Residual displacement"


def _unit(text: str, unit: str) -> str:
    return text if text == DASH else f"{text}\u00a0{unit}"


def _building(run: Run) -> list[list[str]]:
    s = run.summary
    rows = [["Peak storey drift", scaled(s.get("peak_drift_m"), 1e3, 1), "mm"], ["Ductility", fixed(s.get("ductility"), 2), ""],
            ["Peak storey shear", scaled(s.get("peak_storey_shear_N"), 1e-3, 0), "kN"],
            ["Peak floor acceleration", sig(s["peak_floor_acceleration_m_s2"] / 9.80665, 3) if is_number(s.get("peak_floor_acceleration_m_s2")) else DASH, "g"]]
    return [[label, _unit(value, unit).strip()] for label, value, unit in rows if value != DASH]


def _strain(run: Run) -> dict[str, Any] | None:
    limit = run.summary.get("strain_limit")
    if not limit or not is_number(limit.get("limit")):
        return None
    source = "an assumption of ours" if limit.get("assumption") else "from the bearing file"
    verdict = "exceeds" if limit.get("exceeded") else "stays below"
    where = PLACES.get(str(limit.get("place")))
    what = f"The plastic strain of {where}" if where else "The largest plastic strain of any body"
    said = f"{what}, {percent(limit.get('largest'), 1, False)}, {verdict} the limit of {percent(limit['limit'], 0, False)} ({source})."
    return {"exceeded": limit.get("exceeded") is True, "sentence": said}


def _foot(foot: dict[str, Any] | None) -> dict[str, Any] | None:
    """What went through the rim's foot, and whether the joint there bears it."""
    if not foot or not is_number(foot.get("weld_N_per_m")):
        return None
    carried = f"each mm of it carries {scaled(foot.get('shear_N_per_m'), 1e-6, 2)}\u00a0kN of shear and {scaled(foot.get('moment_N'), 1e-3, 0)}\u00a0kN\u00a0mm of moment"
    if is_number(foot.get("use")):
        return {"exceeded": foot.get("exceeded") is True, "sentence": f"{foot.get('in_words')}: used to {fixed(foot['use'], 2)}, it goes at 1; {carried}."}
    return {"exceeded": False, "sentence": f"Taken as one piece with the plate, an assumption; {carried}; two fillet welds would need a throat of "
                                           f"{fixed(foot.get('needed_throat_mm'), 0)}\u00a0mm."}


def _law(run: Run) -> str:
    """Which impact law acted, its range and whose rim it was fitted on; for reduced runs."""
    if run.rung != "reduced":
        return ""
    reduced = run.get("reduced", default={})
    said = f"Impact law `{reduced.get('impact_law', DASH)}`, k_i = {sig(reduced.get('k_i_kN_per_m'), 4)} kN/m"
    if reduced.get("impact_law") in ("signed", "no-tension", "printed", "hunt-crossley"):
        said += f", e = {sig(reduced.get('restitution'), 3)}"
    low, high = reduced.get("fitted_from_m_per_s"), reduced.get("fitted_to_m_per_s")
    if is_number(low) and is_number(high):
        return f"{said}; fitted to impacts from {sig(low, 2)} to {sig(high, 2)} m/s."
    return f"{said}; the range it was fitted to is not known."


def _estimate(run: Run) -> str:
    estimate = run.summary.get("error_estimate", {})
    said = estimate.get("sentence") or estimate.get("none") or ""
    return said[:1].upper() + said[1:] + ("." if said and not said.endswith(".") else "")
