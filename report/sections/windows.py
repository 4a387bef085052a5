"""Single impacts at given speeds: k_i and e over speed, and the range in which one pair serves."""
from collections.abc import Callable
from typing import Any

from ..blocks import Section, note, table
from ..calibration_file import Calibration, Parameter, WindowRow
from ..context import Context
from ..figures import impacts
from ..figures import windows as figure_windows
from ..numbers import fixed, is_number, percent, plain, power, scaled
from ..results import Entry
from ..run_folder import Run
from .common import errors_of, hardest, labels_of, status_note


def make(context: Context) -> Section | None:
    if context.results.single:
        return None
    section = Section("windows", "Impact stiffness and restitution over speed")
    entries, calibration = context.results.windows, context.calibration
    if not entries and not calibration.windows:
        return None
    section.lead = ("One impact at a given speed, without ground motion, weight or friction: only here is rebound over approach speed "
                    "the restitution e." + (" Shaded: the speeds at which the constant pair holds." if calibration.valid_from else ""))
    section.add(context.pictures.figure("ki-and-e-over-speed", "", figure_windows.draw, calibration))
    if calibration.validity:
        section.add(note(calibration.validity))
    section.add(_table(context, entries, calibration))
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


def _table(context: Context, entries: list[Entry], calibration: Calibration) -> dict[str, Any] | None:
    rows, used = [], set()
    for entry in entries:
        impact = hardest(entry.fe) if entry.fe else {}
        speed = entry.speed or impact.get("approach_speed_m_s")
        row = next((r for r in calibration.windows if is_number(speed) and abs(r.speed - speed) < 0.02 * speed), None)
        used.add(id(row))
        rows.append(_row(plain(speed) + context.doubts.mark(entry.name), impact, entry.fe, row,
                         errors_of(context, entry, entry.best).get("peak_force")))
    for row in calibration.windows:
        if id(row) not in used:
            rows.append(_row(plain(row.speed), {}, None, row, None))
    return table(["approach (m/s)", "peak force (kN)", "contact (ms)", "penetration (mm)", "rebound / approach",
                  "plastic strain", "k_i (kN/m)", "e", "reduced: peak force"], rows, left=0,
                 caption=f"{'Measured' if context.measured else 'Finite-element'} figures of each window, k_i and e fitted to it alone (95 % "
                         "interval half-width), and the error of the peak force by the reduced model.")


def _row(speed: str, impact: dict[str, float], run: Run | None, row: WindowRow | None, error: float | None) -> list[Any]:
    touch, release = impact.get("touch_time_s"), impact.get("release_time_s")
    contact = release - touch if is_number(touch) and is_number(release) else row.contact_time_s if row else None
    peak = impact.get("peak_force_N") or (row.peak_force_N if row else None)
    if error is None and row:
        error = row.pair_force_error
    return [speed, scaled(peak, 1e-3, 0), scaled(contact, 1e3, 1), scaled(impact.get("peak_penetration_m"), 1e3, 2),
            fixed(impact.get("restitution") or (row.restitution if row else None), 3),
            percent(run.summary.get("max_plastic_strain") if run else None, 2, False),
            _with_interval(row.k_i if row else None, lambda x: power(x, 3)),
            _with_interval(row.e if row else None, lambda x: fixed(x, 3)), percent(error)]


def _with_interval(parameter: Parameter | None, show: Callable) -> str:
    if parameter is None:
        return "–"
    if not parameter.interval:
        return show(parameter.value)
    half = 0.5 * (parameter.interval[1] - parameter.interval[0]) / parameter.value if parameter.value else None
    return f"{show(parameter.value)} ± {percent(half, 1, False)}"
