"""The fit: values, intervals, correlation, and how every run comes out."""
from typing import Any

from ..blocks import Section, bullets, heading, table
from ..calibration_file import Calibration
from ..context import Context
from ..figures import calibration as figure_calibration
from ..numbers import fixed, interval, is_number, percent, plain, power, sig
from .common import ROLE_TEXT, errors_of, row_name, short_name


def make(context: Context) -> Section | None:
    if context.results.single:
        return None
    section = Section("calibration", "Calibration")
    calibration = context.calibration
    if not calibration.parameters:
        return None
    law = f"law `{calibration.derived['law']}`" if isinstance(calibration.derived.get("law"), str) else "impact law"
    section.lead = f"The {law} of the reduced model, fitted to {'measured' if context.measured else 'stored'} impacts" + (
        f" of the {calibration.fitted_on}." if calibration.fitted_on else ".")
    section.add(_parameters(calibration))
    section.add(context.pictures.figure("calibration-parameters", "", figure_calibration.draw_parameters, calibration))
    section.add(_correlation(calibration))
    section.add(_derived(calibration))
    section.add(_runs(context))
    rows = [{"name": short_name(entry.name), "fitted": errors_of(context, entry, entry.best),
             "published": errors_of(context, entry, "published")} for entry in context.results.histories]
    section.add(context.pictures.figure("calibration-errors", "Signed errors of the reduced model against the reference.",
                                        figure_calibration.draw_errors, rows))
    section.add(context.pictures.figure(
        "calibration-residuals", "First impact of every ground motion, FE and fitted reduced model simulated from rest.",
        figure_calibration.draw_residuals, context.results.histories,
        label=short_name))
    section.add(bullets(calibration.notes))
    differences = _published(calibration)
    if differences:
        section.add(heading("The published values beside ours"))
        section.add(bullets(differences))
    return section


def _parameters(calibration: Calibration) -> dict[str, Any] | None:
    rows = []
    for p in calibration.parameters:
        told = "–" if p.identifiable is None else "yes" if p.identifiable else "no" + (f": {p.reason}" if p.reason else "")
        show = (lambda x: power(x, 3)) if is_number(p.value) and abs(p.value) >= 1e4 else (lambda x: sig(x, 3))
        limits = interval(*p.interval) if p.interval else "–"
        rows.append([p.name, show(p.value), p.unit.strip("-"), show(p.standard_error) if p.standard_error else "–", limits,
                     told, *([show(p.published) if p.published is not None else "–"] if calibration.published_applies else [])])
    return table(["parameter", "value", "unit", "standard error", "95 % interval", "identifiable", *(["published"] if calibration.published_applies else [])], rows)


def _correlation(calibration: Calibration) -> dict[str, Any] | None:
    names = list(calibration.correlation)
    if len(names) < 2:
        return None
    rows = [[name, *(fixed(calibration.correlation[name].get(other), 3) for other in names)] for name in names]
    condition = f" Condition number {sig(calibration.condition, 3)}." if is_number(calibration.condition) else ""
    return table(["correlation", *names], rows, caption="Correlation of the estimates." + condition,
                 compact=True)


def _derived(calibration: Calibration) -> dict[str, Any] | None:
    rows = []
    for name, value in calibration.derived.items():
        if name == "element":  # its parameters stand in the table above
            continue
        if isinstance(value, dict) and "value" in value:
            formula = f" ({value['formula']})" if value.get("formula") else ""
            value = f"{plain(value['value'])} {value.get('unit', '')}{formula}".strip()
        elif isinstance(value, dict):
            value = ", ".join(f"{key} {plain(item)}" for key, item in value.items() if item is not None)
        if value is not None:
            rows.append([name, plain(value)])
    search = calibration.search
    if search:
        rows.append(["search", f"{plain(search.get('impacts'))} impacts, {plain(search.get('starts_agreeing'))} of "
                               f"{plain(search.get('starts'))} starts agree. {search.get('message') or ''}"])
    return table(["stated with the fit", ""], rows, left=2, prose=True)


def _runs(context: Context) -> dict[str, Any] | None:
    rows = []
    for entry in context.results.histories:
        errors = errors_of(context, entry, entry.best)
        if errors:
            rows.append([row_name(context, entry), ROLE_TEXT.get(entry.role, ""), percent(errors.get("peak_force")),
                         percent(errors.get("peak_displacement"), 2), percent(errors.get("rebound")),
                         percent(errors.get("nrmse_displacement"), 2, False), percent(errors.get("nrmse_force"), 1, False)])
    return table(["run", "", "peak impact force", "peak displacement", "rebound", "NRMSE displacement",
                  "NRMSE force"], rows, left=2,
                 caption="Fitted reduced model against the reference. NRMSE: root mean square difference from first touch to 0.5 s "
                         "after the last release, displacement over L_c, force over its peak.")


def _published(calibration: Calibration) -> list[str]:
    """How far the published pair is from the fitted one, and what the windows say of the reason."""
    k, e = calibration.parameter("k_i"), calibration.parameter("e")
    if not (k and e and is_number(k.published) and is_number(e.published)):
        return []
    sentences = [f"Published: k_i = {sig(k.published)} kN/m, e = {sig(e.published)}; here {sig(k.value)} kN/m, "
                 f"{sig(e.value, 2)}."]
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
                         f"{sig(fast.value)} kN/m at {sig(high, 2)} m/s. A pair belongs to the speeds it was "
                         "fitted at; the published one was fitted to the two pulses at scale 1, which graze the rim, and to rim dimensions "
                         "that are not published (ours are assumptions, listed under the inputs).")
    return sentences
