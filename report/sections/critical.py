"""Critical amplitudes and the sensitivity of grazing impacts."""
from typing import Any

from ..blocks import Section, table
from ..calibration_file import pick
from ..context import Context
from ..figures import critical as figure_critical
from ..numbers import is_number, plain, scaled, sig
from ..results import SLOTS
from .common import hardest, impact_peak, labels_of, short_name


def make(context: Context) -> Section | None:
    if context.results.single:
        return None
    section = Section("critical", "Critical amplitudes and grazing")
    section.lead = ("Where a pulse just touches the rim, the peak force is a nearly singular function of everything, so the amplitude of "
                    "first touch says more than the force.")
    if context.calibration.published_applies:
        section.lead += " The published pulses were scaled until they did."
    section.add(_grazing(context.calibration.grazing))
    families, critical, labels = _families(context)
    section.add(context.pictures.figure(
        "critical-amplitudes", "Dotted red: scale at which the reduced model first touches the rim.",
        figure_critical.draw, families, critical, labels))
    return section


def _grazing(reports: list[Any]) -> dict[str, Any] | None:
    rows = []
    for item in reports:
        speed, force = _band(pick(item, "approach_speed"), 1.0, 3), _band(pick(item, "peak_impact_force"), 1e-3, 0)
        rows.append([short_name(item.get("scene", "")), sig(item.get("scale"), 3), sig(item.get("critical_scale"), 5),
                     sig(pick(item, "critical_amplitude"), 4), speed, force])
    varied: list[str] = next((item["varied"] for item in reports if item.get("varied")), [])
    return table(["pulse", "scale", "critical scale", "critical amplitude (g)", "approach speed (m/s)",
                  "peak impact force (kN)"], rows,
                 caption="Reduced model. In brackets: the band" + (f" over {plain(varied)}." if varied else "."))


def _band(band: dict[str, float] | float | None, factor: float, decimals: int) -> str:
    if isinstance(band, dict):
        nominal, low, high = (scaled(band.get(k), factor, decimals) for k in ("nominal", "low", "high"))
        return f"{nominal} ({low} to {high})"
    return scaled(band, factor, decimals)


def _families(context: Context) -> tuple[dict[str, list[dict[str, Any]]], dict[str, float], dict[str, str]]:
    """Entries that differ in scale only, by pulse; first touches; what the models are called."""
    families: dict[str, list[dict[str, Any]]] = {}
    critical: dict[str, float] = {}
    labels: dict[str, str] = {}
    for entry in context.results.histories:
        run = entry.any_run
        if run is None or run.kind != "ricker":
            continue
        a, period = run.get("excitation", "amplitude_g"), run.get("excitation", "period_s")
        name = f"{a:g} g, {period:.1f} s" if is_number(a) and is_number(period) else entry.name
        point: dict[str, Any] = {"scale": entry.scale}
        labels |= {who: label for who, label in labels_of(entry.models()).items() if who != "law"}
        for who, model in entry.models():
            point[who] = (impact_peak(model) or 0.0, hardest(model).get("approach_speed_m_s", 0.0))
        families.setdefault(name, []).append(point)
        for item in context.calibration.grazing:
            if entry.name.startswith(item.get("scene", "-")) and is_number(item.get("critical_scale")):
                critical[name] = item["critical_scale"]
    return families, critical, {who: labels[who] for who in SLOTS if who in labels}
