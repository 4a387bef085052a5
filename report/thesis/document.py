"""python3 -m report.thesis.document FILE: writes docs/thesis.md of the catalogue and its kept numbers."""
from ..errors import run_main
from ..files import write_whole
from ..numbers import sig
from . import catalogue as catalogues
from . import headlines, refitted
from .catalogue import Catalogue
from .results import Ours
from .words import counts, made_by, printed, span

CHAPTERS = (("2", "Chapter 2: SH-FPS"), ("3", "Chapter 3: LIR-DCFP"), ("4", "Chapter 4: reliability"), ("A", "Appendix A"), ("B", "Appendix B"), ("C", "Appendix C"))


def _opening(catalogue: Catalogue, ours: Ours) -> list[str]:
    t = catalogue.thesis
    return ["# The thesis, figure by figure",
            "<!-- Made by `python3 -m report.thesis.document`; a test holds it to data/thesis. -->",
            f"{t['author']}: *{t['title']}*. {t['kind']}, {t['university']}, {t['year']}.", "",
            "`rimpact thesis list` prints this page's tables, `rimpact thesis fig-2-24` makes one figure and `rimpact thesis all --cheap` all that take",
            "seconds. `--records DIR` names the folder of your own AT2 files. A figure runs what is missing by rimpact's own verbs, keeps what is done,",
            "draws finite elements and the reduced model over one another with the thesis's panels and axes, and sets the printed numbers beside ours.", "",
            f"**{counts(ours.count(catalogue.entries))}.**", "",
            "States: *done*, *partly*, *missing*, *drawing* (a scheme or photograph: nothing to compute). A number is met when it lies within the bound the",
            "catalogue (`data/thesis`) gives it; one that is not met, or not compared, says why. A cause is checked by a run that takes it away, whose number",
            "stands in the last column, or the cause is unknown.", "",
            "## The thesis's own results", "What its abstract and conclusions give as results, by `rimpact thesis headlines`.", "",
            *headlines.as_table(catalogue, ours), ""]


def _readings(catalogue: Catalogue) -> list[str]:
    """The readings that the thesis's items take, beside those of a user's own bearing."""
    lines = ["## Printed formulas and exact ones", "The items of chapters 3 and 4 take the thesis's formulas as printed; a bearing of your own takes the exact ones.", "",
             "| | printed | exact, the default | key |", "|---|---|---|---|"]
    lines += [f"| {reading['what']} | {reading['printed']} | {reading['exact']} | `{reading['key']}` |" for reading in catalogue.readings]
    lines += ["", "| section | both as printed | both exact | numbers |", "|---|---|---|---|"]
    return lines + [f"| {row['section']} | {row['printed']} met | {row['exact']} met | {row['numbers']} |" for row in catalogue.reading_counts] + [""]


def _chapter(catalogue: Catalogue, ours: Ours, chapter: str, title: str) -> list[str]:
    lines = [f"## {title}", "| | what | state | made by | numbers | differs |", "|---|---|---|---|---|---|"]
    for entry in catalogue.entries:
        if not entry.section.startswith(chapter):
            continue
        numbers = ", ".join(f"{n} {verdict}" for verdict, n in ours.count([entry]).items() if n)
        made = f"`{made_by(entry)}`" if made_by(entry) else ""
        lines.append(f"| {span(entry)} | {entry.title} | {entry.state} | {made} | {numbers} | {entry.differs} |")
    return [*lines, ""]


def _not_met(catalogue: Catalogue, ours: Ours) -> list[str]:
    lines = ["## Numbers that are not met", "| | what | thesis | ours | cause | ours without it |", "|---|---|---|---|---|---|"]
    for entry in catalogue.entries:
        for number in entry.numbers:
            if number.verdict(ours.of(entry, number)) == "not met":
                without = sig(ours.without_cause(entry, number), 3) if number.without else ""
                lines.append(f"| {entry.id} | {number.what} | {printed(number)} {number.unit} | {sig(ours.of(entry, number), 3)} | {number.cause} | {without} |")
    return [*lines, ""]


def _not_compared(catalogue: Catalogue, ours: Ours) -> list[str]:
    lines = ["## Numbers that prove little", "They are counted apart from those met.", "", "| | what | thesis | ours | why |", "|---|---|---|---|---|"]
    for entry in catalogue.entries:
        lines += [f"| {entry.id} | {n.what} | {printed(n)} {n.unit} | {sig(ours.of(entry, n), 3)} | {n.apart} |" for n in entry.numbers if n.apart]
    lines += ["", "## Numbers that are not comparable", "| | what | thesis | why |", "|---|---|---|---|"]
    for entry in catalogue.entries:
        lines += [f"| {entry.id} | {n.what} | {printed(n)} {n.unit} | {n.why} |" for n in entry.numbers if n.why]
    return lines


def text() -> str:
    catalogue, ours = catalogues.load(), Ours("/nonexistent")
    lines = _opening(catalogue, ours) + _readings(catalogue)
    for chapter, title in CHAPTERS:
        lines += _chapter(catalogue, ours, chapter, title)
    return "\n".join([*lines, *refitted.document(catalogue, ours), *_not_met(catalogue, ours), *_not_compared(catalogue, ours)]) + "\n"


def main(arguments: list[str]) -> None:
    write_whole(arguments[0], lambda file: file.write(text().encode()))


if __name__ == "__main__":
    run_main(main)
