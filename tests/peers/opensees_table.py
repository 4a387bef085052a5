"""What OpenSees has of every exported file beside the export's own check, the reduced model and kept finite elements: two tables.

usage: opensees_table.py [--write]   with RIMPACT and PYTHONPATH (tests/app) set; --write: into opensees_table.txt
Without it the tables are held against the stored ones, and against what the files' heads say of OpenSees (--json, flown_there)."""
import pathlib
import sys
import tempfile
from collections.abc import Iterable

from exported import identity
from exported_there import PythonFile
from opensees_rows import LAWS, Motion, Spring, export, near_fault, of_law, pulses, springs, windows
from stored_table import differ

TABLE = pathlib.Path(__file__).with_suffix(".txt")
SPEEDS = ("0.10", "0.20", "0.35", "0.50", "0.70")


def percent(value: float | None) -> str:
    return "       -" if value is None else f"{100 * value:+8.2f}"


def spring_line(row: Spring) -> str:
    hit, own, law = row.there, row.over(row.own), row.over(row.of_law)
    return (f"{row.law:<14} {row.speed:5.3f} {row.hit:3d} {hit.peak / 1e3:8.1f} {1e3 * hit.depth:8.3f} {hit.ratio:7.4f} {hit.taken / 1e3:8.4f}"
            f" {percent(own[0])} {percent(own[1])} {percent(own[2])} {percent(law[0])} {percent(law[1])} {percent(law[2])}")


def motion_line(row: Motion) -> str:
    sides = [row.over(side) for side in ("own", "model", "fe")]
    shown = (sides[0][:2], sides[1], sides[2][:3])
    return f"{row.name:<52} {row.there.approach:6.3f} {row.there.peak / 1e3:7.1f} {row.there.ratio:6.3f} {row.there.taken / 1e3:7.3f}" + "".join(
        " " + percent(value) for side in shown for value in side)


SPRINGS = ("law              m/s hit  peak_kN depth_mm rebound work_kJ   over the export's own check   over the law\n"
           f"{'':<58}" + "   peak_%  depth_% rebound_%   peak_%  depth_% rebound_%")
MOTIONS = (f"{'motion':<52}    m/s peak_kN rebound work_kJ  over own check    over the reduced model               over finite elements\n"
           f"{'':<81}  touch_%   peak_%  touch_%   peak_% rebound_%  work_%  touch_%   peak_% rebound_%")


def made() -> tuple[list[Spring], list[Motion], dict[str, float]]:
    rim = identity()
    flown: list[Spring] = []
    for law in LAWS:
        with tempfile.TemporaryDirectory() as folder:
            flown += springs(law, folder, export(folder, of_law(law, rim)))
    with tempfile.TemporaryDirectory() as folder:
        table = export(folder, of_law("elastoplastic", rim))
        file = PythonFile(pathlib.Path(folder, "impact.py"))
        motions = [*windows(folder, file, SPEEDS), *pulses(folder, file, table), near_fault(folder, file)]
    return flown, motions, dict(table["self_checks"][0]["flown_there"])


def missed(flown: Iterable[Spring], motions: Iterable[Motion], said: dict[str, float]) -> list[str]:
    """Rows beyond what a head says of them."""
    found = [f"{row.law} {row.speed:.3f} m/s: off its own check by more than {said['springs']}" for row in flown
             if max(abs(value) for value in row.over(row.own)) > said["springs"]]
    for row in motions:
        for side, bound in (("own", said["bearing"]), ("model", said["model"]), ("fe", said["solids"])):
            worst = max((abs(value) for value in row.over(side)[:2] if value is not None), default=0)
            if worst > bound:
                found.append(f"{row.name}: {side} differs by {100 * worst:.1f} %, more than {100 * bound:.1f} %")
    return found


def main(*options: str) -> int:
    flown, motions, said = made()
    lines = [SPRINGS, *map(spring_line, flown), "", MOTIONS, *map(motion_line, motions)]
    text = "\n".join(lines) + "\n"
    print(text)
    faults = missed(flown, motions, said)
    if "--write" in options:
        TABLE.write_text(text)
    else:
        stored = TABLE.read_text().splitlines()
        now = text.splitlines()
        faults += [f"stored: {old}\nnow:    {new}" for old, new in zip(stored, now) if differ(new, old, 0.01, 0.5)]
        faults += ["the table has another number of lines than the stored one"] if len(stored) != len(now) else []
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
