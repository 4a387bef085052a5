"""Makes entries: their runs, their picture, their numbers, one page of all that were asked for."""
import argparse
import os
from collections.abc import Callable
from typing import Any

from .. import page
from ..blocks import Pictures, Section, note, text
from . import draw, tables
from .catalogue import Catalogue, Entry
from .results import Ours
from .runs import Runs, value_of, value_without_cause
from .words import counts


def make(catalogue: Catalogue, ours: Ours, entries: list[Entry], options: argparse.Namespace) -> dict[str, Any]:
    """Prints each entry's numbers and the page's path; gives the same as JSON."""
    runs = Runs(catalogue, options.program, options.output, options.records, options.cheap, options.quiet, options.jobs, options.calibration)
    runs.make_all([name for entry in entries for name in entry.runs(causes=not ours.refitted)])
    pictures, made, sections = Pictures(os.path.join(options.output, "figures"), []), [], []
    pictures.begin()
    told: set[str] = set()  # a run that is missing is said at the first entry that needs it
    for entry in entries:
        if not entry.panels and not entry.numbers:
            if len(entries) == 1:
                sections.append(_section(entry, ours, None, []))
            continue
        figure = pictures.figure(entry.id, f"As the thesis lays it out: {entry.title}", _draw(entry, runs)) if entry.panels else None
        ours.put(entry, [value_of(number, runs) for number in entry.numbers], [] if ours.refitted else [value_without_cause(number, runs) for number in entry.numbers])
        missing = [runs.missing[name] for name in entry.runs() if name in runs.missing]
        sections.append(_section(entry, ours, figure, missing))
        made.append({"id": entry.id, "numbers": tables.numbers_json(entry, ours), "missing": missing,
                     "picture": pictures.path(entry.id) if figure else None})
        if not options.json:
            _say(entry, ours, pictures.path(entry.id) if figure else None, [sentence for sentence in missing if sentence not in told])
        told.update(missing)
    pictures.finish()
    name = "thesis" if len(entries) > 1 else entries[0].id
    path = os.path.join(options.output, f"{name}.html")
    os.makedirs(options.output, exist_ok=True)
    page.write(path, "page.html.j2", title="The thesis and ours" if len(entries) > 1 else f"{entries[0].id}: {entries[0].title}", subtitle=catalogue.citation,
               sections=sections, problems=pictures.problems, footer=_counts(entries, ours))
    if not options.json:
        print(_counts(entries, ours))
        print(path)
    return {"entries": made, "counts": {**ours.count(entries), "kept": ours.n_kept(entries)}, "page": path}


def _counts(entries: list[Entry], ours: Ours) -> str:
    n_kept = ours.n_kept(entries)
    return counts(ours.count(entries)) + (f"; {n_kept} of ours are kept with the program, nothing here made them" if n_kept else "")


def _draw(entry: Entry, runs: Runs) -> Callable[[str], str | None]:
    return lambda path: draw.draw(entry, runs, path)


def _section(entry: Entry, ours: Ours, figure: dict[str, Any] | None, missing: list[str]) -> Section:
    section = Section(entry.id, f"{entry.id}: {entry.title}", lead=f"Section {entry.section}. State: {entry.state}.")
    section.add(figure)
    section.add(text(entry.differs) if entry.differs else None)
    section.add(text(f"Made by `{entry.command}`.") if entry.command else None)
    section.add(tables.numbers_block(entry, ours))
    for sentence in missing:
        section.add(note(sentence, "missing"))
    return section


def _say(entry: Entry, ours: Ours, picture: str | None, missing: list[str]) -> None:
    print(f"{entry.id}: {entry.title}")
    if entry.numbers:
        print(tables.numbers_text(entry, ours))
    for sentence in missing:
        print(f"  missing: {sentence}")
    if picture:
        print(f"  {picture}")
