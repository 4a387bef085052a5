"""Each ground motion: FE and reduced model over one another, the panels of thesis Figures 2-7 and 2-8, then a zoom on
every impact."""
from typing import Any

from .. import interactive
from ..blocks import Section, heading, note, table
from ..context import Context
from ..figures import impacts, response_panels, triple
from ..numbers import fixed, integer, is_number, percent, scaled
from ..results import SLOTS, Entry
from ..run_folder import Run
from ..series import shown_part
from .common import ROLE_TEXT, errors_of, hardest, labels_of, status_note, title_of


def make(context: Context) -> Section:
    results = context.results
    entries = results.entries if results.single else results.histories + results.having("push")
    section = Section("histories", "Response" if results.single else "Finite elements and reduced model, pulse by pulse")
    if not results.single:
        section.lead = ("Forces are drawn as −F, so that loops read as in the thesis. Impacts are zoomed from each "
                        "model's own touch, since touch times differ slightly between models.")
    for entry in entries:
        _entry(section, context, entry)
    return section


def _entry(section: Section, context: Context, entry: Entry) -> None:
    if not context.results.single:
        section.add(heading(context.doubts.marked(entry.name, title_of(entry.name)), ROLE_TEXT.get(entry.role, "")))
    models = [(role, run) for role, run in entry.models() if run.has("time", "displacement_x", "displacement_y")]
    for _, run in models:
        section.add(status_note(run) if not context.results.single else None)
    if entry.fe is None and not context.results.single:
        section.add(note("There is no finite-element run of it.", "missing"))
    section.add(_numbers(context, entry))
    if not models:
        section.add(note("No response is stored.", "missing"))
        return
    labels = labels_of(models)
    capacity = next((run.lateral_capacity for _, run in models if run.lateral_capacity), None)
    shown = [(role, shown_part(run)) for role, run in models]
    cut = " The window's flight after its impact is left out." if any(part is not run for (_, part), (_, run) in zip(shown, models)) else ""
    section.add(context.pictures.figure(
        f"response-{entry.name}", "Displacement, lateral force, loop and vertical displacement of the upper slider. "
        "Dotted red: lateral capacity L_c." + cut, response_panels.draw, shown, labels, capacity, curves=interactive.response))
    for _, run in models:
        if run.has("face_1_travel_x", "face_4_rim_force"):
            section.add(context.pictures.figure(f"faces-{entry.name}", "What each face of the triple pendulum adds to the displacement, and the force of "
                                                "its rim.", triple.travel, run))
    zoom = context.pictures.figure(
        f"impacts-{entry.name}", _impact_caption(models), impacts.draw, models, labels, curves=interactive.impacts)
    section.add(zoom if zoom else note("The rim is not touched in any of the models.", "info"))


def _impact_caption(models: list[tuple[str, Run]], most: int = 4) -> str:
    n = max(len(run.impacts) for _, run in models)
    shown = f" The first {most} of {n} are shown." if n > most else ""
    return "Rim force through each impact, over time and over penetration." + shown


def _numbers(context: Context, entry: Entry) -> dict[str, Any] | None:
    labels = labels_of([(who, getattr(entry, who)) for who in SLOTS if getattr(entry, who) is not None]) | {"fe": "FE"}
    known = [(who, labels[who], getattr(entry, who)) for who in SLOTS if getattr(entry, who) is not None]
    if not known:
        return None
    rows = [
        ["peak displacement (mm)", *(scaled(r.summary.get("peak_displacement_m"), 1e3, 1) for _, _, r in known)],
        ["peak lateral force (kN)", *(scaled(r.summary.get("peak_lateral_force_N"), 1e-3, 0) for _, _, r in known)],
        ["peak impact force (kN)", *(scaled(r.summary.get("peak_impact_force_N"), 1e-3, 0) for _, _, r in known)],
        ["impacts", *(integer(r.summary.get("n_impacts", len(r.impacts))) for _, _, r in known)],
        ["hardest impact: approach (m/s)", *(fixed(hardest(r).get("approach_speed_m_s"), 3) for _, _, r in known)],
        ["hardest impact: rebound (m/s)", *(fixed(hardest(r).get("rebound_speed_m_s"), 3) for _, _, r in known)],
        ["hardest impact: contact time (ms)", *(_contact(hardest(r)) for _, _, r in known)],
        ["peak vertical displacement (mm)",
         *(scaled(r.summary.get("peak_vertical_displacement_m"), 1e3, 1) for _, _, r in known)],
        ["displacement at the end (mm)", *(scaled(r.summary.get("residual_displacement_m"), 1e3, 1) for _, _, r in known)],
        ["speed at the end, 0 at rest (m/s)", *(fixed(r.summary.get("final_speed_m_s"), 3) for _, _, r in known)],
        ["smallest normal force (kN)", *(scaled(r.summary.get("min_normal_force_N"), 1e-3, 0) for _, _, r in known)],
        ["largest plastic strain", *(percent(r.summary.get("max_plastic_strain"), 2, False) for _, _, r in known)],
    ]
    if entry.fe is not None and len(known) > 1:
        rows.insert(3, ["    error against FE", "", *(percent(errors_of(entry, who).get("peak_force"))
                                                      for who, _, _ in known if who != "fe")])
    rows = [row for row in rows if any(cell not in ("–", "") for cell in row[1:])]
    return table(["", *(label for _, label, _ in known)], rows, record=f"runs/{entry.name}")


def _contact(impact: dict[str, float]) -> str:
    touch, release = impact.get("touch_time_s"), impact.get("release_time_s")
    return fixed(1e3 * (release - touch), 1) if is_number(touch) and is_number(release) else "–"
