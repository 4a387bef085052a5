"""Versions, machine, totals and the resolved scenes: what is needed to get the same numbers again."""
from typing import Any

from ..blocks import Section, details, table
from ..context import Context
from ..numbers import duration, is_number, memory, plain
from .common import title_of


def make(context: Context) -> Section:
    section = Section("reproducibility", "Versions and reproducibility")
    main = context.results.main
    versions = main.get("versions")
    section.add(table(["total", ""], _totals(main), left=2, compact=True))
    section.add(table(["component", "version"], _pairs(versions), left=2, compact=True))
    if not versions:
        section.add(table(["stored with the run", ""], _meta(context), left=2, compact=True))
    for entry in context.results.entries:
        run = entry.any_run
        if run is not None and run.scene_text:
            section.add(details(f"Resolved scene: {title_of(entry.name)}", run.scene_text))
    return section


def _totals(main: dict[str, Any]) -> list[list[str]]:
    totals = main.get("totals", {})
    rows = [[label, show(totals[name])] for label, name, show in (("wall time", "wall_time_s", duration), ("peak memory", "peak_memory_bytes", memory))
            if is_number(totals.get(name))]
    return rows + [[name.replace("_", " "), value] for name, value in _pairs(main.get("machine"))]


def _pairs(tree: dict[str, Any] | None) -> list[list[str]]:
    return [[name, plain(value)] for name, value in (tree or {}).items()]


def _meta(context: Context) -> list[list[str]]:
    run = context.results.reference or (context.results.entries[0].any_run if context.results.entries else None)
    return [[key, value] for key, value in run.meta.items() if "\n" not in value and len(value) < 120] if run else []
