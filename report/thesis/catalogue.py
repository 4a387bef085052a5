"""The catalogue of figures, tables and printed numbers: data/thesis/*.toml, read and checked.

A [run.NAME] is a command of rimpact, or a kept reference. An [[entry]] is a figure, a table or a passage with numbers: what
it needs, its panels (`every_panel` is what they share), and its numbers: what is printed, how ours is found, within what it
counts as met. A number that cannot be compared says why; one that is not met says the cause."""
import os
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from ..errors import DataError, InputError
from ..shapes import ANY, FLAG, NUMBER, TEXT, check, numbers, texts

STATES = ("done", "partly", "missing", "drawing")
FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "data")
NUMBER_SHAPE = {**texts("what unit ours why cause without headline apart"), **numbers("printed factor within resolved at_least count")}
CURVE = {**texts("run label side"), "x": ANY, "y": ANY}
MARK = {**texts("entry number"), **numbers("curve factor")}  #: a printed number of an entry, drawn in the colour of a curve
PANEL = {**texts("title x_label y_label x y kind of colour dashes unit"), "curves": [CURVE], "marks": [MARK], **numbers("x_factor y_factor R0_m a_m limit"),
         "x_range": [NUMBER], "y_range": [NUMBER], "systems": [TEXT], "records": [TEXT], "shapes": [{"label": TEXT, "R0_m": NUMBER, "a_m": NUMBER}]}
SHAPE = {
    "thesis": texts("author title kind university year"),
    "reading": [texts("what printed exact key")],
    "reading_count": [{**texts("section"), **numbers("printed exact numbers")}],
    "run": {"*": {"command": [TEXT], "kept": TEXT, "json": FLAG, "seconds": NUMBER, "heavy": FLAG, "records": [TEXT]}},
    "entry": [{**texts("id section title state command differs"), "also": [TEXT], "records": [TEXT], "columns": NUMBER,
               "every_panel": PANEL, "panel": [PANEL], "number": [NUMBER_SHAPE],
               "table": [{"cause": [{**texts("of run path cause"), "rows": [TEXT]}],
                          "columns": [TEXT], "paths": [TEXT], "factors": [NUMBER], "within": [NUMBER], "resolved": [NUMBER], "units": [TEXT], "causes": [TEXT],
                          "row": [{"label": TEXT, "run": TEXT, "without": TEXT, "printed": [NUMBER]}]}]}],
}


@dataclass
class Run:
    name: str
    command: list[str] = field(default_factory=list)  #: words after `rimpact`; {records} stands for the user's folder
    kept: str = ""       #: a run's folder in data/, or a JSON file there, instead of a command
    json: bool = False   #: the verb prints JSON and leaves no folder
    seconds: float = 1.0
    heavy: bool = False  #: finite elements, or longer than a minute
    records: list[str] = field(default_factory=list)

    @property
    def has_two_dishes(self) -> bool:
        """Of chapters 3 and 4: models dcfp and lir-dcfp, or a scene that is named after them."""
        return any("dcfp" in word for word in self.command)


@dataclass
class Number:
    what: str
    printed: float | None = None
    unit: str = ""
    ours: str = ""         #: "run:path", "a / b" or "a / b - 1" of such; several of these, "; " between them: their mean
    factor: float = 1.0
    within: float | None = None   #: largest difference that counts as met, in the printed unit
    resolved: float = 0.0  #: what the default step tolerance leaves open in ours, in the printed unit
    at_least: float | None = None #: instead: ours is to be so much or more
    why: str = ""          #: why it is not compared
    cause: str = ""        #: why it is not met
    without: str = ""      #: as `ours`, of a run without that cause: what the cause moves
    headline: str = ""     #: where the thesis's abstract or conclusions give it as a result
    apart: str = ""        #: why it proves little: an input, a duplicate, tuned, not printed. It is counted apart
    count: int = 1         #: printed numbers it stands for

    def verdict(self, ours: float | None) -> str:
        """met | not met | apart | not comparable | not run"""
        if self.why:
            return "not comparable"
        if ours is None:
            return "not run"
        if self.apart:
            return "apart"
        met = ours >= self.at_least if self.at_least is not None else abs(ours - (self.printed or 0.0)) <= (self.within or 0.0)
        return "met" if met else "not met"


@dataclass
class Entry:
    id: str
    title: str
    section: str = ""
    state: str = ""
    command: str = ""   #: what makes it where no run of the catalogue does
    differs: str = ""   #: sentences: how ours differs from the thesis's, or why there is none
    also: list[str] = field(default_factory=list)
    records: list[str] = field(default_factory=list)
    columns: int = 2
    panels: list[dict[str, Any]] = field(default_factory=list)
    numbers: list[Number] = field(default_factory=list)

    @property
    def ids(self) -> list[str]:
        return [self.id, *self.also]

    def runs(self, causes: bool = True) -> list[str]:
        """Names of the runs it needs, in order, each once; `causes`: those that take a cause away too."""
        named = [curve["run"] for panel in self.panels for curve in panel.get("curves", [])]
        for number in self.numbers:
            for text in filter(None, (number.ours, number.without if causes else "")):
                named += [term.split(":")[0].strip() for term in re.split("[;/]", text)]
        return list(dict.fromkeys(named))


@dataclass
class Catalogue:
    thesis: dict[str, str]
    runs: dict[str, Run]
    entries: list[Entry]
    readings: list[dict[str, str]] = field(default_factory=list)       #: what the items take as printed
    reading_counts: list[dict[str, Any]] = field(default_factory=list)  #: met by these and by the exact ones

    def find(self, name: str) -> Entry:
        for entry in self.entries:
            if name in entry.ids:
                return entry
        raise InputError(f"{name} is no figure, table or passage of the catalogue; rimpact thesis list shows them")

    def printed(self, entry: str, what: str) -> float:
        """Throws DataError where the entry has no such printed number."""
        for number in self.find(entry).numbers:
            if number.what == what and number.printed is not None:
                return number.printed
        raise DataError(f"data/thesis: {entry} has no printed number {what}")

    def records_of(self, entry: Entry) -> list[str]:
        needed = list(entry.records)
        for name in entry.runs():
            needed += self.runs[name].records
        return list(dict.fromkeys(needed))

    def seconds_of(self, entry: Entry, cheap: bool = True) -> float:
        return sum(self.runs[name].seconds for name in entry.runs() if not (cheap and self.runs[name].heavy))

    @property
    def citation(self) -> str:
        t = self.thesis
        return f"{t['author']}, {t['title']}, {t['kind']}, {t['university']}, {t['year']}"


def load(folder: str = os.path.join(FOLDER, "thesis")) -> Catalogue:
    """Throws DataError naming the file, and the entry of what makes no sense."""
    thesis: dict[str, str] = {}
    commands: dict[str, dict[str, Any]] = {}
    entries: list[dict[str, Any]] = []
    readings: list[dict[str, str]] = []
    counts: list[dict[str, Any]] = []
    for name in sorted(os.listdir(folder), key=lambda name: (name.startswith("app"), name)):
        if not name.endswith(".toml"):
            continue
        path = os.path.join(folder, name)
        try:
            with open(path, "rb") as file:
                data = tomllib.load(file)
        except (OSError, tomllib.TOMLDecodeError) as error:
            raise DataError(f"{path} is not readable TOML ({error})") from None
        check(data, SHAPE, path)
        thesis |= data.get("thesis", {})
        commands |= data.get("run", {})
        entries += data.get("entry", [])
        readings += data.get("reading", [])
        counts += data.get("reading_count", [])
    runs = {name: Run(name, **run) for name, run in commands.items()}
    return Catalogue(thesis, runs, [_entry(data, runs) for data in entries], readings, counts)


def _entry(data: dict[str, Any], runs: dict[str, Run]) -> Entry:
    plain = {key: value for key, value in data.items() if key not in ("every_panel", "panel", "number", "table")}
    entry = Entry(**plain, panels=[data.get("every_panel", {}) | panel for panel in data.get("panel", [])], numbers=[Number(**number) for number in data.get("number", [])])
    for table in data.get("table", []):
        entry.numbers += _numbers_of(table)
    if entry.state not in STATES:
        raise DataError(f"data/thesis: {entry.id}: state \"{entry.state}\" is none of {', '.join(STATES)}")
    for name in entry.runs():
        if name not in runs:
            raise DataError(f"data/thesis: {entry.id} names the run {name}, which is not there")
    for number in entry.numbers:
        if not number.why and not number.ours:
            raise DataError(f"data/thesis: {entry.id}: {number.what} is neither compared nor says why not")
    return entry


def _causes_of(table: dict[str, list[Any]]) -> dict[tuple[str, str], dict[str, Any]]:
    """The [[entry.table.cause]] of a number, by its column and its row's label: every number named is there, and has one."""
    labels, causes = {row["label"] for row in table["row"]}, dict[tuple[str, str], dict[str, Any]]()
    for cause in table.get("cause", []):
        for named in ((cause["of"], row) for row in cause["rows"]):
            if named[0] not in table["columns"] or named[1] not in labels:
                raise DataError(f"data/thesis: a cause is given to {', '.join(named)}, which the table has not")
            if named in causes:
                raise DataError(f"data/thesis: {', '.join(named)} has two causes")
            causes[named] = cause
    return causes


def _numbers_of(table: dict[str, list[Any]]) -> Iterator[Number]:
    """A table's numbers, row by row: every column has a path, a factor, a bound and a cause of its own. A [[entry.table.cause]] gives the numbers
    of some rows of a column another cause, with the run that is without it and, where it is read elsewhere there, the path."""
    n, causes = len(table["columns"]), _causes_of(table)
    of = lambda key, default: table.get(key, [default] * n)
    for row in table["row"]:
        for k, column in enumerate(table["columns"]):
            cause = causes.get((column, row["label"]))
            without = f"{cause['run']}:{cause.get('path', table['paths'][k])}" if cause else f"{row['without']}:{table['paths'][k]}" if "without" in row else ""
            yield Number(f"{column}, {row['label']}", row["printed"][k], of("units", "")[k], f"{row['run']}:{table['paths'][k]}", of("factors", 1.0)[k],
                         of("within", None)[k], of("resolved", 0.0)[k], cause=cause["cause"] if cause else of("causes", "")[k], without=without)
