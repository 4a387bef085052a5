"""The deformed rim, coloured by plastic strain, drawn from the last fields that the run itself lists."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import rim_picture, vtu
from ..blocks import Section, heading
from ..errors import DataError
from ..results import Entry
from ..run_folder import Run
from ..stored_fields import instants
from .common import title_of, turning_model

if TYPE_CHECKING:
    from ..context import Context

LATEST = 8  # fields looked at, each touched arc of the rim writes its own
MOST = 4  # pictures; drawing one takes about a second


def make(context: Context) -> Section | None:
    runs = [(entry, entry.fe) for entry in context.results.entries if entry.fe is not None and _meets_the_rim(entry.fe)]
    if not runs and context.results.single:
        return None
    section = Section("rim", "The deformed rim")
    chosen = _most_strained(runs)
    section.lead = "Equivalent plastic strain on rim and slider" + (
        "" if context.results.single else ", for the runs that strain the rim most") + "."
    for entry, run in chosen:
        shown = _shown(context, entry, run)
        if shown:
            section.add(None if context.results.single else heading(context.doubts.marked(entry.name, title_of(entry.name))))
            for block in shown:
                section.add(block)
    return section


def _meets_the_rim(run: Run) -> bool:
    return run.rung != "reduced" and (run.rung == "rim" or bool(run.impacts))


def _most_strained(runs: list[tuple[Entry, Run]]) -> list[tuple[Entry, Run]]:
    """Histories first, then windows; within each the hardest."""
    with_fields = [(entry, run) for entry, run in runs if instants(run)]
    with_fields.sort(key=lambda pair: (pair[0].role == "window", -pair[1].summary.get("max_plastic_strain", 0.0)))
    histories = [pair for pair in with_fields if pair[0].role != "window"]
    windows = [pair for pair in with_fields if pair[0].role == "window"]
    return histories[:MOST - 1] + windows[:MOST - len(histories[:MOST - 1])]


def _shown(context: Context, entry: Entry, run: Run) -> list[dict[str, Any]]:
    """The picture of the most strained fields, and the model to be turned where its stresses are known. Empty where there is none."""
    try:
        grid, time = _most_strained_fields(instants(run)[-LATEST:])
    except DataError as error:
        context.problems.append(f"figure rim-{entry.name} could not be drawn: {error}")
        return []
    picture = context.pictures.figure(f"rim-{entry.name}", "The most strained of the stored fields.", _draw, grid)
    return [block for block in (picture, turning_model(grid, run, time) if picture else None) if block]


def _most_strained_fields(files: list[tuple[str, float | None]]) -> tuple[vtu.Grid, float | None]:
    """The last of the most strained fields."""
    return max(((vtu.read(file), time) for file, time in reversed(files)), key=lambda pair: rim_picture.largest_strain(pair[0]))


def _draw(grid: vtu.Grid, path: str) -> str:
    rim_picture.draw(grid, path)
    return path
