"""What the stored fields hold: names, units, ranges, instants; and how to see them in ParaView."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from .. import paraview, vtu
from ..blocks import Section, table, text
from ..errors import DataError
from ..field_catalogue import info_of
from ..numbers import sig
from ..run_folder import Run
from ..stored_fields import absent, instants, said_of
from .common import title_of

if TYPE_CHECKING:
    from ..context import Context


def make(context: Context) -> Section | None:
    runs = [(entry, entry.fe, instants(entry.fe)) for entry in context.results.entries if entry.fe is not None]
    for entry, run, _ in runs:
        if lost := absent(run):
            context.problems.append(f"fields of {entry.name}: {len(lost)} that fields.pvd lists are not there, {os.path.basename(lost[0])} the first")
    stored = [(entry, run, files) for entry, run, files in runs if files]
    section = Section("fields", "Stored fields")
    scripts = 0
    for entry, run, files in stored:
        try:
            grid = vtu.read(files[-1][0])
        except DataError as error:
            context.problems.append(f"fields of {entry.name}: {error}")
            continue
        scripts += paraview.write(run.folder, grid) is not None
        if not section.blocks:
            section.add(_table(grid, run, files, "" if context.results.single else f"{title_of(entry.name)}: "))
    if not section.blocks:
        return None
    n, instants_of = len(stored), sum(len(files) for *_, files in stored)
    section.lead = f"`fields/*.vtu`, listed with their times in `fields.pvd`: {instants_of} instants of {n} run{'s' if n > 1 else ''}."
    if scripts:
        section.add(text(f"`paraview --script={paraview.NAME}` in a run's folder shows the deformed bearing coloured by stress."))
    return section


def _table(grid: vtu.Grid, run: Run, files: list[tuple[str, float | None]], name: str) -> dict | None:
    rows = []
    for field, values in grid.point_data.items():
        known, size = info_of(field), np.linalg.norm(values, axis=1) if values.ndim > 1 else values
        rows.append([f"`{field}`", known.unit, sig(float(size.min()), 3), sig(float(size.max()), 3), known.meaning])
    return table(["field", "unit", "least", "largest", "meaning"], rows, left=(0, 1, 4), prose=True,
                 caption=f"{name}{len(grid.hexahedra)} cells of {grid.hexahedra.shape[1]} nodes, {said_of(run, files[-1][1])}. Of a vector the length.")
