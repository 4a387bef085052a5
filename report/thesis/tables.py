"""What the catalogue says as text, as JSON, as blocks of a page and as docs/thesis.md."""
from typing import Any

from ..blocks import table
from ..numbers import sig
from .catalogue import Catalogue, Entry, Number
from .results import Ours

WORDS = {"done": "done", "partly": "partly", "missing": "missing", "drawing": "a drawing"}


def printed(number: Number) -> str:
    return f"≥ {sig(number.at_least)}" if number.printed is None and number.at_least is not None else sig(number.printed, 4)


def counts(total: dict[str, int]) -> str:
    compared = total["met"] + total["not met"]
    return (f"{compared} numbers compared: {total['met']} met, {total['not met']} not met with their cause; "
            f"{total['not comparable']} not comparable, with a sentence why; {total['not run']} not run yet")


def word(number: Number, verdict: str) -> str:
    return {"not met": number.cause, "not comparable": number.why}.get(verdict, "")


def list_text(catalogue: Catalogue, ours: Ours) -> str:
    lines = [catalogue.citation, ""]
    for entry in catalogue.entries:
        numbers = ours.count([entry])
        told = ", ".join(f"{n} {verdict}" for verdict, n in numbers.items() if n)
        records = catalogue.records_of(entry)
        lines.append(f"{_span(entry):24} {entry.state:8} {_cost(catalogue, entry):>9}  {entry.title}" + (f" [{told}]" if told else "")
                     + (f" (records: {', '.join(records[:3])}{' ...' if len(records) > 3 else ''})" if records else ""))
        if entry.command:
            lines.append(f"{'':44}{entry.command}")
    return "\n".join([*lines, "", counts(ours.count(catalogue.entries))])


def _span(entry: Entry) -> str:
    return entry.id if not entry.also else f"{entry.id} to {entry.also[-1]}" if len(entry.also) > 2 else ", ".join(entry.ids)


def _cost(catalogue: Catalogue, entry: Entry) -> str:
    if not entry.panels and not entry.numbers:
        return ""
    cheap, all_of_it = catalogue.seconds_of(entry), catalogue.seconds_of(entry, cheap=False)
    of = lambda s: f"{s / 3600:.0f} h" if s >= 5400 else f"{s / 60:.0f} min" if s >= 90 else f"{max(s, 1):.0f} s"
    return of(cheap) if cheap == all_of_it else f"{of(cheap)}+{of(all_of_it - cheap)}"


def list_json(catalogue: Catalogue, ours: Ours) -> dict[str, Any]:
    entries = [{"id": entry.id, "also": entry.also, "section": entry.section, "title": entry.title, "state": entry.state, "differs": entry.differs,
                "command": entry.command or f"rimpact thesis {entry.id}", "seconds": catalogue.seconds_of(entry),
                "seconds_heavy": catalogue.seconds_of(entry, cheap=False) - catalogue.seconds_of(entry),
                "records": catalogue.records_of(entry), "numbers": numbers_json(entry, ours)} for entry in catalogue.entries]
    return {"thesis": catalogue.thesis, "counts": ours.count(catalogue.entries), "entries": entries}


def numbers_json(entry: Entry, ours: Ours) -> list[dict[str, Any]]:
    return [{"what": n.what, "printed": n.printed, "at_least": n.at_least, "unit": n.unit, "within": n.within, "resolved": n.resolved, "ours": ours.of(entry, n),
             "verdict": n.verdict(ours.of(entry, n)), "word": word(n, n.verdict(ours.of(entry, n)))} for n in entry.numbers]


def numbers_text(entry: Entry, ours: Ours) -> str:
    lines = []
    for row in numbers_json(entry, ours):
        number = next(n for n in entry.numbers if n.what == row["what"])
        lines.append(f"  {row['what']:52} thesis {printed(number):>8}  ours {sig(row['ours'], 4):>8} {row['unit']:5} {row['verdict']}"
                     + (f": {row['word']}" if row["word"] else ""))
    return "\n".join(lines)


def numbers_block(entry: Entry, ours: Ours) -> dict[str, Any] | None:
    rows = []
    for number in entry.numbers:
        verdict = number.verdict(ours.of(entry, number))
        rows.append([number.what, number.unit, printed(number), sig(ours.of(entry, number), 4), verdict, word(number, verdict)])
    return table(["", "unit", "thesis", "ours", "", ""], rows, left=(0, 1, 4, 5), prose=True)


def document(catalogue: Catalogue, ours: Ours) -> str:
    """docs/thesis.md."""
    total = ours.count(catalogue.entries)
    t = catalogue.thesis
    lines = ["# The thesis, figure by figure",
             "<!-- Made by `python3 -m report.thesis.document`; a test holds it to data/thesis. -->",
             f"{t['author']}: *{t['title']}*. {t['kind']}, {t['university']}, {t['year']}.", "",
             "`rimpact thesis list` prints this page's tables, `rimpact thesis fig-2-24` makes one figure and `rimpact thesis all --cheap` all that take",
             "seconds. `--records DIR` names the folder of your own AT2 files. A figure runs what is missing by rimpact's own verbs, keeps what is done,",
             "draws finite elements and the reduced model over one another with the thesis's panels and axes, and sets the printed numbers beside ours.", "",
             f"**{counts(total)}.**", "",
             "States: *done*, *partly*, *missing*, *drawing* (a scheme or photograph: nothing to compute). A number is met when it lies within the bound the",
             "catalogue (`data/thesis`) gives it; one that is not met, or not compared, says why.", ""]
    for chapter, title in (("2", "Chapter 2: SH-FPS"), ("3", "Chapter 3: LIR-DCFP"), ("4", "Chapter 4: reliability"), ("A", "Appendix A"), ("B", "Appendix B"), ("C", "Appendix C")):
        entries = [entry for entry in catalogue.entries if entry.section.startswith(chapter)]
        lines += [f"## {title}", "| | what | state | made by | numbers | differs |", "|---|---|---|---|---|---|"]
        for entry in entries:
            numbers = ", ".join(f"{n} {verdict}" for verdict, n in ours.count([entry]).items() if n)
            made = f"`{entry.command}`" if entry.command else f"`rimpact thesis {entry.id}`" if entry.panels or entry.numbers else ""
            lines.append(f"| {_span(entry)} | {entry.title} | {entry.state} | {made} | {numbers} | {entry.differs} |")
        lines.append("")
    lines += ["## Numbers that are not met", "| | what | thesis | ours | cause |", "|---|---|---|---|---|"]
    for entry in catalogue.entries:
        for number in entry.numbers:
            if number.verdict(ours.of(entry, number)) == "not met":
                lines.append(f"| {entry.id} | {number.what} | {printed(number)} {number.unit} | {sig(ours.of(entry, number), 3)} | {number.cause} |")
    lines += ["", "## Numbers that are not comparable", "| | what | thesis | why |", "|---|---|---|---|"]
    for entry in catalogue.entries:
        lines += [f"| {entry.id} | {n.what} | {printed(n)} {n.unit} | {n.why} |" for n in entry.numbers if n.why]
    return "\n".join(lines) + "\n"
