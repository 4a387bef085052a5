"""The appendix of what is not the answer: the fit of one law to whole histories, the other laws' numbers, each window by itself.

Whatever stands here says for which law, mass and speeds it is, and its errors come from its own record alone."""
from typing import Any

from ..blocks import Section, bullets, heading, note, table
from ..calibration_file import Calibration
from ..context import Context
from ..figures import calibration as figure_calibration
from ..numbers import fixed, integer, interval, is_number, percent, plain, power, sig
from .common import ROLE_TEXT, of_mass, of_what
from .laws import known, run_name
from .windows_alone import windows_alone

NOT = "Not the answer"


def make(context: Context) -> Section | None:
    calibration = context.calibration
    if context.results.single or not (calibration.parameters or calibration.other_rows or calibration.speed_laws or calibration.profiles):
        return None
    section = Section("calibration", "Appendix: other fits, not the answer", appendix=True)
    section.lead = _lead(calibration)
    _fit(context, section)
    section.add(_other_laws(context))
    section.add(_unserving_pair(context))
    windows_alone(context, section)
    section.add(_pairs_of_the_law(context))
    section.add(bullets(calibration.notes))
    differences = _published(calibration)
    if differences:
        section.add(heading("The published values beside this fit"))
        section.add(bullets(differences))
    return section


def _lead(calibration: Calibration) -> str:
    if not calibration.law:
        return "Fits of a calibration that holds no answer. None of them is one."
    pair = " and its constant pair" if calibration.answer.get("pair") else ""
    return f"For comparison only. The answer is the law `{calibration.law}`{pair} of the first page; nothing below is to be used in its place."


def _fit(context: Context, section: Section) -> None:
    """The law that `parameters` of calibration.json belong to."""
    calibration = context.calibration
    if not calibration.parameters:
        return
    law = calibration.derived.get("law") or "–"
    source = "measured" if context.measured else "stored"
    same = " It is the answer's law, fitted to other runs." if law == calibration.law else ""
    what = f"{NOT}: law `{law}`, fitted to {source} {calibration.fitted_on or 'impacts'}{of_fit(context)}."
    section.add(heading(f"Law {law}, fitted by itself"))
    section.add(_parameters(calibration, what + same))
    section.add(context.pictures.figure("calibration-parameters", what, figure_calibration.draw_parameters, calibration))
    section.add(_correlation(calibration, law))
    section.add(_derived(calibration, law))
    section.add(_runs(context, law))


def of_fit(context: Context) -> str:
    """", 86 952 kg, 0.0698 to 1.2 m/s": of the impacts in `fit`."""
    speeds = [impact["approach_speed_m_s"] for run in context.calibration.fit.values() for impact in run.get("impacts", [])
              if is_number(impact.get("approach_speed_m_s"))]
    return of_mass(context.calibration) + (f", impacts at {sig(min(speeds))} to {sig(max(speeds))} m/s" if speeds else "")


def _show(value: Any) -> str:
    return power(value, 3) if is_number(value) and abs(value) >= 1e4 else sig(value, 3)


def _parameters(calibration: Calibration, caption: str) -> dict[str, Any] | None:
    rows = []
    for p in calibration.parameters:
        told = "–" if p.identifiable is None else "yes" if p.identifiable else "no" + (f": {p.reason}" if p.reason else "")
        profile = calibration.profiles.get(p.name, {}).get("interval_95", [])
        rows.append([p.name, _show(p.value), p.unit.strip("-"), _show(p.standard_error) if p.standard_error else "–", interval(*p.interval) if p.interval else "–",
                     interval(*profile) if len(profile) == 2 else "–", told,
                     *([_show(p.published) if p.published is not None else "–"] if calibration.published_applies else [])])
    return table(["parameter", "value", "unit", "standard error", "95 % interval", "the same by profile likelihood", "identifiable",
                  *(["published"] if calibration.published_applies else [])], rows, caption=caption)


def _correlation(calibration: Calibration, law: str) -> dict[str, Any] | None:
    names = list(calibration.correlation)
    if len(names) < 2:
        return None
    rows = [[name, *(fixed(calibration.correlation[name].get(other), 3) for other in names)] for name in names]
    condition = f" Condition number {sig(calibration.condition, 3)}." if is_number(calibration.condition) else ""
    return table(["correlation", *names], rows, caption=f"{NOT}: correlation of the estimates of law `{law}`.{condition}", compact=True)


def _derived(calibration: Calibration, law: str) -> dict[str, Any] | None:
    rows = []
    for name, value in calibration.derived.items():
        if name == "element":  # its parameters stand in the table above
            continue
        if isinstance(value, dict) and "value" in value:
            formula = f" ({value['formula']})" if value.get("formula") else ""
            value = f"{_plain(value['value'])} {value.get('unit', '')}{formula}".strip()
        elif isinstance(value, dict):
            value = ", ".join(f"{key} {_plain(item)}" for key, item in value.items() if item is not None)
        if value is not None:
            rows.append([name, _plain(value)])
    search = calibration.search
    if search:
        rows.append(["search", f"{plain(search.get('impacts'))} impacts, {plain(search.get('starts_agreeing'))} of "
                               f"{plain(search.get('starts'))} starts agree. {search.get('message') or ''}"])
    return table(["stated with this fit", ""], rows, left=2, prose=True, caption=f"{NOT}: what goes with law `{law}`.")


def _plain(value: Any) -> str:
    return sig(value, 4) if isinstance(value, float) and abs(value) < 1e4 else plain(value)


def _runs(context: Context, law: str) -> dict[str, Any] | None:
    """The errors that calibration.json states of this very fit: `fit` and `prediction`, simulated from rest."""
    calibration, rows = context.calibration, []
    for role, checks in (("fit", calibration.fit), ("predict", calibration.prediction)):
        for folder, errors in checks.items():
            rows.append([run_name(context, folder), ROLE_TEXT[role], known(errors.get("peak_force_error")), percent(errors.get("peak_displacement_error"), 2),
                         known(errors.get("rebound_error")), percent(errors.get("nrmse_displacement"), 2, False), percent(errors.get("nrmse_force"), 1, False)])
    return table(["run", "", "peak impact force", "peak displacement", "rebound", "NRMSE displacement", "NRMSE force"], rows, left=2, record="fit",
                 caption=f"{NOT}: errors of law `{law}` with the values above, simulated from rest. NRMSE: root mean square difference from first touch to 0.5 s "
                         "after the last release, displacement over L_c, force over its peak.")


def _other_laws(context: Context) -> dict[str, Any] | None:
    rows = []
    for row in context.calibration.other_rows:
        for name, p in row.get("parameters", {}).items():
            limits = p.get("interval_95", [])
            rows.append([row.get("law", "–"), name, sig(p.get("value"), 3), p.get("unit", "").strip("-"),
                         interval(*limits) if len(limits) == 2 else "–", p.get("verdict", "–")])
    said = of_what(context, context.calibration.other_rows[0]) if context.calibration.other_rows else ""
    return table(["law", "parameter", "value", "unit", "95 % interval", "verdict"], rows, left=2,
                 caption=f"{NOT}: what the other laws of the comparison come to, each fitted to all runs{said}; their errors stand in the chapter of the laws. Verdict: "
                         "determined; form (the data tell it, but the law does not follow them); flat, bound, noise or grazing (not told).")


def _unserving_pair(context: Context) -> dict[str, Any] | None:
    """A pair that was found, and not given, for it is not known well enough."""
    calibration = context.calibration
    if not calibration.constant_pair.get("sentence") or calibration.answer.get("pair"):
        return None
    return note(f"{NOT}: a pair that was found and is not given, for too little of it is known. {calibration.constant_pair['sentence']}")


def _pairs_of_the_law(context: Context) -> dict[str, Any] | None:
    """Pairs read off the answer's law, where the first page gives one for all speeds."""
    answer = context.calibration.answer
    if not answer.get("pair"):
        return None
    rows = [[sig(row.get("speed_m_s")), integer_of(row.get("k_i_kN_per_m")), fixed(row.get("e"), 3)] for row in answer.get("table", []) if is_number(row.get("k_i_kN_per_m"))]
    return table(["approach (m/s)", "k_i (kN/m)", "e"], rows, compact=True,
                 caption=f"{NOT}: pairs of law `{answer.get('pair_law') or '–'}`{of_mass(context.calibration)}, each for its one speed, that return the peak force and "
                         f"rebound of the answer's law `{context.calibration.law}` there.")


def integer_of(value: Any) -> str:
    """A stiffness with three figures."""
    return integer(float(f"{value:.3g}")) if is_number(value) else "–"


def _published(calibration: Calibration) -> list[str]:
    """How far the published pair is from this fit, and what the windows say of the reason."""
    k, e = calibration.pair("k_i"), calibration.pair("e")
    if not (k and e and is_number(k.published) and is_number(e.published)):
        return []
    sentences = [f"Published: k_i = {sig(k.published)} kN/m, e = {sig(e.published)}; by this fit {sig(k.value)} kN/m, {sig(e.value, 2)}."]
    rows = [(row.speed, row.k_i, row.e) for row in calibration.windows if row.k_i and row.e]
    if len(rows) < 2:
        return sentences
    published = k.published
    speed, near, restitution = min(rows, key=lambda row: abs(row[1].value / published - 1))
    sentences.append(f"Of the windows, each fitted alone, the one at {sig(speed, 2)} m/s comes nearest to the published "
                     f"stiffness: {sig(near.value)} kN/m, e = {sig(restitution.value, 2)}.")
    (low, slow, _), (high, fast, _) = rows[0], rows[-1]
    if fast.value < slow.value:
        sentences.append(f"The rim softens with speed: {sig(slow.value)} kN/m at {sig(low, 2)} m/s, "
                         f"{sig(fast.value)} kN/m at {sig(high, 2)} m/s. A pair belongs to the speeds it was fitted at. The published one was fitted to "
                         "the two pulses at scale 1, which graze the rim, and to rim dimensions that are not published (ours are assumptions, listed "
                         "under the inputs).")
    return sentences
