"""Which impact law serves: what each leaves unexplained, what it predicts unseen."""
from typing import Any

from ..blocks import Section, note, table
from ..context import Context
from ..numbers import fixed, interval, is_number, percent, sig
from .common import short_name


def make(context: Context) -> Section | None:
    calibration = context.calibration
    if context.results.single or not (calibration.laws or calibration.speed_laws or calibration.profiles):
        return None
    section = Section("laws", "Impact laws, ranked")
    section.lead = ("Every law fitted to the same impacts, each restarted from the reference's own state, and asked to "
                    "predict runs it has not been fitted to.")
    section.add(_ranking(calibration.laws))
    section.add(note(calibration.laws_sentence) if calibration.laws_sentence else None)
    section.add(_parameters(calibration.laws))
    section.add(_left_out(context, calibration.laws))
    section.add(note(calibration.constant_pair["sentence"]) if calibration.constant_pair.get("sentence") else None)
    section.add(_constant_pair(context, calibration.constant_pair))
    section.add(_speed_laws(calibration.speed_laws))
    section.add(_profiles(calibration.profiles))
    return section


def _run(context: Context, folder: str) -> str:
    name = folder.rstrip("/").split("/")[-1]
    return context.doubts.marked(name, short_name(name))


def _limits(parameter: dict[str, Any]) -> str:
    limits = parameter.get("interval_95", [])
    return interval(*limits) if len(limits) == 2 else "–"


def _ranking(laws: list[dict[str, Any]]) -> dict[str, Any] | None:
    rows = [[row.get("law", "–"), percent(row.get("force_unexplained"), 1, False),
             percent(row.get("largest_peak_force_error"), 1, False), percent(row.get("largest_rebound_error"), 1, False),
             percent(row.get("left_out_peak_force_error"), 1, False), percent(row.get("left_out_rebound_error"), 1, False),
             _range(row)] for row in laws]
    return table(["law", "force unexplained", "peak force, fitted", "rebound, fitted", "peak force, left out",
                  "rebound, left out", "valid (m/s)"], rows,
                 caption="Largest errors over the runs, grazing ones apart. Valid: speeds at which peak force and rebound of "
                         "runs left out are both met within 5 %.")


def _range(row: dict[str, Any]) -> str:
    low, high = row.get("valid_from_m_s"), row.get("valid_to_m_s")
    return f"{sig(low, 2)} to {sig(high, 2)}" if is_number(low) and is_number(high) else "nowhere"


def _parameters(laws: list[dict[str, Any]]) -> dict[str, Any] | None:
    rows = []
    for row in laws:
        for name, p in row.get("parameters", {}).items():
            rows.append([row.get("law", "–"), name, sig(p.get("value"), 3), p.get("unit", "").strip("-"),
                         _limits(p), p.get("verdict", "–")])
    return table(["law", "parameter", "value", "unit", "95 % interval", "verdict"], rows, left=2,
                 caption="Verdict: determined; form (determined by the data, but the law does not follow them, which "
                         "widens the interval); flat; bound; grazing.")


def _left_out(context: Context, laws: list[dict[str, Any]]) -> dict[str, Any] | None:
    """The best law's errors on what it has not seen."""
    if not laws:
        return None
    rows = []
    for left in laws[0].get("leave_one_out", []):
        for folder, error in left.get("runs", {}).items():
            name = _run(context, folder)
            rows.append([left.get("left_out", "") if len(left.get("runs", {})) > 1 else name, name, sig(error.get("approach_speed_m_s"), 2),
                         percent(error.get("peak_force_error")), percent(error.get("rebound_error")),
                         percent(error.get("nrmse_displacement"), 2, False), "grazes" if error.get("grazing") else ""])
    return table(["left out", "run", "approach (m/s)", "peak force", "rebound", "NRMSE displacement", ""], rows, left=2,
                 caption=f"{laws[0].get('law', '–')}: fitted without what is left out, then asked for it.")


def _constant_pair(context: Context, pair: dict[str, Any]) -> dict[str, Any] | None:
    """The errors of the pair with the widest range, inside and outside of it."""
    rows = []
    for part, said in (("fitted", "inside, fitted"), ("left_out", "inside, left out"), ("outside", "outside")):
        for folder, error in pair.get(part, {}).items():
            rows.append([_run(context, folder), said, sig(error.get("approach_speed_m_s"), 2),
                         percent(error.get("peak_force_error")), percent(error.get("rebound_error"))])
    return table(["run", "range", "approach (m/s)", "peak force", "rebound"], rows, left=2,
                 caption="One constant k_i and e over the widest range of speeds that it meets.") if rows else None


def _speed_laws(laws: dict[str, dict[str, Any]]) -> dict[str, Any] | None:
    rows = [[name, f"{sig(law.get('coefficient'), 3)} {law.get('unit', '').strip('-')} · (v / 1 m/s)^{fixed(law.get('exponent'), 2)}",
             f"{sig(law.get('from_m_s'), 2)} to {sig(law.get('to_m_s'), 2)}", percent(law.get("largest_error"), 0, False)]
            for name, law in laws.items()]
    return table(["parameter", "over speed", "from windows (m/s)", "largest error"], rows, left=2, compact=True,
                 caption="Where one pair does not serve: the pair of `signed` as a function of the approach speed.")


def _profiles(profiles: dict[str, Any]) -> dict[str, Any] | None:
    rows = [[name, _limits(p), p.get("unit", "").strip("-")]
            for name, p in profiles.items()]
    return table(["parameter", "95 % by profile likelihood", "unit"], rows, compact=True,
                 caption="From the stated uncertainties alone, the other parameters refitted; a dash: not reached.")
