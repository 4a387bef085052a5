"""What makes a run doubtful, and where it is said: beside every row of the run (a mark), on the first page (in full)."""
import re
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

from .plain_words import for_page, kind_of, worst_of
from .results import Entry, Results
from .run_folder import Run

MARK = Markup('<b class="mark" title="doubtful: see the first page">!</b>')


@dataclass(frozen=True)
class Doubt:
    runs: tuple  #: names of the runs it is said of; empty: of the whole
    sentence: str


def of_run(run: Run) -> list[str]:
    """Warnings of the run's own summary, and that it did not end as it should."""
    found = list(run.summary.get("warnings", []))
    if run.status not in ("done", "missing"):
        reason = run.summary.get("reason")
        found.insert(0, f"{run.status}" + (f": {reason}" if reason else "") + "; what is shown of it is partial")
    return found


@dataclass(frozen=True)
class Line:
    """Doubts of one kind as one line."""
    count: int  #: doubts it stands for
    runs: tuple  #: of the sentence, which is the worst of them
    sentence: str


class Doubts:
    """All of a results folder, each sentence once."""

    def __init__(self, results: Results, answer: dict[str, Any]) -> None:
        self.by_entry: dict[str, list[str]] = {}  #: name of a scene -> its sentences
        said: dict[str, list[str]] = {}  #: sentence -> the runs it is said of, in order
        for sentence in answer.get("doubts", []):
            said.setdefault(sentence, [])
        for entry in results.entries:
            for label, run in _runs(entry, results.single):
                for sentence in of_run(run):
                    self._add(said, entry.name, label, sentence)
        for row in results.main.get("comparison", []):
            for sentence in row.get("doubts", []):
                self._add(said, row.get("name", ""), row.get("name", ""), sentence)
        for sentence in results.main.get("warnings", []):
            if not any(own in sentence and any(run in sentence for run in runs) for own, runs in said.items() if runs):
                said.setdefault(sentence, [])
        self.all = [Doubt(tuple(dict.fromkeys(runs)), sentence) for sentence, runs in said.items()]

    @property
    def lines(self) -> list[Line]:
        """Those that differ in a run's name and in numbers alone are one line: how many, and the worst."""
        kinds: dict[str, list[Doubt]] = {}
        for doubt in self.all:
            kinds.setdefault(kind_of(doubt.sentence), []).append(doubt)
        return [self._line(alike) for alike in kinds.values()]

    @staticmethod
    def _line(alike: list[Doubt]) -> Line:
        worst = alike[worst_of([doubt.sentence for doubt in alike])]
        count = sum(max(1, len(doubt.runs)) for doubt in alike)
        return Line(count if len(alike) > 1 else 1, worst.runs, for_page(worst.sentence))

    def _add(self, said: dict[str, Any], name: str, label: str, sentence: str) -> None:
        own = self.by_entry.setdefault(name, [])
        if sentence in own:
            return
        own.append(sentence)
        if not any(sentence in other and (name in other or not name) for other in said if other != sentence):
            said.setdefault(sentence, []).append(label)

    def mark(self, name: str) -> Markup:
        """The mark of a run's row, empty where nothing is doubted: neither by the run nor by a sentence that names it."""
        named = re.compile(rf"(?<![\w.-]){re.escape(name)}(\.toml)?(?![\w-]|\.\w)")
        doubted = self.by_entry.get(name) or any(named.search(doubt.sentence) for doubt in self.all)
        return MARK if doubted else Markup("")

    def marked(self, name: str, text: str) -> str:
        mark = self.mark(name)
        return escape(text) + Markup(" ") + mark if mark else text


def _runs(entry: Entry, single: bool) -> list[tuple[str, Run]]:
    """(label, run) of what the report shows of a scene."""
    labels = (("fe", entry.name), ("fitted", f"{entry.name} (reduced)"), ("law", f"{entry.name} (reduced, best law)"),
              ("published", f"{entry.name} (reduced, published pair)"))
    return [(entry.name if single else label, getattr(entry, slot)) for slot, label in labels if getattr(entry, slot) is not None]
