"""What the bearing carries, where a run has a building: storey by storey, and over time."""
from typing import Any

from .. import interactive
from ..blocks import Section, heading, table
from ..context import Context
from ..figures import building as figure_building
from ..figures import storeys
from ..numbers import fixed, is_number, scaled, sig
from ..run_folder import Run
from .common import tables_note, title_of

G = 9.80665


def make(context: Context) -> Section:
    section = Section("building", "The building")
    for entry in context.results.entries:
        run = entry.fitted or entry.law or entry.fe
        if run is None or not is_number(run.summary.get("peak_drift_m")):
            continue
        section.add(None if context.results.single else heading(context.doubts.marked(entry.name, title_of(entry.name))))
        section.add(_peaks(run))
        section.add(_storeys(run))
        section.add(context.pictures.figure(f"building-{entry.name}", "First storey and roof over time, both horizontal directions.",
                                            figure_building.draw, run, curves=_curves))
        section.add(context.pictures.figure(f"storeys-{entry.name}", "Over the height, storeys counted from the base up.", storeys.draw_profiles, run))
        section.add(tables_note(run))
    return section


def _curves(run: Run) -> list[interactive.Panel]:
    return interactive.over_time(run, figure_building.PANELS)


def _peaks(run: Run) -> dict[str, Any] | None:
    s = run.summary
    acceleration = s.get("peak_floor_acceleration_m_s2")
    rows = [["peak storey drift (mm)", scaled(s["peak_drift_m"], 1e3, 2)], ["ductility, drift over yield", fixed(s.get("ductility"), 2)],
            ["peak storey shear (kN)", scaled(s.get("peak_storey_shear_N"), 1e-3, 0)],
            ["peak floor acceleration (g)", sig(acceleration / G, 3) if is_number(acceleration) else "–"]]
    if "collapsed" in s:
        rows.append(["collapsed", "yes" if s["collapsed"] else "no"])
    return table(["", "largest of all storeys"], [row for row in rows if row[1] != "–"], compact=True)


def _storeys(run: Run) -> dict[str, Any] | None:
    rows = [[str(i), scaled(storey.get("peak_drift_m"), 1e3, 2), scaled(storey.get("residual_drift_m"), 1e3, 2),
             scaled(storey.get("peak_shear_N"), 1e-3, 0), sig(storey["peak_acceleration_m_s2"] / G, 3) if is_number(storey.get("peak_acceleration_m_s2")) else "–"]
            for i, storey in enumerate(run.summary.get("superstructure", {}).get("storeys", []), 1)]
    return table(["storey", "peak drift (mm)", "residual drift (mm)", "peak shear (kN)", "acceleration of its floor (g)"], rows,
                 caption="From the base up. Peaks are of the horizontal norm.")
