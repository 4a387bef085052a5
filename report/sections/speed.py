"""What each result cost, beside its error: speed is never reported alone."""
from ..blocks import Section, note, table
from ..figures import speed as figure_speed
from ..numbers import duration, integer, is_number, memory, percent
from .common import errors_of, title_of


def make(context):
    section = Section("speed", "Speed beside error")
    rows = []
    for entry in context.results.entries:
        for who, run in (("fe", entry.fe), ("fitted", entry.fitted), ("published", entry.published)):
            if run is not None and is_number(run.summary.get("wall_time_s")):
                rows.append(_row(context, entry, who, run))
    if not rows:
        section.add(note("No run tells its wall time.", "missing"))
        return section
    section.add(table(["run", "model", "mesh", "wall time", "unknowns", "steps", "Newton", "memory",
                       "peak force against FE", "against finer mesh"], rows, left=2,
                      caption="The error of an FE run against the next finer mesh is given where a study is stored with "
                              "it; a dash says it is not known here."))
    runs = [entry.fe for entry in context.results.entries if entry.fe is not None and entry.fe.rung != "reduced"]
    section.add(context.pictures.figure("speed-time-split", "Where the wall time of the finite-element runs goes.",
                                        figure_speed.draw, runs))
    return section


def _row(context, entry, who, run):
    s = run.summary
    against = percent(errors_of(context, entry, who).get("peak_force")) if who != "fe" else \
        "reference" if not context.results.single else "–"
    finer = s.get("error_against_finer")
    finer = finer.get("peak_force") if isinstance(finer, dict) else finer
    return [title_of(entry.name), {"fe": f"FE, {run.rung}", "fitted": "reduced, fitted"}.get(who, "reduced, published")
            if not context.results.single else run.rung,
            integer(s.get("mesh")), duration(s["wall_time_s"]), integer(s.get("n_dofs") or None),
            integer(s.get("n_steps")), integer(s.get("n_newton_iterations") or None), memory(s.get("peak_memory_bytes")),
            against, percent(finer)]
