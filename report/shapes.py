"""What the files of a results folder must look like where the report reads them. A key that is absent or null is
borne; one of another type is refused, with the file and the key, as somebody's hand has been there.

A shape is NUMBER, TEXT, FLAG, ANY, [shape of every item], {key: shape} (other keys are free; "*": shape of the others),
or a tuple of shapes of which one must fit."""
from typing import Any, NoReturn

from .errors import DataError

Shape = Any  #: one of the above, nested
NUMBER, TEXT, FLAG, ANY = "a number", "a text", "true or false", "anything"


class ShapeError(DataError):
    """A file that can be read and makes no sense."""


def numbers(names: str) -> dict[str, Shape]:
    return dict.fromkeys(names.split(), NUMBER)


def texts(names: str) -> dict[str, Shape]:
    return dict.fromkeys(names.split(), TEXT)


LOAD: Shape = numbers("vertical_kN mass_kg gravity_m_per_s2 gravity")
SCENE: Shape = {
    "name": TEXT, "load": {"*": NUMBER}, "model": {"rung": TEXT, "mesh": NUMBER},
    "bearing": {"name": TEXT, "assumed": [TEXT],
                "surface": {**texts("kind file concave"), "radius_mm": [NUMBER], "height_mm": [NUMBER], "*": NUMBER},
                "rim": {"connection": {**texts("kind size grade"), "*": NUMBER}, "*": NUMBER},
                **dict.fromkeys(("slider", "plate", "pad", "foot"), {"*": NUMBER}),
                "material": {"*": {**texts("rate hardening curve_kind grade"), "curve": ([[NUMBER]], TEXT), "*": NUMBER}}, "contact": {"pad_foot": TEXT, "*": NUMBER}},
    "excitation": {"kind": TEXT, **numbers("scale speed_m_per_s amplitude_g period_s centre_s duration_s direction_deg")},
    "reduced": {**texts("model impact_law friction normal_force calibration fitted_rim"),
                **numbers("k_i_kN_per_m restitution mu_fast mu_slow fitted_from_m_per_s fitted_to_m_per_s fitted_mass_kg "
                          "fitted_speeds_mass_kg")},
    "isolator": {"capacity_m": NUMBER}, "superstructure": {"kind": TEXT, **numbers("storeys period_s damping_ratio yield_mm mass_ratio")},
}
IMPACT: Shape = numbers("touch_time_s release_time_s direction_deg approach_speed_m_s rebound_speed_m_s restitution peak_force_N "
                 "peak_penetration_m")
SUMMARY: Shape = {
    **numbers("peak_displacement_m peak_lateral_force_N peak_impact_force_N n_impacts residual_displacement_m final_speed_m_s "
              "peak_vertical_displacement_m min_normal_force_N max_plastic_strain mesh n_dofs n_steps n_newton_iterations "
              "lateral_capacity_m wall_time_s peak_memory_bytes peak_drift_m peak_storey_shear_N peak_floor_acceleration_m_s2 ductility"),
    **texts("rung status reason"), "impacts": [IMPACT], "warnings": [TEXT], "energy": {"*": NUMBER},
    "time_split_s": {"*": NUMBER}, "collapsed": FLAG, "beyond_rim": FLAG, "beyond_fit": FLAG,
    "error_estimate": {"peak_force_relative": NUMBER, "sentence": TEXT, "none": TEXT},
    "strain_limit": {"limit": NUMBER, "largest": NUMBER, "place": TEXT, "exceeded": FLAG, "assumption": FLAG},
    "rim_foot": {**texts("connection in_words"), "exceeded": FLAG, "*": NUMBER},
    "building": {"bearings": [numbers("x_m y_m static_normal_force_N peak_displacement_m peak_force_N peak_impact_force_N impacts max_normal_force_N "
                                      "min_normal_force_N peak_uplift_m residual_displacement_m first_touch_s")],
                 "floors": [numbers("peak_displacement_m peak_drift_m peak_drift_x_m peak_drift_y_m peak_acceleration_m_s2 peak_shear_N")],
                 "dish_springs": {**numbers("stiffness_N_per_m restitution"), "assumed": FLAG},
                 "name": TEXT, **numbers("worst_bearing peak_base_shear_N peak_overturning_N_m peak_base_rotation_rad weight_N "
                                         "peak_base_displacement_m hardest_instant_s")},
    "superstructure": {"storeys": [numbers("peak_drift_m residual_drift_m peak_shear_N peak_acceleration_m_s2")]},
}
DOCUMENT: Shape = texts("title client project author")
MAIN: Shape = {
    "runs": [texts("name role fe reduced fitted law published")], "comparison": [{"name": TEXT, "doubts": [TEXT]}],
    "totals": numbers("wall_time_s peak_memory_bytes"), "load": LOAD, "document": DOCUMENT, "warnings": [TEXT],
    "versions": {"rimpact": TEXT, "*": ANY}, "machine": {"*": ANY},
}
PARAMETER: Shape = {"value": NUMBER, "unit": TEXT, "standard_error": NUMBER, "interval_95": [NUMBER], "identifiable": FLAG,
             "reason": TEXT, "verdict": TEXT}
METRICS: Shape = {**numbers("peak_force_error peak_displacement_error rebound_error nrmse_displacement nrmse_force "
                     "approach_speed_m_s force_unexplained"), "grazing": FLAG}
LAW_ROW: Shape = {"law": TEXT, "parameters": {"*": PARAMETER}, "runs": {"*": METRICS}, "leave_one_out": [{"left_out": TEXT, "runs": {"*": METRICS}}],
           **numbers("force_unexplained largest_peak_force_error largest_rebound_error left_out_peak_force_error "
                     "left_out_rebound_error valid_from_m_s valid_to_m_s")}
BAND: Shape = (numbers("nominal low high"), NUMBER)
ANSWER: Shape = {
    **texts("bearing rim_identity source pair_law no_pair validity steel_rate"), "rung": (TEXT, [TEXT]), "mesh": (NUMBER, [NUMBER]),
    **numbers("mass_kg vertical_kN gravity_m_per_s2"), "published_applies": FLAG, "doubts": [TEXT], "error_sentences": [TEXT],
    "finding_sentences": [TEXT],
    "errors": [{**texts("quantity source how from"), "value": NUMBER, "by": [{"load": TEXT, **numbers("speed_m_s penetration_mm value")}],
                "find": {"command": TEXT, "minutes": NUMBER}}],
    "assumptions": [{"key": TEXT, "value": (TEXT, NUMBER)}],
    "law": {**texts("name chosen_by remark belongs_to sentence"), "parameters": {"*": PARAMETER}, "element": {"*": ANY},
            **numbers("fitted_from_m_s fitted_to_m_s valid_from_m_s valid_to_m_s tolerance force_unexplained n_runs"),
            "worst_left_out": {"peak_force": NUMBER, "rebound": NUMBER, "inside_valid_range": FLAG}},
    "table": [{**numbers("speed_m_s peak_force_kN restitution penetration_mm contact_time_ms k_i_kN_per_m e "
                         "peak_force_error rebound_error"), "error_from": TEXT, "inside_fit": FLAG}],
    "pair": {**texts("law sentence"), "parameters": {"*": PARAMETER},
             **numbers("k_i_kN_per_m e c_i_kN_s_per_m mass_kg from_m_s to_m_s tolerance worst_peak_force_error "
                       "worst_rebound_error")},
    "strain": {**numbers("limit largest largest_speed_below_limit_m_s"), "limit_is_assumption": FLAG, "exceeded": FLAG,
               "rows": [{**numbers("speed_m_s penetration_mm strain"), "place": TEXT}],
               "places": [{**texts("place sentence"), **numbers("damage damage_at_m_s strain strain_at_m_s"),
                           **dict.fromkeys(("crack", "limit"), numbers("below_m_s beyond_m_s expected_m_s"))}], **texts("sentence place crack_sentence slider_sentence")},
    "rim_foot": {**texts("connection in_words sentence doubt"), **dict.fromkeys(("gone", "twins_gone"), numbers("below_m_s beyond_m_s expected_m_s")),
                 **dict.fromkeys(("rows", "twins"), [numbers("speed_m_s use normal_N_per_m shear_N_per_m moment_N needed_throat_mm")])},
    "mesh_error": {"peak_force": NUMBER, "sentence": TEXT},
    "steel_band": {**texts("rate law_is_of calibration"), "rate_is_assumption": FLAG, "sentences": [TEXT],
                   "rows": [{"speed_m_s": NUMBER, **dict.fromkeys(("static", "fast"), numbers("peak_force_kN penetration_mm restitution"))}]},
}
CALIBRATION: Shape = {
    "answer": ANSWER, "parameters": {"*": PARAMETER}, "correlation": {"*": {"*": NUMBER}}, "condition": NUMBER,
    "derived": {"*": ANY}, "fit": {"*": {**METRICS, "published_values": METRICS, "impacts": [numbers("approach_speed_m_s")]}},
    "prediction": {"*": {**METRICS, "published_values": METRICS}}, "fitted_on": TEXT,
    "published": {"k_i": {"value": NUMBER}, "e": {"value": NUMBER}},
    "windows": {"rows": [{**numbers("speed_m_s peak_force_N contact_time_s restitution pair_force_error"),
                          "parameters": {"*": PARAMETER}, "pair_holds": FLAG, "folder": TEXT}],
                **numbers("tolerance valid_from_m_s valid_to_m_s"), "sentence": TEXT},
    "laws": {"rows": [LAW_ROW], "sentence": TEXT, "tolerance": NUMBER},
    "constant_pair": {"sentence": TEXT, **dict.fromkeys(("fitted", "left_out", "outside"), {"*": METRICS})},
    "speed_laws": {"*": {**numbers("coefficient exponent largest_error from_m_s to_m_s"), "unit": TEXT}},
    "profiles": {"*": {"unit": TEXT, "interval_95": [NUMBER]}},
    "critical_amplitudes": [{"scene": TEXT, **numbers("scale critical_scale critical_amplitude_g"),
                             "approach_speed_m_s": BAND, "peak_impact_force_N": BAND, "varied": ([TEXT], TEXT)}],
    "search": {**numbers("impacts starts starts_agreeing"), "message": TEXT}, "notes": [TEXT],
}
CURVE: Shape = dict.fromkeys(("time_s", "penetration_m", "force_N"), [NUMBER])
CURVES: Shape = {"scene": TEXT, "law": TEXT, "lateral_capacity_m": NUMBER, "impacts": [{**texts("run source"), **numbers("touch_time_s approach_speed_m_s"),
                                                   "fitted": FLAG, "grazing": FLAG, "reference": CURVE, "law": CURVE}]}


def without_nulls(tree: Any) -> Any:
    """Absent and null are one."""
    if isinstance(tree, dict):
        return {key: without_nulls(value) for key, value in tree.items() if value is not None}
    if isinstance(tree, list):
        return [without_nulls(item) for item in tree if item is not None]
    return tree


def check(value: Any, shape: Shape, where: str, key: str = "") -> None:
    """Throws ShapeError naming the file `where`, the key and what was found. `value` holds no null."""
    if isinstance(shape, tuple):
        if not any(_fits(value, option, where, key) for option in shape):
            _refuse(value, shape, where, key)
    elif isinstance(shape, dict):
        if not isinstance(value, dict):
            _refuse(value, shape, where, key)
        for name, item in value.items():
            check(item, shape.get(name, shape.get("*", ANY)), where, f"{key}.{name}" if key else name)
    elif isinstance(shape, list):
        if not isinstance(value, list):
            _refuse(value, shape, where, key)
        for i, item in enumerate(value):
            check(item, shape[0], where, f"{key}[{i}]")
    elif not _is(value, shape):
        _refuse(value, shape, where, key)


def _fits(value: Any, shape: Shape, where: str, key: str) -> bool:
    try:
        check(value, shape, where, key)
    except ShapeError:
        return False
    return True


def _is(value: Any, shape: Shape) -> bool:
    if shape == NUMBER:
        return isinstance(value, float) or (isinstance(value, int) and not isinstance(value, bool) and abs(value) < 10**300)
    return shape == ANY or isinstance(value, str if shape == TEXT else bool)


def _named(shape: Shape) -> str:
    if isinstance(shape, tuple):
        return " or ".join(_named(option) for option in shape)
    return "a table" if isinstance(shape, dict) else "a list" if isinstance(shape, list) else shape


def _refuse(value: Any, shape: Shape, where: str, key: str) -> NoReturn:
    said = {dict: "a table", list: "a list", bool: "true or false"}.get(type(value)) or repr(value)[:60]
    raise ShapeError(f"{where}: {key or 'the whole file'} must be {_named(shape)}, got {said}")
