"""First the answer: k_i and e with their intervals beside the published pair, how far they hold, whether the rim
yields, and how well the pulses that were not fitted are predicted. For a single run: its peaks."""
import datetime

from ..blocks import KI, Section, bullets, cards, note
from ..figures import answer as figure_answer
from ..numbers import fixed, integer, interval, is_number, percent, power, scaled, sig
from .common import METRIC_NAMES, errors_of, impact_peak, short_name, status_note, title_of


def head(context):
    results = context.results
    reference = results.reference
    bearing = (reference.get("bearing", "name") if reference else None) or "friction-pendulum bearing"
    if results.single:
        run = results.entries[0].any_run
        title, subtitle = title_of(run.name), f"One run of {bearing}, {model_name(run)}"
    else:
        title, subtitle = f"Rim impact of {bearing}", "Finite-element reference and fitted impact parameters"
    version = _version(results)
    return {"title": title, "subtitle": subtitle, "date": datetime.date.today().strftime("%-d %B %Y"),
            "version": f"rimpact {version}" if version else "rimpact"}


def model_name(run):
    return "reduced model" if run.rung == "reduced" else f"finite elements, rung {run.rung}"


def _version(results):
    versions = results.main.get("versions")
    if isinstance(versions, dict) and versions.get("rimpact"):
        return versions["rimpact"]
    for entry in results.entries:
        if entry.any_run and entry.any_run.meta.get("version"):
            return entry.any_run.meta["version"]
    return ""


def make(context):
    section = Section("answer", "Summary" if context.results.single else "The answer")
    if context.results.single:
        _single(section, context.results.entries[0].any_run)
        return section
    calibration = context.calibration
    items = [_parameter_card(p) for p in calibration.parameters[:2]]
    items += [card for card in (_prediction_card(context), _yield_card(context)) if card]
    section.add(cards(items))
    if not calibration.parameters:
        section.add(note("Calibration: not run. There are no fitted values to report.", "missing"))
    section.add(bullets([s for s in (_validity(calibration), _identifiable(calibration), _yields(context),
                                     _predictions(context)) if s]))
    candidates = context.results.having("predict") + context.results.having("fit", "history")
    shown = max((entry for entry in candidates if entry.models()), key=lambda entry: len(entry.models()), default=None)
    section.add(context.pictures.figure("answer", "", figure_answer.draw, shown.models() if shown else [],
                                        short_name(shown.name) if shown else "", calibration))
    for warning in _warnings(context.results.main):
        section.add(note(warning, "warning"))
    for entry in context.results.entries:
        for _, run in entry.models():
            section.add(status_note(run))
    return section


def _single(section, run):
    s = run.summary
    values = [("Peak displacement", scaled(s.get("peak_displacement_m"), 1e3, 1), "mm",
               f"L_c = {scaled(run.lateral_capacity, 1e3, 0)} mm"),
              ("Peak lateral force", scaled(s.get("peak_lateral_force_N"), 1e-3, 0), "kN", "horizontal norm"),
              ("Peak impact force", scaled(s.get("peak_impact_force_N"), 1e-3, 0), "kN",
               f"{s.get('n_impacts', len(run.impacts))} impact(s)")]
    strain = s.get("max_plastic_strain")
    if is_number(strain):
        values.append(("Largest plastic strain", percent(strain, 2, signed=False), "", "rim and slider"))
    section.add(cards([{"title": t, "value": v, "unit": u, "lines": [line]} for t, v, u, line in values]))
    section.add(status_note(run))


def _warnings(main):
    found = main.get("warnings") or (main.get("totals") or {}).get("warnings") or []
    return [str(warning) for warning in ([found] if isinstance(found, str) else found)]


def _parameter_card(p):
    is_k = p.name == "k_i"
    show = (lambda x: power(x, 3)) if is_k else (lambda x: fixed(x, 3))
    lines = [f"95 %: {interval(*p.interval)}" if p.interval else "no interval available"]
    if p.published is not None:
        lines.append(f"published {power(p.published, 2) if is_k else sig(p.published, 2)} "
                     f"(ours\u00a0{percent(p.value / p.published - 1, 0)})")
    if p.identifiable is False:
        lines.append("not identifiable from these runs")
    return {"title": {"k_i": "Impact stiffness", "e": "Coefficient of restitution"}.get(p.name, p.name),
            "symbol": KI if is_k else p.name, "value": show(p.value), "unit": p.unit if p.unit != "-" else "",
            "lines": lines}


def _predicted(context):
    """(entry, fitted error, published error) of the peak force on runs that were not fitted."""
    return [(entry, errors_of(context, entry, "fitted").get("peak_force"),
             errors_of(context, entry, "published").get("peak_force")) for entry in context.results.having("predict")]


def _prediction_card(context):
    known = [(entry, error) for entry, error, _ in _predicted(context) if is_number(error)]
    if not known:
        return None
    entry, worst = max(known, key=lambda pair: abs(pair[1]))
    return {"title": "Peak impact force, predicted", "value": percent(worst, 1), "unit": "",
            "lines": [f"largest error of {len(known)} pulses not fitted", title_of(entry.name)]}


def _strains(context):
    return [(entry, entry.fe.summary["max_plastic_strain"]) for entry in context.results.entries
            if entry.fe is not None and is_number(entry.fe.summary.get("max_plastic_strain"))]


def _yield_card(context):
    strains = _strains(context)
    if not strains:
        return None
    entry, largest = max(strains, key=lambda pair: pair[1])
    return {"title": "Do rim or slider yield?", "value": "Yes" if largest > 1e-6 else "No", "unit": "",
            "lines": [f"plastic strain up to {percent(largest, 1, signed=False)}, in either", title_of(entry.name)]}


def _validity(calibration):
    if calibration.validity:
        return "Range of validity.", calibration.validity
    if calibration.parameters:
        return "Range of validity.", "Not known: no impact windows over speed were run."
    return None


def _identifiable(calibration):
    doubtful = [p for p in calibration.parameters if p.identifiable is False]
    return ("Not identifiable.", "; ".join(f"{p.name}: {p.reason or 'see calibration'}" for p in doubtful)) \
        if doubtful else None


def _yields(context):
    strains = _strains(context)
    if not strains:
        return ("Yielding.", "No finite-element run tells the plastic strain.") if context.results.entries else None
    yielded = [(entry, strain) for entry, strain in strains if strain > 1e-6]
    sentence = f"Plastic strain develops in {len(yielded)} of {len(strains)} finite-element runs"
    slow = [entry.speed for entry, _ in yielded if entry.role == "window" and entry.speed]
    return "Yielding.", sentence + (f", already at {sig(min(slow), 2)} m/s." if slow else ".")


def _predictions(context):
    parts = []
    for entry, fitted, published in _predicted(context):
        if not is_number(fitted) or entry.fe is None:
            continue
        said = f"{title_of(entry.name)}: FE {integer(1e-3 * impact_peak(entry.fe))} kN, {METRIC_NAMES['peak_force']} "
        said += f"{percent(fitted)} by the fitted pair"
        parts.append(said + (f", {percent(published)} by the published pair" if is_number(published) else ""))
    return ("Pulses not fitted.", "; ".join(parts) + ".") if parts else None
