"""The energy ledger: an e is only worth reporting beside what became of the energy."""
from ..blocks import Section, heading, note, table
from ..figures import energy as figure_energy
from ..numbers import integer, is_number, percent, sig
from .common import title_of

TERMS = ("external", "gravity", "kinetic", "elastic", "plastic", "friction", "impact", "contact", "integrator")


def make(context):
    section = Section("energy", "Energy ledger")
    section.lead = ("Energies in kJ: what was put in, what is stored and what is spent by the end of the run. The "
                    "integrator's loss comes from its own formula; the imbalance is what is left over, relative to the "
                    "largest energy input.")
    runs = [(entry, run) for entry in context.results.entries for run in [entry.fe or entry.fitted] if run is not None]
    rows = [_row(entry, run) for entry, run in runs if isinstance(run.summary.get("energy"), dict)]
    if not rows:
        section.add(note("No run tells its energies.", "missing"))
        return section
    unused = [i for i in range(2, 2 + len(TERMS) + 1) if all(row[i] in ("–", "0") for row in rows)]
    header = ["run", "model", "at start", *TERMS, "imbalance"]
    section.add(table([h for i, h in enumerate(header) if i not in unused],
                      [[c for i, c in enumerate(row) if i not in unused] for row in rows], left=2))
    for entry, run in runs:
        if entry.role == "window" and not context.results.single:
            continue
        picture = context.pictures.figure(f"energy-{entry.name}", "", figure_energy.draw, run)
        if picture:
            section.add(None if context.results.single else heading(title_of(entry.name)))
            section.add(picture)
    return section


def _row(entry, run):
    ledger = run.summary["energy"]
    values = [_kilojoule(ledger.get(f"{name}_J")) for name in ("initial", *TERMS)]
    imbalance = ledger.get("imbalance_relative")
    return [title_of(entry.name), "reduced" if run.rung == "reduced" else "FE", *values,
            sig(imbalance, 2) if is_number(imbalance) and abs(imbalance) < 1e-3 else percent(imbalance, 2)]


def _kilojoule(value):
    if not is_number(value):
        return "–"
    return "0" if value == 0 else integer(1e-3 * value) if abs(value) >= 1e6 else sig(1e-3 * value, 3)
