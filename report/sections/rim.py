"""The deformed rim, coloured by plastic strain: a picture the FE run left, or one drawn from its last VTU file."""
import os

from .. import rim_picture, vtu
from ..blocks import Section, heading, note
from .common import field_files, title_of

READY = ("fields/deformed.png", "rim.png", "fields/rim.png", "deformed.png")
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
            section.add(None if context.results.single else heading(title_of(entry.name)))
            section.add(picture)
    if not section.blocks:
        section.add(note("No finite-element run left fields (fields/*.vtu) or a picture of the rim.", "missing"))
    return section


def _meets_the_rim(run):
    return run is not None and run.rung != "reduced" and (run.rung == "rim" or bool(run.impacts))


def _most_strained(runs):
    """Histories first, then windows; within each the hardest."""
    with_fields = [(entry, run) for entry, run in runs if _ready(run) or field_files(run)]
    with_fields.sort(key=lambda pair: (pair[0].role == "window", -(pair[1].summary.get("max_plastic_strain") or 0.0)))
    histories = [pair for pair in with_fields if pair[0].role != "window"]
    windows = [pair for pair in with_fields if pair[0].role == "window"]
    return histories[:MOST - 1] + windows[:MOST - len(histories[:MOST - 1])]


def _ready(run):
    return next((path for path in (os.path.join(run.folder, name) for name in READY) if os.path.isfile(path)), None)


def _picture(context, entry, run):
    files = field_files(run)
    if not files:
        return context.pictures.existing(_ready(run), "As the finite-element run left it.")
    return context.pictures.figure(f"rim-{entry.name}", "The most strained of the stored fields.", _draw, files[-LATEST:])


def _draw(files, path):
    """The last of the most strained fields; drawn again only when a field is newer than the picture."""
    if not os.path.isfile(path) or os.path.getmtime(path) < max(map(os.path.getmtime, files)):
        rim_picture.draw(max((vtu.read(file) for file in reversed(files)), key=rim_picture.largest_strain), path)
    return path
