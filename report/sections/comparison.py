"""FE, the fitted pair, the best law and the published pair side by side."""
from ..blocks import Section, note, table
from ..figures.response_panels import LABELS
from ..numbers import fixed, percent, scaled
from .common import ROLE_TEXT, errors_of, hardest, impact_peak, title_of


def make(context):
    if context.results.single:
        return None
    section = Section("comparison", "FE, fitted and published values compared")
    rows = []
    for entry in context.results.histories:
        rows.append({"span": title_of(entry.name), "tag": ROLE_TEXT.get(entry.role, "")})
        for who, label in LABELS.items():
            run = getattr(entry, who)
            if who == "law" and run is None:
                continue
            errors = {} if who == "fe" else errors_of(context, entry, who)
            if run is None and not errors:
                rows.append([label, "not run"] + [""] * 7)
                continue
            rows.append(_row(label, run, errors))
    if not rows:
        section.add(note("There is nothing to compare: no ground motion was run.", "missing"))
        return section
    section.add(table(["model", "impact force (kN)", "error", "displacement (mm)", "error",
                       "approach (m/s)", "rebound (m/s)", "error", "impacts"], rows, 
                      caption="Peaks are of the horizontal norm; speeds are of the hardest impact. Errors are signed and "
                              "relative to FE. The published study reports 10 % and 2 % on the peak impact force of the "
                              "two pulses at scale 1, both of which only graze the rim."))
    return section


def _row(label, run, errors):
    impact = hardest(run) if run else {}
    summary = run.summary if run else {}
    return [label, scaled(impact_peak(run) if run else None, 1e-3, 0),
            percent(errors.get("peak_force")) if errors else "", scaled(summary.get("peak_displacement_m"), 1e3, 1),
            percent(errors.get("peak_displacement"), 2) if errors else "", fixed(impact.get("approach_speed_m_s"), 3),
            fixed(impact.get("rebound_speed_m_s"), 3), percent(errors.get("rebound")) if errors else "",
            fixed(summary.get("n_impacts"), 0)]
