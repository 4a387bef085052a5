"""FE and what the reduced model makes of the same scenes, side by side."""
from typing import Any

from ..blocks import Section, table
from ..context import Context
from ..figures import calibration as figure_calibration
from ..numbers import fixed, percent, scaled
from ..results import SLOTS
from ..run_folder import Run
from .common import ROLE_TEXT, errors_of, hardest, impact_peak, judged_errors, labels_of, law_of, short_name, title_of

PUBLISHED = (" The published study reports 10 % and 2 % on the peak impact force of the two pulses at scale 1, both of which only "
             "graze the rim.")


def make(context: Context) -> Section | None:
    if context.results.single:
        return None
    section = Section("comparison", "Finite elements and reduced models compared")
    rows: list[Any] = []
    for entry in context.results.histories:
        runs = [(who, getattr(entry, who)) for who in SLOTS if getattr(entry, who) is not None]
        if len(runs) < 2:
            continue
        rows.append({"span": context.doubts.marked(entry.name, title_of(entry.name)), "tag": ROLE_TEXT.get(entry.role, "")})
        labels = labels_of(runs)
        rows += [_row(labels[who], run, {} if who == "fe" else errors_of(entry, who)) for who, run in runs]
    section.add(table(["model", "impact force (kN)", "error", "displacement (mm)", "error",
                       "approach (m/s)", "rebound (m/s)", "error", "impacts"], rows,
                      caption="Peaks are of the horizontal norm; speeds are of the hardest impact. Errors are signed and "
                              "relative to FE." + (PUBLISHED if context.calibration.published_applies else ""), record="runs"))
    law, entries = law_of(context), context.results.histories
    errors = [{"name": short_name(entry.name), "fitted": judged_errors(context, entry), "published": errors_of(entry, "published")} for entry in entries]
    published = ", and with the published pair" if any(row["published"] for row in errors) else ""
    section.add(context.pictures.figure("calibration-errors", f"Signed errors against FE of the reduced model with law {law}{published}, from rest.",
                                        figure_calibration.draw_errors, errors, law))
    section.add(context.pictures.figure(
        "calibration-residuals", f"First impact of every ground motion, FE and the reduced model with law {law}, from rest.",
        figure_calibration.draw_residuals, entries, label=short_name))
    return section


def _row(label: str, run: Run, errors: dict[str, float]) -> list[str]:
    impact = hardest(run) if run else {}
    summary = run.summary if run else {}
    return [label, scaled(impact_peak(run) if run else None, 1e-3, 0),
            percent(errors.get("peak_force")) if errors else "", scaled(summary.get("peak_displacement_m"), 1e3, 1),
            percent(errors.get("peak_displacement"), 2) if errors else "", fixed(impact.get("approach_speed_m_s"), 3),
            fixed(impact.get("rebound_speed_m_s"), 3), percent(errors.get("rebound")) if errors else "",
            fixed(summary.get("n_impacts"), 0)]
