"""Single impacts at given speeds: what the reference says of each, and how far the answer's law is from it."""
from typing import Any

from ..blocks import Section, table
from ..calibration_file import WindowRow, last_part
from ..context import Context
from ..figures import impacts
from ..numbers import fixed, is_number, percent, scaled, sig
from ..results import Entry
from ..run_folder import Run
from .common import hardest, judged_errors, labels_of, law_of, status_note


def make(context: Context) -> Section | None:
    if context.results.single:
        return None
    section = Section("windows", "Single impacts over speed")
    entries, calibration = context.results.windows, context.calibration
    if not entries and not calibration.windows:
        return None
    section.lead = ("One impact at a given speed, without ground motion, weight or friction: only here is rebound over approach speed "
                    "the restitution e.")
    section.add(_table(context, entries))
    for entry in entries:
        section.add(status_note(entry.fe) if entry.fe else None)
    section.add(context.pictures.figure(
        "windows-force", _caption(entries),
        impacts.draw_windows, entries))
    return section


def _caption(entries: list[Entry]) -> str:
    """Solid, dotted, dashed: what each is, as the runs say."""
    labels: dict[str, str] = next((labels_of(entry.models()) for entry in entries if entry.fitted or entry.law), {})
    beside = [f"{style} {labels[who]}" for who, style in (("fitted", "dotted:"), ("law", "dashed:")) if who in labels]
    return "Solid: finite elements" + "".join(f"; {said}" for said in beside) + ", at the same speed."


def _table(context: Context, entries: list[Entry]) -> dict[str, Any] | None:
    calibration = context.calibration
    judged = any(judged_errors(context, entry) for entry in entries)
    rows, used = [], set()
    for entry in entries:
        impact = hardest(entry.fe) if entry.fe else {}
        speed = entry.speed or impact.get("approach_speed_m_s")
        row = next((r for r in calibration.windows if is_number(speed) and abs(r.speed - speed) < 0.02 * speed), None)
        used.add(id(row))
        rows.append(_row(sig(speed) + context.doubts.mark(entry.name), impact, entry.fe, row) + ([percent(judged_errors(context, entry).get("peak_force"))] if judged else []))
    for row in calibration.windows:
        if id(row) not in used:
            rows.append(_row(sig(row.speed) + context.doubts.mark(last_part(row.folder)), {}, None, row) + (["–"] if judged else []))
    law = law_of(context)
    return table(["approach (m/s)", "peak force (kN)", "contact (ms)", "penetration (mm)", "rebound / approach", "plastic strain",
                  *([f"{law}: peak force"] if judged else [])], rows, left=0, record="runs" if judged else "",
                 caption=f"{'Measured' if context.measured else 'Finite-element'} figures of each window" + (
                     f", and the error of the peak force by the reduced model with law `{law}`, flown from the window's start." if judged else "."))


def _row(speed: str, impact: dict[str, float], run: Run | None, row: WindowRow | None) -> list[Any]:
    touch, release = impact.get("touch_time_s"), impact.get("release_time_s")
    contact = release - touch if is_number(touch) and is_number(release) else row.contact_time_s if row else None
    peak = impact.get("peak_force_N") or (row.peak_force_N if row else None)
    return [speed, scaled(peak, 1e-3, 0), scaled(contact, 1e3, 1), scaled(impact.get("peak_penetration_m"), 1e3, 2),
            fixed(impact.get("restitution") or (row.restitution if row else None), 3),
            percent(run.summary.get("max_plastic_strain") if run else None, 2, False)]
