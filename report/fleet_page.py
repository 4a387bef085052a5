"""The report of a sweep's folder: what was varied, the results, their spread; report.html, self-contained."""
import os

import numpy as np

from . import hit_limits, page
from .blocks import Pictures, Section, note, table
from .figures import fleet as figure_fleet
from .fleet import Fleet, read
from .interactive import Line, Panel
from .numbers import integer, percent, sig
from .style import CYCLE, FITTED, MUTED


def build(folder: str, output: str | None = None) -> tuple[str, list[str]]:
    """Gives the report's path and the list of problems."""
    fleet = read(folder)
    problems: list[str] = []
    output = output or os.path.join(folder, "report.html")
    pictures = Pictures(os.path.join(folder, "figures"), problems)
    results = Section("results", "Results", lead="Over what was varied.")
    limits = hit_limits.read(folder)
    for doubt in hit_limits.doubts(limits):
        results.add(doubt)
    results.add(pictures.figure("fleet", "", figure_fleet.draw, fleet, curves=_curves))
    results.add(_spread(fleet))
    results.add(hit_limits.shares(limits))
    runs = Section("runs", "Runs")
    runs.add(_parameters(fleet))
    failed = [status for status in fleet.status if status != "done"]
    runs.add(note(f"{len(failed)} of {len(fleet.status)} runs did not end well; the columns status and reason of the table say why.", "warning") if failed else None)
    absent = fleet.n_due - len(fleet.status)
    runs.add(note(f"{len(fleet.status)} of {fleet.n_due} runs are here: the other shards are missing.", "warning") if absent > 0 else None)
    due = f" of {integer(fleet.n_due)}" if absent > 0 else ""
    page.write(output, "page.html.j2", title=f"Sweep of {integer(len(fleet.status))}{due} runs", subtitle=os.path.basename(os.path.normpath(folder)),
               sections=[results, runs], problems=problems, footer="Every run is a row of table.csv.")
    return output, problems


def _curves(fleet: Fleet) -> list[Panel]:
    """Fractiles along their parameter; without them there is no curve to zoom."""
    if fleet.along not in fleet.columns:
        return []
    panels = []
    for name, factor, label in figure_fleet.shown_results(fleet):
        if f"p50_{name}" not in fleet.fractiles:
            continue
        panel = Panel(label.split(" (")[0].capitalize(), fleet.along, label, group="along")
        for i, (group, rows) in enumerate(figure_fleet.grouped(fleet)):
            _add_fractiles(panel, fleet, name, factor, group, rows, CYCLE[i % len(CYCLE)])
        panels.append(panel)
    if "n_impacts" in fleet.columns:
        levels, share = figure_fleet.share_touching(fleet, fleet.along)
        panels.append(Panel("Runs that touch the rim", fleet.along, "share (%)", [Line("share", levels, 100 * share, FITTED)], group="along"))
    return panels


def _add_fractiles(panel: Panel, fleet: Fleet, name: str, factor: float, group: str, rows: np.ndarray, colour: str) -> None:
    """The median and, where there is but one curve, the two others beside it."""
    said = (("p50", group or "50 %", colour, ""), ("p16", "16 %", MUTED, "5 3"), ("p84", "84 %", MUTED, "2 2"))
    for part, text, own, dash in said[:1] if group else said:
        values = factor * fleet.fractiles[f"{part}_{name}"][rows]
        good = np.isfinite(values)
        if good.any():
            panel.lines.append(Line(text, fleet.fractiles[fleet.along][rows][good], values[good], own, dash))


def _spread(fleet: Fleet) -> dict | None:
    rows = []
    for name, factor, label in figure_fleet.shown_results(fleet):
        values = factor * fleet.columns[name][np.isfinite(fleet.columns[name])]
        rows.append([label, *(sig(float(v), 3) for v in (values.min(), *np.percentile(values, (16, 50, 84)), values.max()))])
    if "n_impacts" in fleet.columns:
        rows.append(["runs that touch the rim", "", "", percent(float((np.nan_to_num(fleet.columns["n_impacts"]) > 0).mean()), 1, False), "", ""])
    return table(["", "least", "16 %", "50 %", "84 %", "largest"], rows, caption="Of all runs together.")


def _parameters(fleet: Fleet) -> dict | None:
    rows = []
    for name in fleet.parameters:
        values = fleet.columns[name][np.isfinite(fleet.columns[name])]
        if len(values):
            rows.append([f"`{name}`", sig(float(values.min()), 4), sig(float(values.max()), 4), integer(len(np.unique(values)))])
    return table(["varied", "from", "to", "different values"], rows, compact=True)
