"""What several sections say in the same way: names of runs and roles, errors against FE, states of runs."""
from typing import Any

from .. import building_tables, view3d, vtu
from ..blocks import note, text, turning
from ..calibration_file import PAIR_LAWS, Calibration
from ..context import Context
from ..numbers import is_number, plain, sig
from ..results import Entry
from ..run_folder import Run
from ..stored_fields import said_of

ROLE_TEXT = {"fit": "used for the fit", "predict": "predicted, not fitted", "window": "single impact",
             "push": "quasi-static", "history": ""}
METRIC_NAMES = {"peak_force": "peak impact force", "peak_displacement": "peak displacement",
                "rebound": "rebound speed"}


def title_of(name: str) -> str:
    """ricker-0.78g-1.0s-x1.05 -> Ricker pulse 0.78 g, 1.0 s, × 1.05; other names as they are."""
    parts = name.split("-")
    if parts[0] == "ricker" and len(parts) >= 3 and parts[1].endswith("g") and parts[2].endswith("s"):
        scale = [f"×\u00a0{p[1:]}" for p in parts[3:] if p.startswith("x")]
        return ", ".join([f"Ricker pulse {parts[1][:-1]}\u00a0g", f"{parts[2][:-1]}\u00a0s"] + scale)
    if "window" in parts and _is_float(parts[-1]):
        return f"impact window {parts[-1]} m/s"
    return name


def short_name(name: str) -> str:
    """ricker-0.78g-1.0s-x1.05 -> 0.78 g, 1.0 s × 1.05, for the axes of figures."""
    return title_of(name).removeprefix("Ricker pulse ").removeprefix("impact ").replace(", ×", " ×")


def _is_float(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def labels_of(models: list[tuple[str, Run]]) -> dict[str, str]:
    """What a run is called beside others of the same scene: by how it was made, as its own scene says."""
    return {slot: _label(slot, run) for slot, run in models}


def _label(slot: str, run: Run) -> str:
    if run.rung != "reduced":
        return "finite elements"
    law = run.get("reduced", "impact_law")
    if slot == "published":
        return "reduced, published pair"
    return "reduced model" if not law else f"reduced, pair ({law})" if slot == "fitted" and law in PAIR_LAWS else f"reduced, {law}"


def row_name(context: Context, entry: Entry) -> str:
    """A run's name in a table's row, with a mark where the run is doubted."""
    return context.doubts.marked(entry.name, short_name(entry.name))


def turning_model(grid: vtu.Grid, run: Run, time: float | None) -> dict[str, Any]:
    """The block of a model to be turned."""
    said = said_of(run, time)
    return turning(view3d.data(grid, said), f"The same fields{' at ' + said if said else ''} to be turned: drag, or two fingers; the wheel "
                   "zooms after a click, Shift moves.")


def tables_note(run: Run) -> dict[str, Any] | None:
    """Writes a building's tables beside its run and says so."""
    names = building_tables.write(run)
    return text(" and ".join(f"`{name}`" for name in names) + " in the run's folder hold the same as tables, in SI.") if names else None


def impact_peak(run: Run) -> float | None:
    value = run.summary.get("peak_impact_force_N")
    return value if is_number(value) else None


def hardest(run: Run) -> dict[str, float]:
    """The impact with the largest force, or an empty dictionary."""
    impacts = [i for i in run.impacts if is_number(i.get("peak_force_N"))]
    return max(impacts, key=lambda i: i["peak_force_N"]) if impacts else {}


def figures_of(run: Run) -> dict[str, Any]:
    """Peaks that are compared between models, SI; None where the run does not know them."""
    return {"peak_force": impact_peak(run), "peak_displacement": run.summary.get("peak_displacement_m"),
            "rebound": hardest(run).get("rebound_speed_m_s")}


def errors_of(entry: Entry, who: str) -> dict[str, float]:
    """Signed relative errors of a stored run against the stored FE run, and of nothing else: what calibration.json states is of the
    law that it fitted, which need not be this run's."""
    run = getattr(entry, who)
    reference = figures_of(entry.fe) if entry.fe else {}
    candidate = figures_of(run) if run else {}
    pairs = ((metric, reference.get(metric), candidate.get(metric)) for metric in METRIC_NAMES)
    return {metric: b / a - 1 for metric, a, b in pairs if is_number(a) and is_number(b) and a != 0}


def law_of(context: Context, who: str = "best") -> str:
    """The law of the reduced runs in a slot, as the runs' own scenes say; "best": of those an entry is judged by."""
    for entry in context.results.entries:
        run = getattr(entry, entry.best if who == "best" else who)
        if run is not None and run.get("reduced", "impact_law"):
            return run.get("reduced", "impact_law")
    return "–"


def judged_errors(context: Context, entry: Entry) -> dict[str, float]:
    """Errors of the run an entry is judged by, if it is of law_of(context), the law that the table beside names."""
    run = getattr(entry, entry.best)
    return errors_of(entry, entry.best) if run is not None and run.get("reduced", "impact_law", default="–") == law_of(context) else {}


def of_mass(calibration: Calibration) -> str:
    """", at 86 952 kg", or nothing."""
    return f", at {plain(calibration.mass_kg)} kg" if is_number(calibration.mass_kg) else ""


def of_what(context: Context, row: dict[str, Any]) -> str:
    """Mass and speeds of the runs that a row of the laws was fitted to."""
    speeds = [error["approach_speed_m_s"] for error in row.get("runs", {}).values() if is_number(error.get("approach_speed_m_s"))]
    return of_mass(context.calibration) + (f", {sig(min(speeds))} to {sig(max(speeds))} m/s" if speeds else "")


def status_note(run: Run) -> dict[str, str] | None:
    """Says it when a run did not end as it should."""
    if run.status in ("done", "missing"):
        return None
    reason = run.summary.get("reason")
    return note(f"{run.name} ({run.rung}): {run.status}" + (f": {reason}" if reason else "") +
                ". What is shown of it is partial.", "warning")
