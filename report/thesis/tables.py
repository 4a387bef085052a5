"""What the catalogue says as text, as JSON and as blocks of a page."""
from typing import Any

from ..blocks import table
from ..numbers import sig
from . import headlines
from .catalogue import Catalogue, Entry
from .results import Ours
from .words import counts, made_by, number_json, printed, span


def list_text(catalogue: Catalogue, ours: Ours) -> str:
    lines = [catalogue.citation, ""]
    for entry in catalogue.entries:
        numbers = ours.count([entry])
        told = ", ".join(f"{n} {verdict}" for verdict, n in numbers.items() if n)
        records = catalogue.records_of(entry)
        lines.append(f"{span(entry):24} {entry.state:8} {_cost(catalogue, entry):>9}  {entry.title}" + (f" [{told}]" if told else "")
                     + (f" (records: {', '.join(records[:3])}{' ...' if len(records) > 3 else ''})" if records else ""))
        if entry.command:
            lines.append(f"{'':44}{entry.command}")
    return "\n".join([*lines, "", counts(ours.count(catalogue.entries))])


def _cost(catalogue: Catalogue, entry: Entry) -> str:
    if not entry.panels and not entry.numbers:
        return ""
    cheap, all_of_it = catalogue.seconds_of(entry), catalogue.seconds_of(entry, cheap=False)
    of = lambda s: f"{s / 3600:.0f} h" if s >= 5400 else f"{s / 60:.0f} min" if s >= 90 else f"{max(s, 1):.0f} s"
    return of(cheap) if cheap == all_of_it else f"{of(cheap)}+{of(all_of_it - cheap)}"


def list_json(catalogue: Catalogue, ours: Ours) -> dict[str, Any]:
    entries = [{"id": entry.id, "also": entry.also, "section": entry.section, "title": entry.title, "state": entry.state, "differs": entry.differs,
                "command": made_by(entry) or f"rimpact thesis {entry.id}", "seconds": catalogue.seconds_of(entry),
                "seconds_heavy": catalogue.seconds_of(entry, cheap=False) - catalogue.seconds_of(entry),
                "records": catalogue.records_of(entry), "numbers": numbers_json(entry, ours)} for entry in catalogue.entries]
    return {"thesis": catalogue.thesis, "counts": ours.count(catalogue.entries), "headlines": headlines.as_json(catalogue, ours), "entries": entries}


def numbers_json(entry: Entry, ours: Ours) -> list[dict[str, Any]]:
    return [number_json(number, entry, ours) for number in entry.numbers]


def numbers_text(entry: Entry, ours: Ours) -> str:
    lines = []
    for row in numbers_json(entry, ours):
        number = next(n for n in entry.numbers if n.what == row["what"])
        assumed = f"  assumed rims {sig(row['assumed_rims'], 4):>8}" if ours.refitted else ""
        lines.append(f"  {row['what']:52} thesis {printed(number):>8}{assumed}  ours {sig(row['ours'], 4):>8} {row['unit']:5} {row['verdict']}"
                     + (f": {row['word']}" if row["word"] else ""))
    return "\n".join(lines)


def numbers_block(entry: Entry, ours: Ours) -> dict[str, Any] | None:
    rows = []
    for number in entry.numbers:
        row = number_json(number, entry, ours)
        assumed = [sig(row["assumed_rims"], 4)] if ours.refitted else []
        rows.append([number.what, number.unit, printed(number), *assumed, sig(row["ours"], 4), row["verdict"], row["word"]])
    if ours.refitted:
        return table(["", "unit", "thesis", "assumed rims", "this law", "", ""], rows, left=(0, 1, 5, 6), prose=True)
    return table(["", "unit", "thesis", "ours", "", ""], rows, left=(0, 1, 4, 5), prose=True)
