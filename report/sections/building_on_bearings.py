"""A building on many bearings: every bearing, every floor, the plan with its orbits and the shape at the hardest impact."""
from typing import Any

from ..blocks import Section, note, table
from ..context import Context
from ..figures import building_on_bearings, storeys
from ..numbers import is_number, scaled, sig
from .common import tables_note

G = 9.80665


def make(context: Context) -> Section:
    section = Section("building-on-bearings", "The building on its bearings")
    for entry in context.results.entries:
        run = entry.fitted
        building = run.summary.get("building") if run is not None else None
        if run is None or not building:
            continue
        section.add(_bearings(building))
        section.add(_springs(building))
        section.add(_floors(building))
        section.add(context.pictures.figure(f"building-on-bearings-{entry.name}",
                                            "Plan: the orbit of every bearing inside its rim, impacts thick, with its normal force at the hardest "
                                            "impact. Elevations: the frame at rest and at that instant.", building_on_bearings.draw, run))
        section.add(context.pictures.figure(f"storeys-{entry.name}", "Over the height, storeys counted from the base up.", storeys.draw_profiles, run))
        section.add(context.pictures.figure(f"floors-{entry.name}", "Storeys and roof over time.", storeys.draw_histories, run, curves=storeys.histories))
        section.add(tables_note(run))
    return section


def _bearings(building: dict[str, Any]) -> dict[str, Any] | None:
    rows = [[str(i), scaled(b.get("peak_displacement_m"), 1e3, 1), scaled(b.get("static_normal_force_N"), 1e-3, 0), scaled(b.get("min_normal_force_N"), 1e-3, 0),
             scaled(b.get("max_normal_force_N"), 1e-3, 0), scaled(b.get("peak_force_N"), 1e-3, 0), str(b.get("impacts", "–")), scaled(b.get("peak_impact_force_N"), 1e-3, 0),
             scaled(b.get("peak_uplift_m"), 1e3, 2)] for i, b in enumerate(building.get("bearings", []), 1)]
    worst = building.get("worst_bearing")
    return table(["bearing", "travel (mm)", "N at rest (kN)", "least (kN)", "largest (kN)", "lateral force (kN)", "impacts", "rim force (kN)", "lifted (mm)"], rows,
                 caption=f"Largest over the run. The worst bearing is number {worst}." if worst else "")


def _springs(building: dict[str, Any]) -> dict[str, Any] | None:
    springs = building.get("dish_springs")
    if not springs or not is_number(springs.get("stiffness_N_per_m")):
        return None
    return note(f"Every dish stands on a vertical spring of {sig(1e-3 * springs['stiffness_N_per_m'], 3)} kN/m"
                + (", an assumption of ours" if springs.get("assumed") else "") + ". Vertical forces and the overturning moment depend on it.")


def _floors(building: dict[str, Any]) -> dict[str, Any] | None:
    rows = [[str(i), scaled(f.get("peak_drift_x_m"), 1e3, 2), scaled(f.get("peak_drift_y_m"), 1e3, 2), scaled(f.get("peak_shear_N"), 1e-3, 0),
             sig(f["peak_acceleration_m_s2"] / G, 3) if is_number(f.get("peak_acceleration_m_s2")) else "–"] for i, f in enumerate(building.get("floors", []), 1)]
    return table(["storey", "drift x (mm)", "drift y (mm)", "shear (kN)", "acceleration of its floor (g)"], rows, caption="From the base up.") if rows else None
