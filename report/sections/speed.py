"""What each result cost, beside its error: speed is never reported alone."""
from typing import Any

from .. import stored_studies
from ..blocks import Section, table
from ..context import Context
from ..figures import speed as figure_speed
from ..figures import study as figure_study
from ..numbers import duration, integer, is_number, memory, percent, scaled
from ..results import Entry
from ..run_folder import Run
from .common import errors_of, judged_errors, law_of, row_name, short_name


def make(context: Context) -> Section | None:
    section = Section("speed", "Speed beside error")
    single = context.results.single
    known = [entry for entry in context.results.entries
             if any(is_number((run.summary if run else {}).get("wall_time_s")) for run in (entry.fe, entry.fitted))]
    if not known:
        return None
    section.add(_single(context.results.only) if single else _all(context, known))
    runs = [(short_name(entry.name), entry.fe) for entry in known if entry.fe is not None and entry.fe.rung != "reduced"]
    section.add(context.pictures.figure("speed-time-split", "Where the wall time of the finite-element runs goes.",
                                        figure_speed.draw, runs))
    section.add(_work(runs))
    if not single:
        _frontiers(context, section)
    return section


def _work(runs: list[tuple[str, Run]]) -> dict[str, Any] | None:
    """What the solver did, counted: the same on every machine."""
    keys = ("newton_iterations", "backtracks", "eliminations", "linear_iterations", "factorisations", "augmentations", "steps_not_taken")
    rows = [[name, integer(run.summary.get("n_steps")), *(integer(run.summary["solver_work"].get(key)) for key in keys)]
            for name, run in runs if isinstance(run.summary.get("solver_work"), dict)]
    if not rows:
        return None
    return table(["run", "steps", "Newton", "shortened", "eliminated", "GMRES", "factors", "augmentations", "steps not taken"], rows,
                 caption="Work of the finite-element solver, in counts that no machine changes; a step of it each stands in response.h5.")


def _frontiers(context: Context, section: Section) -> None:
    """What the rungs that did not run would cost and change, from studies kept with the program."""
    reference = context.results.reference
    if reference is None or not context.calibration.published_applies:  # the studies are of the thesis's bearing
        return
    for scene, study in stored_studies.of_all_rungs(reference.get("bearing", "name")).items():
        rows = [[row["name"], duration(stored_studies.cost_of(row)), integer(row["n_dofs"] or None), scaled(row["peak_impact_force_N"], 1e-3),
                 *(("reference", "") if row["reference"] else (percent(row[key], 2, signed=False) for key in ("error", "nrmse_force")))]
                for row in study["rows"]]
        section.add(table(["run", stored_studies.cost_name(study["rows"]), "unknowns", "peak kN", "its error", "force history (RMS)"], rows,
                          caption=f"Every rung on {scene}, which touches at {study['scene']['approach_speed_m_s']:.2f} m/s, a study kept with the program: "
                                  "times of the machine it was made on; errors against the whole bearing deformable."))
        section.add(context.pictures.figure(f"speed-rungs-{scene}", f"Speed against error on {scene}.", figure_study.draw, study))


def _all(context: Context, entries: list[Entry]) -> dict[str, Any] | None:
    rows = [[row_name(context, entry), *_cost(entry.fe), _finer(entry.fe), _wall(getattr(entry, entry.best)),
             percent(judged_errors(context, entry).get("peak_force")),
             percent(errors_of(entry, "published").get("peak_force"))] for entry in entries]
    published = context.calibration.published_applies
    law = law_of(context)
    header = ["run", "mesh", "FE time", "unknowns", "steps", "Newton", "memory", "FE error", "reduced time",
              law, "published pair"]
    if not published:
        header, rows = header[:-1], [row[:-1] for row in rows]
    caption = f"Last, errors of the peak impact force against FE: reduced model with law {law}{' and with the published pair' if published else ''}"
    if all(row[7] == "–" for row in rows):
        header, rows = header[:7] + header[8:], [row[:7] + row[8:] for row in rows]
        caption += "; FE's own error is not known here (no study of speed against error is stored for these runs)"
    else:
        caption += "; FE's own from the stored study of the nearest impact speed (summary.json, error_estimate)"
    return table(header, rows, caption=caption + ".", record="runs")


def _single(run: Run) -> dict[str, Any] | None:
    return table(["model", "mesh", "wall time", "unknowns", "steps", "Newton", "memory", "FE error"],
                 [[run.rung, *_cost(run), _finer(run)]])


def _cost(run: Run | None) -> list[str]:
    s = run.summary if run else {}
    return [integer(s.get("mesh")), duration(s.get("wall_time_s")), integer(s.get("n_dofs") or None),
            integer(s.get("n_steps")), integer(s.get("n_newton_iterations") or None), memory(s.get("peak_memory_bytes"))]


def _wall(run: Run | None) -> str:
    return duration(run.summary.get("wall_time_s")) if run else "–"


def _finer(run: Run | None) -> str:
    return percent((run.summary if run else {}).get("error_estimate", {}).get("peak_force_relative"), signed=False)
