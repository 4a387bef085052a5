"""What chapters 3 and 4 become where the bearings of two dishes have rims that finite elements found (data/thesis/refitted.json)."""
import os
from statistics import median
from typing import Any, NamedTuple

from ..data_files import read_any_json
from ..numbers import sig
from .catalogue import FOLDER, Catalogue, Entry, Number
from .results import Ours
from .words import printed

KEPT = os.path.join(FOLDER, "thesis", "refitted.json")
NOTABLE = 0.05  #: a change that the page shows, of the number with the assumed rims
SECTIONS = ("3.4", "3.5", "4.3")  #: whose bearings are of the size of dcfp-155; the specimen of appendix B is not


class Row(NamedTuple):
    entry: Entry
    number: Number
    assumed: float  #: with the rims that the thesis has or we assumed
    found: float    #: with those of finite elements

    @property
    def change(self) -> float:
        return self.found / self.assumed - 1


def _compared(catalogue: Catalogue, assumed: Ours, numbers: dict[str, Any]) -> list[Row]:
    """Every number that both have."""
    rows = []
    for entry in filter(lambda entry: entry.section.startswith(SECTIONS), catalogue.entries):
        for number in entry.numbers:
            with_law, before = numbers.get(entry.id, {}).get(number.what), assumed.of(entry, number)
            if with_law is not None and before and not number.why:
                rows.append(Row(entry, number, before, with_law))
    return rows


def _count(rows: list[Row]) -> int:
    return sum(row.number.count for row in rows)


def document(catalogue: Catalogue, assumed: Ours) -> list[str]:
    """Lines of docs/thesis.md; none where nothing is kept."""
    if not os.path.isfile(KEPT):
        return []
    kept = read_any_json(KEPT)
    rows = _compared(catalogue, assumed, kept["numbers"])
    notable = [row for row in rows if abs(row.change) > NOTABLE]
    met = [_count([row for row in rows if row.number.verdict(value(row)) == "met"]) for value in (lambda row: row.assumed, lambda row: row.found)]
    lines = ["## With rims that finite elements found",
             "The stiffness of a rim in chapter 3, 40,000 kN/m, which we take for chapter 4 too, was calibrated by nobody. Here the bearings of two dishes have the law that finite "
             f"elements give their rims instead: {kept['law']}. `rimpact main` makes it, `rimpact thesis all --calibration DIR` these numbers.",
             "The rims' dimensions and steel are ours, assumed: 20 mm high, 20 mm thick, where 3.5 needs 60 mm of height. The plates are near those of the thesis, not the same: "
             "R is 1.55 to 1.66 m in 3.4 and 1.18 m in 4.3, the sliders of 3.4 are 102 to 310 mm high, and C is 250 mm for a part of 4.3.",
             f"{kept['beyond_fit']} of {kept['runs']} runs have a hit outside the speeds that the law was fitted to. The table says what steel rims change, not what these bearings do.",
             "",
             f"Of {_count(rows)} numbers of sections {', '.join(SECTIONS)}, {_count(notable)} change by more than {100 * NOTABLE:g} %; "
             f"the median change is {100 * median(abs(row.change) for row in rows):.2g} %. {met[0]} are met with the assumed rims, {met[1]} with these.", "",
             "| | what | thesis | assumed rims | found rims | change |", "|---|---|---|---|---|---|"]
    for row in notable:
        change = f"{row.found - row.assumed:+.0f} points" if row.number.unit == "%" else f"{100 * row.change:+.0f} %"
        thesis = f"{printed(row.number)} {row.number.unit}".strip()
        lines.append(f"| {row.entry.id} | {row.number.what} | {thesis} | {sig(row.assumed, 3)} | {sig(row.found, 3)} | {change} |")
    return [*lines, ""]
