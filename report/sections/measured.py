"""Measured curves: every impact of a laboratory's record with the law that was fitted to it."""
from ..blocks import Section, heading, note, table
from ..context import Context
from ..curves import ImpactCurve
from ..figures import measured as figure_measured
from ..numbers import integer, percent, scaled, sig

MOST = 24  # impacts drawn


def make(context: Context) -> Section | None:
    impacts = [impact for impact in context.results.impacts if impact.source == "measured"]
    if not impacts:
        return _not_stored(context)
    section = Section("measured", "Measured curves and their fit")
    law = context.results.curves.get("law", "")
    section.lead = (f"Each impact as it was measured, and the law `{law}` from the same state just before touch. Penetration is the "
                    "travel beyond L_c; force is positive where the rim pushes the slider back.")
    section.add(table(["impact", "approach (m/s)", "peak force (kN)", "by the law (kN)", "difference", "penetration (mm)", ""],
                      [_row(context, impact) for impact in impacts], left=(0, 6), record="curves",
                      caption=f"Law `{law}`: largest force of its curve beside the measured one."))
    for i, impact in enumerate(impacts[:MOST]):
        speed = f" at {sig(impact.speed, 3)} m/s" if impact.speed is not None else ""
        section.add(heading(f"{impact.name}{speed}", "fitted" if impact.fitted else "not fitted"))
        section.add(context.pictures.figure(f"measured-{i + 1}-{impact.name}", "", figure_measured.draw, impact, law))
    if len(impacts) > MOST:
        section.add(note(f"The first {MOST} of {len(impacts)} impacts are drawn."))
    return section


def _not_stored(context: Context) -> Section | None:
    """The fit of a measured curve that is not there to be drawn is said, not passed over."""
    if not context.measured:
        return None
    section = Section("measured", "Measured curves and their fit")
    section.add(note("No curves.json lies beside calibration.json, so the measured curves are not drawn; rimpact calibrate writes it.", "missing"))
    return section


def _row(context: Context, impact: ImpactCurve) -> list[str]:
    peak, depth = impact.reference.force.max(initial=0.0), impact.reference.penetration.max(initial=0.0)
    own = impact.law.force.max(initial=0.0) if impact.law is not None and len(impact.law.force) else None
    return [context.doubts.marked(impact.name, impact.name), sig(impact.speed, 3), integer(1e-3 * peak), scaled(own, 1e-3, 0),
            percent(own / peak - 1) if own is not None and peak > 0 else "–", scaled(depth, 1e3, 2),
            "grazes" if impact.grazing else "" if impact.fitted else "not fitted"]
