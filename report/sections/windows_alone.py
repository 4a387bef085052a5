"""Each window fitted by itself: a part of the appendix, for each of its pairs holds at one speed only."""
from collections.abc import Callable

from ..blocks import Section, heading, note, table
from ..calibration_file import Parameter
from ..context import Context
from ..figures import windows as figure_windows
from ..numbers import fixed, percent, power, sig
from .common import of_mass


def windows_alone(context: Context, section: Section) -> None:
    calibration = context.calibration
    if not any(row.k_i or row.e for row in calibration.windows) and not calibration.speed_laws:
        return
    law = calibration.derived.get("law") or "–"
    what = f"Not the answer: law `{law}`{of_mass(calibration)}, fitted to each window alone; every pair is of its one speed."
    section.add(heading("Each window by itself"))
    section.add(context.pictures.figure("ki-and-e-over-speed", what + (" Shaded: speeds at which one pair of that law, fitted to all, holds." if calibration.valid_from else ""),
                                        figure_windows.draw, calibration))
    section.add(table(["approach (m/s)", "k_i (kN/m)", "e", "one pair for all: peak force"],
                      [[sig(row.speed), _with_interval(row.k_i, lambda x: power(x, 3)), _with_interval(row.e, lambda x: fixed(x, 3)), percent(row.pair_force_error)]
                       for row in calibration.windows], left=0, record="windows",
                      caption=what + " Values with the half-width of the 95 % interval; last, the error of one pair of that law, restarted at touch."))
    section.add(note(f"Not the answer. {calibration.validity}") if calibration.validity else None)
    rows = [[name, f"{sig(one.get('coefficient'), 3)} {one.get('unit', '').strip('-')} · (v / 1 m/s)^{fixed(one.get('exponent'), 2)}",
             f"{sig(one.get('from_m_s'), 2)} to {sig(one.get('to_m_s'), 2)}", percent(one.get("largest_error"), 0, False)]
            for name, one in calibration.speed_laws.items()]
    section.add(table(["parameter", "over speed", "from windows (m/s)", "largest error"], rows, left=2, compact=True, record="speed_laws",
                      caption=f"Not the answer: the pairs of the windows, law `{law}`{of_mass(calibration)}, as a function of the approach speed."))


def _with_interval(parameter: Parameter | None, show: Callable) -> str:
    if parameter is None:
        return "–"
    if not parameter.interval:
        return show(parameter.value)
    half = 0.5 * (parameter.interval[1] - parameter.interval[0]) / parameter.value if parameter.value else None
    return f"{show(parameter.value)} ± {percent(half, 1, False)}"
