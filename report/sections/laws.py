"""The answer's law and the one constant pair: how far off they are in every run; and which law leaves least.

Numbers and errors of a table are of one record: a row of calibration.json's `laws`, its `constant_pair`."""
from typing import Any

from ..blocks import Section, heading, note, table
from ..calibration_file import last_part
from ..context import Context
from ..numbers import is_number, percent, sig
from .common import of_what, short_name

NOT_KNOWN = "not known"


def make(context: Context) -> Section | None:
    calibration = context.calibration
    if context.results.single or not (calibration.laws or calibration.constant_pair):
        return None
    section = Section("laws", "The law and its errors")
    section.lead = ("How far the first page's law is from every run, and how it was chosen. Every impact is restarted from the reference's own state at "
                    "touch; a run left out is predicted by the law fitted to all others.")
    row = calibration.answer_row
    section.add(_runs(context, row))
    section.add(_left_out_sets(context, row))
    if calibration.law and not row:
        section.add(note(f"The answer's `{calibration.law}` was fitted apart from the laws ranked below: its errors are those of the first page."))
    section.add(_ranking(calibration.laws, calibration.law))
    section.add(note(calibration.laws_sentence) if calibration.laws_sentence else None)
    pair = calibration.answer.get("pair") or {}
    errors = _constant_pair(context, pair) if pair else None
    if errors:
        section.add(heading("The constant pair"))
        section.add(note(pair["sentence"]) if pair.get("sentence") else None)
        section.add(errors)
    return section


def run_name(context: Context, folder: str) -> str:
    name = last_part(folder)
    return context.doubts.marked(name, short_name(name))


def known(ratio: Any, signed: bool = True) -> str:
    """A share in per cent; in words where there is none: an error that is not known is not zero."""
    return percent(ratio, 1, signed) if is_number(ratio) else NOT_KNOWN


def _single(row: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Errors of runs left out by themselves, by folder."""
    return {left["left_out"]: left["runs"][left["left_out"]] for left in row.get("leave_one_out", [])
            if left.get("left_out") in left.get("runs", {})}


def _runs(context: Context, row: dict[str, Any]) -> dict[str, Any] | None:
    """The answer's law in every run fitted, and in the same run left out."""
    left_out, rows = _single(row), []
    for folder, error in sorted(row.get("runs", {}).items(), key=lambda item: item[1].get("approach_speed_m_s") or 0.0):
        left = left_out.get(folder, {})
        rows.append([run_name(context, folder), sig(error.get("approach_speed_m_s"), 3), known(error.get("peak_force_error")), known(error.get("rebound_error")),
                     known(left.get("peak_force_error")), known(left.get("rebound_error")), "grazes" if error.get("grazing") else ""])
    why = "" if left_out or not rows else " Left out: not known, for too few runs hit the rim hard enough to leave one out."
    return table(["run", "approach (m/s)", "peak force, fitted", "rebound, fitted", "peak force, left out", "rebound, left out", ""], rows,
                 caption=f"Law `{row.get('law', '–')}`, the answer{of_what(context, row)}: signed errors.{why}", record="laws.runs")


def _left_out_sets(context: Context, row: dict[str, Any]) -> dict[str, Any] | None:
    """The answer's errors on pulses left out with all their scales."""
    rows = []
    for left in row.get("leave_one_out", []):
        if left.get("left_out") in left.get("runs", {}):
            continue
        for folder, error in left.get("runs", {}).items():
            rows.append([left.get("left_out", ""), run_name(context, folder), sig(error.get("approach_speed_m_s"), 3),
                         known(error.get("peak_force_error")), known(error.get("rebound_error")), "grazes" if error.get("grazing") else ""])
    return table(["left out together", "run", "approach (m/s)", "peak force", "rebound", ""], rows, left=2,
                 caption=f"Law `{row.get('law', '–')}`, fitted without all scales of a pulse, then asked for them.", record="laws.leave_one_out")


def _ranking(laws: list[dict[str, Any]], answer: str) -> dict[str, Any] | None:
    rows = [[row.get("law", "–"), "the answer" if row.get("law") == answer else "", known(row.get("force_unexplained"), False),
             known(row.get("largest_peak_force_error"), False), known(row.get("largest_rebound_error"), False),
             known(row.get("left_out_peak_force_error"), False), known(row.get("left_out_rebound_error"), False), _range(row)] for row in laws]
    none = laws and not any(is_number(row.get("left_out_peak_force_error")) for row in laws)
    return table(["law", "", "force unexplained", "peak force, fitted", "rebound, fitted", "peak force, left out",
                  "rebound, left out", "valid (m/s)"], rows, left=2, record="laws.rows",
                 caption="The laws compared. Largest errors over the runs, grazing ones apart. Valid: speeds at which peak force and rebound of "
                         "runs left out are both met within 5 %." + (" Left out: not known, for too few runs hit the rim hard enough to leave one out." if none else ""))


def _range(row: dict[str, Any]) -> str:
    low, high = row.get("valid_from_m_s"), row.get("valid_to_m_s")
    if is_number(low) and is_number(high):
        return f"{sig(low, 2)} to {sig(high, 2)}" if high > low else f"{sig(low, 2)} only"
    return "nowhere" if is_number(row.get("left_out_peak_force_error")) else NOT_KNOWN


def _constant_pair(context: Context, pair: dict[str, Any]) -> dict[str, Any] | None:
    """The errors of the pair that is given, inside and outside of its range."""
    stored, rows = context.calibration.constant_pair, []
    for part, said in (("fitted", "inside, fitted"), ("left_out", "inside, left out"), ("outside", "outside")):
        for folder, error in stored.get(part, {}).items():
            rows.append([run_name(context, folder), said, sig(error.get("approach_speed_m_s"), 3), known(error.get("peak_force_error")), known(error.get("rebound_error"))])
    return table(["run", "range", "approach (m/s)", "peak force", "rebound"], rows, left=2, record="constant_pair",
                 caption=f"Constant pair k_i = {sig(pair.get('k_i_kN_per_m'))} kN/m, e = {sig(pair.get('e'))} of law `{pair.get('law', '–')}`: signed errors.") if rows else None
