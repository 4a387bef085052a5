"""The exported bearing in OpenSees and our reduced model under recorded motions: a table, and what its rows differ by.

usage: recorded_motions.py [--write]   with RIMPACT and PYTHONPATH (tests/app) set; --write: into recorded_motions.txt
The records are PEER's and stand in no repository: RIMPACT_RECORDS, or shared/records beside the project. Exit code 77 (skipped) without them."""
import json
import os
import pathlib
import re
import runpy
import sys
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import flights
from command import rimpact
from exported import identity
from exported_there import PythonFile
from opensees_rows import export, of_law
from stored_table import differ

TABLE = pathlib.Path(__file__).with_suffix(".txt")
RECORDS = pathlib.Path(os.environ.get("RIMPACT_RECORDS", pathlib.Path(__file__).parents[3] / "shared/records"))
GRAVITY, SKIPPED = 9.81, 77


@dataclass(frozen=True)
class Motion:
    """Records by direction, their scale and the length flown [s]."""
    name: str
    files: tuple[str, ...]  # along x, y, z; a word too few: no motion there
    scale: float
    duration: float


SYLMAR = ("RSN1086_NORTHR_SYL360", "RSN1086_NORTHR_SYL090", "RSN1086_NORTHR_SYL-UP")
NEWHALL = ("RSN1044_NORTHR_NWH360", "RSN1044_NORTHR_NWH090")
ARRAY_7 = ("RSN182_IMPVALL.H_H-E07230", "RSN182_IMPVALL.H_H-E07140", "RSN182_IMPVALL.H_H-E07-UP")
# Scales at which the slider stays short of its rim, or meets it no faster than the law's runs did.
MOTIONS = (
    Motion("Sylmar, x", SYLMAR[:1], 0.85, 12), Motion("Newhall, x", NEWHALL[:1], 1.0, 12), Motion("Newhall, x y", NEWHALL, 1.3, 12),
    Motion("Takarazuka, x", ("RSN1119_KOBE_TAZ000",), 1.3, 12), Motion("Sylmar, x y z", SYLMAR, 0.85, 12),
    Motion("Sylmar, x", SYLMAR[:1], 1.0, 12), Motion("Array 7, x", ARRAY_7[:1], 1.15, 12), Motion("Sylmar, x y z", SYLMAR, 1.0, 12), Motion("Array 7, x y", ARRAY_7[:2], 1.15, 12),
    Motion("Array 7, x y z", ARRAY_7, 1.15, 12),
)
# Largest travel and hardest push of the rim, theirs over ours: as exported, and with what differs made alike.
BOUNDS = {"as exported": {"travel": 0.02, "peak": 0.04}, "alike": {"travel": 0.006, "peak": 0.03}}
SLIP = 0.01  # of friction in both, where they are made alike [mm]
# The tolerance: nothing damps the swing on the pad's spring, and with 1e-6 it meets the rim of Array 7 x y z 7 % slower.
ALIKE = ("reduced.normal_force=pad", f"reduced.elastic_slip_mm={SLIP}", "reduced.tolerance=1e-10")


def acceleration(name: str) -> tuple[list[float], float]:
    """Of a PEER file [m/s^2], and its step [s]; read here, not by ours."""
    head, values = (RECORDS / f"{name}.AT2").read_text().split("DT=", 1)
    step = re.match(r"\s*([.0-9]+)", values)
    assert step and "UNITS OF G" in head, name
    return [GRAVITY * float(word) for line in values.splitlines()[1:] for word in line.split()], float(step.group(1))


@dataclass
class Side:
    """What one program has of a motion: largest travel, where it stays [mm]; touches of the rim, the hardest [kN], and the first's speed [m/s]."""
    travel: float
    stays: float
    hits: int
    peak: float
    touch: float


def there(file: PythonFile, motion: Motion) -> Side:
    ground, step = {}, 0.0
    for direction, name in enumerate(motion.files, 1):
        values, step = acceleration(name)
        ground[direction] = [motion.scale * value for value in values]
    flight = flights.fly(file, ground, step, motion.duration)
    return Side(1e3 * flight.furthest, 1e3 * flight.at_end, len(flight.hits), flight.peak / 1e3, flight.hits[0].approach if flight.hits else 0.0)


def ours(folder: str, motion: Motion, *settings: str) -> Side:
    scene, out = pathlib.Path(folder, "scene.toml"), pathlib.Path(folder, "model")
    ways = "".join(f'{way} = "{RECORDS / name}.AT2"\n' for way, name in zip("xyz", motion.files))
    scene.write_text(f'[bearing]\nname = "shfps-225"\n[excitation]\nkind = "record"\nscale = {motion.scale}\nduration_s = {motion.duration}\n{ways}')
    run = rimpact("reduced", str(scene), "--calibration", folder, "-o", str(out), "--quiet", "--force", *(word for setting in settings for word in ("--set", setting)))
    assert run.returncode == 0, run.stderr
    summary = json.loads((out / "summary.json").read_text())
    hits = summary["impacts"]
    return Side(1e3 * summary["peak_displacement_m"], 1e3 * summary["residual_displacement_m"], len(hits), (summary["peak_impact_force_N"] or 0) / 1e3,
                hits[0]["approach_speed_m_s"] if hits else 0.0)


@dataclass
class Row:
    """`how`: as exported; or alike, both with a slip of SLIP before friction slides, ours with the pad's spring, which the export has."""
    motion: Motion
    how: str
    there: Side
    ours: Side

    def over(self) -> dict[str, float]:
        """Theirs over ours, less one; the rim where both meet it."""
        found = {"travel": self.there.travel / self.ours.travel - 1}
        if self.there.hits and self.ours.hits:
            found["peak"] = self.there.peak / self.ours.peak - 1
        return found


HEAD = (f"{'motion':<14} scale {'both':<11}  travel_mm  ours  diff_%  touches ours  touch_m/s  ours   peak_kN   ours  diff_%  end_mm   ours")


def line(row: Row) -> str:
    a, b, over = row.there, row.ours, row.over()
    peak = f"{100 * over['peak']:+7.2f}" if "peak" in over else "      -"
    return (f"{row.motion.name:<14} {row.motion.scale:5.2f} {row.how:<11}  {a.travel:9.1f} {b.travel:5.1f} {100 * over['travel']:+7.2f}  {a.hits:7d} {b.hits:4d}"
            f"  {a.touch:9.3f} {b.touch:5.3f}  {a.peak:8.1f} {b.peak:6.1f} {peak}  {a.stays:6.1f} {b.stays:6.1f}")


def with_slip(file: pathlib.Path, slip: float) -> PythonFile:
    """The exported file, its friction built up over another slip [m]: its stiffness is a number of its head."""
    numbers, text = runpy.run_path(str(file)), file.read_text()
    own = numbers["mu_fast"] * numbers["dead_load"] / slip
    text, found = re.subn(r"^friction_stiffness = \S+", f"friction_stiffness = {own:.9g}", text, flags=re.MULTILINE)
    assert found == 1, file
    other = file.with_name("impact_slip.py")
    other.write_text(text)
    return PythonFile(other)


def made() -> Iterator[Row]:
    with tempfile.TemporaryDirectory() as folder:
        export(folder, of_law("elastoplastic", identity()))
        exported = pathlib.Path(folder, "impact.py")
        for how, file, settings in (("as exported", PythonFile(exported), ()),
                                    ("alike", with_slip(exported, SLIP / 1e3), ALIKE)):
            for motion in MOTIONS:
                yield Row(motion, how, there(file, motion), ours(folder, motion, *settings))


def missed(rows: Iterable[Row]) -> list[str]:
    """Rows beyond their bounds, or with another number of touches."""
    found = [f"{row.motion.name} x {row.motion.scale}, {row.how}: {row.there.hits} touches against {row.ours.hits}" for row in rows if row.there.hits != row.ours.hits]
    return found + [f"{row.motion.name} x {row.motion.scale}, {row.how}: {what} differs by {100 * value:.1f} %, more than {100 * BOUNDS[row.how][what]:.1f} %"
                    for row in rows for what, value in row.over().items() if abs(value) > BOUNDS[row.how][what]]


def main(*options: str) -> int:
    absent = sorted({name for motion in MOTIONS for name in motion.files if not (RECORDS / f"{name}.AT2").is_file()})
    if absent:
        print(f"skipped: {RECORDS} has no {absent[0]}.AT2 (set RIMPACT_RECORDS)")
        return SKIPPED
    rows = []
    for row in made():
        rows.append(row)
        print(line(row), flush=True)
    text = "\n".join([HEAD, *map(line, rows)]) + "\n"
    faults = missed(rows)
    if "--write" in options:
        TABLE.write_text(text)
    else:
        faults += [f"stored: {old}\nnow:    {new}" for old, new in zip(TABLE.read_text().splitlines(), text.splitlines()) if differ(new, old, 0.01, 0.5)]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
