"""The energy ledger: an e is only worth reporting beside what became of the energy."""
import math
from typing import Any

from ..blocks import Section, table
from ..context import Context
from ..figures import energy as figure_energy
from ..numbers import fixed, is_number, percent
from ..results import Entry
from ..run_folder import Run
from .common import row_name, short_name

TERMS = ("external", "gravity", "kinetic", "elastic", "plastic", "damping", "friction", "impact", "contact", "integrator")


def make(context: Context) -> Section | None:
    section = Section("energy", "Energy ledger")
    section.lead = ("Energies in kJ: what was put in, what is stored and what is spent by the end of the run. The "
                    "integrator's loss comes from its own formula; the imbalance is what is left over, relative to the "
                    "largest energy input.")
    runs = [(entry, run) for entry in context.results.entries for run in [entry.fe or entry.fitted] if run is not None]
    rows = [_row(context, entry, run) for entry, run in runs if run.summary.get("energy")]
    if not rows:
        return None
    unused = [i for i in range(2, 2 + len(TERMS) + 1) if all(row[i] in ("–", "0") for row in rows)]
    header = ["run", "model", "at start", *TERMS, "imbalance"]
    section.add(table([h for i, h in enumerate(header) if i not in unused],
                      [[c for i, c in enumerate(row) if i not in unused] for row in rows], left=2))
    drawn = [(short_name(entry.name), run) for entry, run in runs if entry.role != "window" or context.results.single]
    section.add(context.pictures.figure("energy", "Where the energy is, over time: spent below, stored above.",
                                        figure_energy.draw, drawn))
    return section


def _row(context: Context, entry: Entry, run: Run) -> list[Any]:
    ledger = run.summary["energy"]
    values = [ledger.get(f"{name}_J") for name in ("initial", *TERMS)]
    largest = max((abs(value) for value in values if is_number(value)), default=0.0)
    values = [_kilojoule(value, largest) for value in values]
    imbalance = ledger.get("imbalance_relative")
    return [row_name(context, entry), "reduced" if run.rung == "reduced" else "FE", *values,
            percent(imbalance, 3)]


def _kilojoule(value: float | None, largest: float) -> str:
    """The row's largest energy gets four digits, the others as many decimals."""
    if not is_number(value) or largest <= 0:
        return "–"
    return "0" if value == 0 else fixed(1e-3 * value, max(0, 3 - math.floor(math.log10(1e-3 * largest))))
