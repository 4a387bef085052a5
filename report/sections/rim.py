"""The deformed rim, coloured by plastic strain, drawn from the last fields that the run itself lists."""
from .. import rim_picture, vtu
from ..blocks import Section, heading
from .common import instants, title_of

LATEST = 8  # fields looked at, each touched arc of the rim writes its own
MOST = 4  # pictures; drawing one takes about a second


def make(context):
    runs = [(entry, entry.fe) for entry in context.results.entries if _meets_the_rim(entry.fe)]
    if not runs and context.results.single:
        return None
    section = Section("rim", "The deformed rim")
    chosen = _most_strained(runs)
    section.lead = "Equivalent plastic strain on rim and slider" + (
        "" if context.results.single else ", for the runs that strain the rim most") + "."
    for entry, run in chosen:
        picture = _picture(context, entry, run)
        if picture:
            section.add(None if context.results.single else heading(context.doubts.marked(entry.name, title_of(entry.name))))
            section.add(picture)
    return section


def _meets_the_rim(run):
    return run is not None and run.rung != "reduced" and (run.rung == "rim" or bool(run.impacts))


def _most_strained(runs):
    """Histories first, then windows; within each the hardest."""
    with_fields = [(entry, run) for entry, run in runs if instants(run)]
    with_fields.sort(key=lambda pair: (pair[0].role == "window", -pair[1].summary.get("max_plastic_strain", 0.0)))
    histories = [pair for pair in with_fields if pair[0].role != "window"]
    windows = [pair for pair in with_fields if pair[0].role == "window"]
    return histories[:MOST - 1] + windows[:MOST - len(histories[:MOST - 1])]


def _picture(context, entry, run):
    files = [file for file, _ in instants(run)]
    return context.pictures.figure(f"rim-{entry.name}", "The most strained of the stored fields.", _draw, files[-LATEST:])


def _draw(files, path):
    """The last of the most strained fields."""
    rim_picture.draw(max((vtu.read(file) for file in reversed(files)), key=rim_picture.largest_strain), path)
    return path
