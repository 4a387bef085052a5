"""What the report of a reliability study says, section by section."""
import os
from typing import Any

from markupsafe import Markup

from .. import hit_limits
from ..blocks import Pictures, Section, bullets, note, table, text
from . import figures, tables


def few(values: list[float], count: int = 3) -> list[float]:
    """Some of a list, its ends among them."""
    if len(values) <= count:
        return values
    return [values[round(i * (len(values) - 1) / (count - 1))] for i in range(count)]


def percent(value: Any) -> str:
    return f"{100 * value:.3g} %"


def unknown_runs(rows: list[dict[str, Any]]) -> str:
    """Of all systems: runs that stopped short of the limit, and between what they leave the probability."""
    n = sum(int(row.get("n_unknown") or 0) for row in rows)
    if n == 0:
        return "0"
    return f"{n}: {min(row['probability_if_none'] for row in rows):.3e} to {max(row['probability_if_all'] for row in rows):.3e}"


class Page:
    def __init__(self, folder: str) -> None:
        self.folder = folder
        self.problems: list[str] = []
        self.summary = tables.summary(folder)
        self.rows = {name: tables.read(folder, name) for name in
                     ("ida", "fragility", "reliability", "difference", "levels", "records", "sensitivity")}
        differences = self.summary.get("differences") or [{}]
        self.layout = tables.Layout(self.summary.get("keys", []), self.rows["reliability"], differences[0].get("key"))
        self.pictures = Pictures(os.path.join(folder, "figures"), self.problems)
        self.quantities = list(dict.fromkeys(row["quantity"] for row in self.rows["reliability"]))

    def limits(self, quantity: str) -> list[float]:
        return sorted({row["limit"] for row in self.rows["reliability"] if row["quantity"] == quantity})

    def sections(self) -> list[Section]:
        return [section for section in (self.study(), self.curves(), self.fragilities(), self.reliabilities(),
                                        self.differences(), self.why()) if section.blocks]

    def study(self) -> Section:
        s, section = self.summary, Section("study", "The study")
        n_shown, n_panels = min(figures.MOST_PANELS, len(self.layout.panels)), len(self.layout.panels)
        section.add(text(f"{s['n_systems']} systems of scene {s['scene']}, {s['samples']} samples each; intensity S_a({s['period_s']:g} s), "
                         f"probabilities in {s['years']:g} years. Bands: {percent(s['confidence'])} by drawing the records anew {s['replicates']} times."))
        if n_shown < n_panels:
            section.add(note(f"The pictures show {n_shown} of {n_panels} groups of systems; the tables hold all.", "info"))
        section.add(table(["S_a (g)", "return period (years)", "records", "listed"],
                          [[f"{level['level_g']:.4g}", f"{level['return_period_years']:.0f}", str(level["n_records"]),
                            str(level["n_listed"])] for level in s["levels"]], "Levels of intensity and the records that they have.",
                          left=0, compact=True))
        if s.get("missing"):
            section.add(note(f"{len(s['missing'])} listed motions are not at hand; the results rest on the others. "
                             "reliability.json names them.", "warning"))
        for doubt in s.get("doubts", [])[:8]:
            section.add(note(doubt, "warning"))
        section.add(hit_limits.shares(s.get("hits") or {}))
        section.add(self.pictures.figure("hazard", "Hazard curve and the levels of the study.", figures.hazard, s["hazard"],
                                         s["levels"], s["period_s"]))
        return section

    def curves(self) -> Section:
        section = Section("ida", "Incremental dynamic analysis")
        for quantity in self.quantities:
            if quantity != "collapsed":
                section.add(self.pictures.figure(f"ida-{quantity}", "Median (thick), 16 and 84 % of the runs; a fractile that a collapse "
                                                 "reaches is left out.", figures.ida, self.layout, self.rows["ida"], quantity))
        return section

    def fragilities(self) -> Section:
        section = Section("fragility", "Fragility")
        for quantity in self.quantities:
            limits = few(self.limits(quantity))
            caption = f"{figures.AXES.get(quantity, quantity)} beyond {', '.join(f'{limit:g}' for limit in limits)} (thick to thin)."
            section.add(self.pictures.figure(f"fragility-{quantity}", caption, figures.fragility, self.layout, self.rows["fragility"],
                                             quantity, limits))
        return section

    def reliabilities(self) -> Section:
        section = Section("reliability", "Reliability curves")
        for quantity in self.quantities:
            section.add(self.pictures.figure(f"reliability-{quantity}", f"Probability in {self.summary['years']:g} years and its band.",
                                             figures.reliability, self.layout, self.rows["reliability"], quantity, self.summary["years"]))
        rows = []
        for quantity in self.quantities:
            for limit in self.limits(quantity):
                own = [row for row in self.rows["reliability"] if row["quantity"] == quantity and row["limit"] == limit]
                p = [row["probability"] for row in own]
                unsettled = any(row.get("settled") == 0 for row in own)
                span = f"{min(row['probability_range_low'] for row in own):.1e} to {max(row['probability_range_high'] for row in own):.1e}" if unsettled else ""
                open_end = max((row["rate_above_levels"] / row["rate_per_year"] for row in own if row["rate_per_year"]), default=0)
                rows.append([quantity, f"{limit:g}", *([Markup("<b>a range</b>"), span] if unsettled else [f"{min(p):.3e}", f"{max(p):.3e}"]),
                             f"{max(row['probability_most'] for row in own):.3e}", percent(open_end), unknown_runs(own)])
        section.add(table(["quantity", "limit", "least P", "largest P, or the range", "largest P if all above the levels failed",
                           "largest share of the rate from above the levels", "unknown runs: P if none or all are beyond"], rows,
                          "Over all systems. What lies above the last level rests on the curve across levels, or on its fragility held flat. A range: from that held flat, "
                          "nothing below the first level and the least between levels, to certain failure above the last."))
        return section

    def differences(self) -> Section:
        section = Section("difference", "What a difference buys")
        rows = [[d["key"], tables.shown(d["value"]), d["quantity"], f"{d['limit']:g}", percent(d["mean_reduction"]),
                 f"{percent(d['least_reduction'])} to {percent(d['largest_reduction'])}",
                 f"{d['n_systems_whose_band_excludes_0']} of {d['n_systems']}"] for d in self.summary.get("differences", [])]
        for quantity in self.quantities:
            section.add(self.pictures.figure(f"reduction-{quantity}", "Reduction of the probability against the reference system, "
                                             "records drawn alike for both.", figures.reduction, self.layout,
                                             self.rows["difference"], quantity))
        section.add(table(["key", "value", "quantity", "limit", "mean reduction", "over the systems", "band excludes 0"], rows, left=3))
        return section

    def why(self) -> Section:
        section = Section("why", "Why: intensities, records, inputs")
        for quantity in self.quantities:
            limits = few(self.limits(quantity))
            section.add(self.pictures.figure(f"levels-{quantity}", "Share of the failure rate by level, mean of the systems.",
                                             figures.shares, self.rows["levels"], quantity, limits))
            for limit in limits[-1:]:
                section.add(table(["record", "mean share of the rate"], self.records(quantity, limit),
                                  f"Records that contribute most to P({quantity} > {limit:g}).", compact=True))
        rows = []
        for key in dict.fromkeys(row["key"] for row in self.rows["sensitivity"]):
            for quantity in self.quantities:
                for limit in few(self.limits(quantity)):
                    own = [row["elasticity"] for row in self.rows["sensitivity"]
                           if (row["key"], row["quantity"], row["limit"]) == (key, quantity, limit) and row["elasticity"] is not None]
                    if own:
                        rows.append([key, quantity, f"{limit:g}", f"{sum(own) / len(own):+.2f}", f"{min(own):+.2f} to {max(own):+.2f}"])
        section.add(table(["input", "quantity", "limit", "elasticity of the rate, mean", "over the systems"], rows,
                          "An elasticity of −2: one per cent more of the input, two per cent less rate.", left=2))
        section.add(bullets([("Files.", "ida, fragility, reliability, difference, levels, records, sensitivity and motions, each as .csv and .h5 "
                                        "in long form, one row a value.")]))
        return section

    def records(self, quantity: str, limit: float) -> list[list[str]]:
        sums: dict[str, float] = {}
        n = len(self.layout.systems)
        for row in self.rows["records"]:
            if row["quantity"] == quantity and row["limit"] == limit:
                name = row["record"] or "tails of the fits (no run beyond the limit)"
                sums[name] = sums.get(name, 0) + row["share"] / n
        return [[name, percent(share)] for name, share in sorted(sums.items(), key=lambda item: -item[1])[:8]]
