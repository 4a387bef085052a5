"""One answer, said once: every error beside a law or a pair is of that law, pair and run, and what is not the answer says so."""
import html.parser
import json
import os
import re
import tempfile
import unittest
from typing import Any

import synthetic_results
from small_results import SmallResults
from support import text_of, unpainted

from report.build import build
from report.sections.common import short_name, title_of

LAWS = re.compile(r"\b(elastoplastic|signed|no-tension|hunt-crossley|printed)\b")
PAIR = re.compile(r"k i =|\bpair\b")
SHARE = re.compile(r"^[+−]?\d+(\.\d+)?\u202f%$")
METRICS = (("nrmse displacement", "nrmse_displacement"), ("nrmse force", "nrmse_force"), ("displacement", "peak_displacement_error"),
           ("rebound", "rebound_error"), ("force unexplained", "force_unexplained"), ("peak", "peak_force_error"), ("force", "peak_force_error"))


class Tables(html.parser.HTMLParser):
    """Every table of a page: its record, caption, header and rows."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tables: list[dict[str, Any]] = []
        self.into: list[str] | None = None
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        if tag == "figure" and "table" in dict(attrs).get("class", "").split():
            self.tables.append({"record": dict(attrs).get("data-record", ""), "caption": [], "header": [], "rows": []})
        elif not self.tables:
            return
        elif tag == "tr":
            self.tables[-1]["rows"].append([])
        elif tag in ("th", "td", "figcaption"):
            self.into = []
            place = {"th": "header", "figcaption": "caption"}.get(tag)
            (self.tables[-1][place] if place else self.tables[-1]["rows"][-1]).append(self.into)

    def handle_endtag(self, tag):
        if tag in ("th", "td", "figcaption"):
            self.into = None

    def handle_data(self, data):
        if self.into is not None:
            self.into.append(data)


def tables_of(page: str) -> list[dict[str, Any]]:
    def plain(parts):
        return re.sub(r"[ \n\u00a0]+", " ", " ".join(parts)).strip().removesuffix(" !")
    return [{**table, "caption": " ".join(map(plain, table["caption"])), "header": [plain(cell) for cell in table["header"]],
             "rows": [[plain(cell) for cell in row] for row in table["rows"] if row]} for table in Tables(page).tables]


def metric_of(title: str) -> str | None:
    return next((metric for said, metric in METRICS if said in title.lower()), None)


class Records:
    """What a folder's records say of the errors of each law, looked up again."""

    def __init__(self, folder: str) -> None:
        self.folder = folder
        with open(os.path.join(folder, "calibration", "calibration.json"), encoding="utf-8") as file:
            self.calibration = json.load(file)
        self.law = self.calibration["answer"]["law"]["name"]

    def row(self, law: str) -> dict[str, Any]:
        return next(row for row in self.calibration["laws"]["rows"] if row["law"] == law)

    @staticmethod
    def of_run(errors: dict[str, Any], name: str) -> dict[str, Any]:
        return next(error for folder, error in errors.items() if name in (plain_name(folder.split("/")[-1]), folder))

    def summary(self, part: str, name: str) -> dict[str, Any]:
        with open(os.path.join(self.folder, part, name, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def law_in(self, part: str, name: str) -> str:
        with open(os.path.join(self.folder, part, name, "scene.toml"), encoding="utf-8") as file:
            return re.search(r'impact_law = "(.*)"', file.read())[1]

    def flown(self, part: str, name: str, metric: str) -> float:
        """A stored reduced run against the stored finite elements."""
        def value(summary):
            hardest = max(summary["impacts"], key=lambda impact: impact["peak_force_N"], default={})
            return {"peak_force_error": summary["peak_impact_force_N"], "peak_displacement_error": summary["peak_displacement_m"],
                    "rebound_error": hardest.get("rebound_speed_m_s")}[metric]
        return value(self.summary(part, name)) / value(self.summary("runs", name)) - 1

    def names(self) -> list[str]:
        return sorted(os.listdir(os.path.join(self.folder, "runs")))


def parts_of(label: str, records: Records) -> str:
    """The folder whose runs a row or column is of, by what it is called."""
    if "published" in label:
        return "published"
    return "law" if records.law in label else "reduced"


class Walk:
    """Every share in every table that shows a law or a pair, beside what its record says. `checked` counts them, `faults` says."""

    def __init__(self, page: str, records: Records) -> None:
        self.records, self.faults, self.checked, self.kinds = records, [], 0, set()
        for table in tables_of(page):
            shown = " ".join([table["caption"], *table["header"], *(cell for row in table["rows"] for cell in row)])
            if not (LAWS.search(shown) or PAIR.search(shown)):
                continue
            if not table["record"]:
                self._no_error(table)
                continue
            self.kinds.add(table["record"].split("/")[0])
            getattr(self, "of_" + re.sub(r"\W.*", "", table["record"].replace(".", "_")))(table)

    def _no_error(self, table):
        """A table of no record may show no error."""
        for title in table["header"]:
            if metric_of(title) and any(SHARE.match(cell) for row in table["rows"] for cell in row):
                self.faults.append(f"no record is named for errors in: {table['header']} {table['caption']}")

    def _share(self, cell, expected, where):
        if not SHARE.match(cell):
            if expected is not None and cell not in ("", "–"):
                self.faults.append(f"{where}: {cell!r} for {expected}")
            return
        self.checked += 1
        digits = len(re.sub(r"[^\d.]", "", cell).partition(".")[2])
        stated = float(cell.replace("−", "-").replace("\u202f%", ""))
        if expected is None or abs(stated - 100 * expected) > 0.5001 * 10 ** -digits:
            self.faults.append(f"{where}: {cell} where the record says {expected}")

    def _law_in_caption(self, table):
        found = LAWS.search(table["caption"])
        if not found:
            self.faults.append(f"no law is named: {table['caption']}")
        return found[1] if found else ""

    def _errors(self, table, of_row):
        for row in table["rows"]:
            for title, cell in zip(table["header"], row):
                if metric_of(title) and cell:
                    self._share(cell, of_row(row, title).get(metric_of(title)), f"{table['caption'][:60]} | {row[0]} | {title}")

    def of_laws_runs(self, table):
        stored = self.records.row(self._law_in_caption(table))
        alone = {left["left_out"]: left["runs"].get(left["left_out"]) for left in stored["leave_one_out"]}
        self._errors(table, lambda row, title: self.records.of_run(alone if "left out" in title else stored["runs"], row[0]))

    def of_laws_leave_one_out(self, table):
        stored = self.records.row(self._law_in_caption(table))
        sets = {left["left_out"]: left["runs"] for left in stored["leave_one_out"]}
        self._errors(table, lambda row, title: self.records.of_run(sets[row[0]], row[1]))

    def of_laws_rows(self, table):
        keys = {"force unexplained": "force_unexplained", "peak force, fitted": "largest_peak_force_error", "rebound, fitted": "largest_rebound_error",
                "peak force, left out": "left_out_peak_force_error", "rebound, left out": "left_out_rebound_error"}
        for row in table["rows"]:
            for title, cell in zip(table["header"], row):
                if title in keys:
                    self._share(cell, self.records.row(row[0])[keys[title]], f"{row[0]} | {title}")

    def of_fit(self, table):
        """`fit` and `prediction` are of the law of `derived`, whose numbers are `parameters`."""
        if self._law_in_caption(table) != self.records.calibration["derived"]["law"]:
            self.faults.append(f"`fit` is of another law than: {table['caption']}")
        stored = self.records.calibration["fit"] | self.records.calibration["prediction"]
        self._errors(table, lambda row, title: self.records.of_run(stored, row[0]))

    def of_constant_pair(self, table):
        pair = self.records.calibration["answer"]["pair"]
        if f"{pair['e']:.3g}" not in table["caption"] or self._law_in_caption(table) != pair["law"]:
            self.faults.append(f"another pair: {table['caption']}")
        parts = self.records.calibration["constant_pair"]
        stored = {folder: error for part in ("fitted", "left_out", "outside") for folder, error in parts.get(part, {}).items()}
        self._errors(table, lambda row, title: self.records.of_run(stored, row[0]))

    def of_windows(self, table):
        stored = self.records.calibration["windows"]["rows"]
        if self._law_in_caption(table) != self.records.calibration["derived"]["law"]:
            self.faults.append(f"the windows are of another law than: {table['caption']}")
        for row, one in zip(table["rows"], sorted(stored, key=lambda one: one["speed_m_s"])):
            self._share(row[-1], one["pair_force_error"], f"windows | {row[0]}")

    def of_speed_laws(self, table):
        for row in table["rows"]:
            self._share(row[-1], next(iter(self.records.calibration["speed_laws"].values()))["largest_error"], "speed laws")

    def of_runs(self, table):
        """Stored runs: the law is the one in the row's or column's title, and the folder's scene must say the same."""
        name = table["record"].partition("/")[2]
        if name:
            self._of_one_scene(table, name)
        elif "model" in table["header"]:
            self._by_model(table)
        else:
            self._by_run(table)

    def _flown(self, cell, label, name, metric, where):
        part = parts_of(label, self.records)
        law = LAWS.search(label)
        if law and part != "published" and self.records.law_in(part, name) != law[1]:
            self.faults.append(f"{where}: the run is of {self.records.law_in(part, name)}, the table says {label}")
        if metric in ("peak_force_error", "peak_displacement_error", "rebound_error"):
            self._share(cell, self.records.flown(part, name, metric), where)

    def _of_one_scene(self, table, name):
        for row in table["rows"]:
            if row and row[0].strip() == "error against FE":
                for title, cell in list(zip(table["header"], row))[2:]:
                    self._flown(cell, title, name, "peak_force_error", f"{name} | {title}")

    def _by_model(self, table):
        names = {synthetic_title(name): name for name in self.records.names()}
        name = ""
        for row in table["rows"]:
            if len(row) == 1 or row[0].split(" predicted")[0].split(" used")[0] in names:
                name = next(known for title, known in names.items() if row[0].startswith(title) and (
                    "×" in row[0]) == ("×" in title) and row[0][len(title):len(title) + 1] in ("", " "))
                continue
            before = ""
            for title, cell in zip(table["header"], row):
                if title == "error" and cell:
                    self._flown(cell, row[0], name, metric_of(before), f"{name} | {row[0]} | {before}")
                before = title

    def _by_run(self, table):
        for row in table["rows"]:
            name = next((name for name in self.records.names() if row[0] in (plain_name(name), f"{float(name.split('-')[-1]):.3g}" if name.startswith("window") else "")
                         or (name.startswith("window") and row[0] == f"{float(name.split('-')[-1]):#.3g}")), None)
            for title, cell in zip(table["header"], row):
                if (LAWS.search(title) or "published pair" in title) and cell:
                    self._flown(cell, title, name, "peak_force_error", f"{name} | {title}")


def synthetic_title(name: str) -> str:
    return title_of(name).replace("\u00a0", " ")


def plain_name(name: str) -> str:
    return short_name(name).replace("\u00a0", " ")


@unpainted
class OneRecord(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        synthetic_results.main_folder(holder.name, pulses=synthetic_results.PULSES[:1], speeds=(0.1, 0.3, 1.0))
        cls.page, cls.text = text_of(build(holder.name)[0])
        cls.records = Records(holder.name)
        for name in os.listdir(os.path.join(holder.name, "reduced")):  # where the published pair's runs lie here
            if name.endswith("-published"):
                os.makedirs(os.path.join(holder.name, "published"), exist_ok=True)
                os.rename(os.path.join(holder.name, "reduced", name), os.path.join(holder.name, "published", name.removesuffix("-published")))

    def test_every_error_is_of_the_law_the_pair_and_the_run_beside_it(self):
        walk = Walk(self.page, self.records)
        self.assertEqual(walk.faults, [])
        self.assertGreater(walk.checked, 90)
        self.assertEqual(walk.kinds, {"laws.runs", "laws.leave_one_out", "laws.rows", "fit", "constant_pair", "windows", "speed_laws", "runs"})

    def test_an_error_of_another_record_is_found(self):
        """One share at a time is put in another's place, in every record."""
        page = self.page
        for record in ("laws.runs", "laws.leave_one_out", "laws.rows", "fit", "constant_pair", "windows", "runs"):
            start = page.index(f'data-record="{record}')
            found = list(re.finditer(r">[+−]?\d+\.\d\u202f%<", page[start:page.index("</figure>", start)]))
            self.assertTrue(found, record)
            place = start + found[-1].start()
            wrong = page[:place] + ">+7.7\u202f%<" + page[start + found[-1].end():]
            self.assertTrue(Walk(wrong, self.records).faults, record)
        unnamed = re.sub(r' data-record="[^"]*"', "", page)
        self.assertTrue(Walk(unnamed, self.records).faults)

    def test_whatever_is_not_the_answer_says_so_and_for_what_it_is(self):
        start = self.page.index('<section id="calibration" class="appendix">')
        appendix, before = self.page[start:], self.page[:start]
        self.assertIn("<span>A</span>Appendix: other fits, not the answer</h2>", appendix)
        for table in tables_of(appendix):
            self.assertTrue(table["caption"].startswith("Not the answer"), table)
            shown = " ".join([*table["header"], *(cell for row in table["rows"] for cell in row)])
            if re.search(r"\bk i\b", shown):  # a stiffness: for which law and mass it is
                self.assertRegex(table["caption"] + shown, LAWS)
                if table["header"][0] != "correlation" and "stated" not in table["header"][0]:
                    self.assertRegex(table["caption"], r"at 86\u202f952 kg")
        for table in tables_of(before):
            if table["header"][0] in ("quantity", "term"):  # what the first run's scene holds; what words mean
                continue
            self.assertNotRegex(" ".join([*table["header"], *(cell for row in table["rows"] for cell in row)]), r"\bk i\b")

    def test_one_pair_stands_before_the_appendix(self):
        start = self.page.index('<section id="calibration" class="appendix">')
        with open(os.path.join(self.records.folder, "body.html"), "w", encoding="utf-8") as file:
            file.write(re.sub(r'<section id="inputs">.*?</section>', "", self.page[:start], flags=re.S))
        _, text = text_of(file.name)
        stiffness = set(re.findall(r"k i = ([\d\u202f., ×⁰-⁹]+)", text))
        self.assertEqual(stiffness, {"251\u202f000 "})


@unpainted
class Said(SmallResults):
    def test_a_pair_on_the_page_leaves_none_beside_the_speeds(self):
        page, text = self.page()
        self.assertNotIn("pair at this one speed", text)
        page, text = self.page(pair=None, no_pair="No constant pair is met.")
        self.assertIn("pair at this one speed and mass (no-tension)", text)
        self.assertIn("250\u202f000 0.480", re.sub(" +", " ", text))


if __name__ == "__main__":
    unittest.main()
