"""Versions, machine, totals and the resolved scenes: what is needed to get the same numbers again."""
from ..blocks import Section, details, note, table
from ..numbers import duration, is_number, memory, plain
from .common import title_of


def make(context):
    section = Section("reproducibility", "Versions and reproducibility")
    main = context.results.main
    totals = main.get("totals") if isinstance(main.get("totals"), dict) else main
    versions = totals.get("versions") or main.get("versions")
    section.add(table(["total", ""], _totals(totals, main), left=2, compact=True))
    section.add(table(["component", "version"], _pairs(versions), left=2, compact=True))
    if not versions:
        section.add(table(["stored with the run", ""], _meta(context), left=2, compact=True))
    scenes = 0
    for entry in context.results.entries:
        run = entry.any_run
        if run is not None and run.scene_text:
            section.add(details(f"Resolved scene: {title_of(entry.name)}", run.scene_text))
            scenes += 1
    if not scenes:
        section.add(note("No resolved scene is stored.", "missing"))
    return section


def _totals(totals, main):
    rows = []
    for label, names, show in (("wall time", ("wall_time_s", "wall_s", "wall"), duration),
                               ("peak memory", ("peak_memory_bytes", "memory_bytes", "memory"), memory)):
        value = next((totals[name] for name in names if is_number(totals.get(name))), None)
        if value is not None:
            rows.append([label, show(value)])
    machine = totals.get("machine") or main.get("machine")
    for name, value in _pairs(machine) if isinstance(machine, dict) else ([["machine", machine]] if machine else []):
        rows.append([name.replace("_", " "), value])
    return rows


def _pairs(tree):
    if isinstance(tree, dict):
        return [[str(name), plain(value)] for name, value in tree.items()]
    if isinstance(tree, list):
        return [[plain(x) for x in item] for item in tree if isinstance(item, (list, tuple)) and len(item) == 2]
    return []


def _meta(context):
    run = context.results.reference or (context.results.entries[0].any_run if context.results.entries else None)
    return [[key, value] for key, value in run.meta.items() if "\n" not in value and len(value) < 120] if run else []
