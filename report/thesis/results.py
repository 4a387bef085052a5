"""The numbers as last found: kept with the program (data/thesis/ours.json), and in the user's folder once they are made there."""
import json
import os

from ..data_files import read_any_json
from ..files import write_whole
from .catalogue import FOLDER, Entry, Number

WITHOUT = " (without the cause)"
KEPT = os.path.join(FOLDER, "thesis", "ours.json")
REFITTED = "numbers-refitted.json"  #: beside numbers.json, which is of the rims that the thesis has or we assumed
VERDICTS = ("met", "not met", "apart", "not comparable", "not run")


class Ours:
    """Ours of every number, by entry and what it is of. `refitted`: of rims with a law of the user's; those kept with the program, of the rims that
    the thesis has or we assumed, stand beside them."""

    def __init__(self, folder: str, refitted: bool = False) -> None:
        self.path = os.path.join(folder, REFITTED if refitted else "numbers.json")
        kept = read_any_json(KEPT) if os.path.isfile(KEPT) else {}
        self.refitted = refitted
        self.assumed: dict[str, dict[str, float]] = kept if refitted else {}
        self.values = {} if refitted else kept
        self.made: dict[str, dict[str, float]] = read_any_json(self.path) if os.path.isfile(self.path) else {}  #: in this folder
        for entry, numbers in self.made.items():
            self.values.setdefault(entry, {}).update(numbers)

    def of(self, entry: Entry, number: Number) -> float | None:
        return self.values.get(entry.id, {}).get(number.what)

    def without_cause(self, entry: Entry, number: Number) -> float | None:
        """Ours where the cause is taken away."""
        return self.values.get(entry.id, {}).get(number.what + WITHOUT)

    def put(self, entry: Entry, values: list[float | None], without: list[float | None]) -> None:
        """`values`, `without`: of its numbers in their order; what was not found now stays as it was."""
        named = [(number.what + end, value) for end, list_of in (("", values), (WITHOUT, without)) for number, value in zip(entry.numbers, list_of)]
        found = {what: float(f"{value:.6g}") for what, value in named if value is not None}
        self.made.setdefault(entry.id, {}).update(found)
        self.values.setdefault(entry.id, {}).update(found)
        os.makedirs(os.path.dirname(os.path.abspath(self.path)), exist_ok=True)
        write_whole(self.path, lambda file: file.write(json.dumps(self.made, indent=1, sort_keys=True).encode()))

    def n_kept(self, entries: list[Entry]) -> int:
        """How many numbers of the entries are those kept with the program: nothing in this folder made them."""
        return sum(number.count for entry in entries for number in entry.numbers
                   if self.of(entry, number) is not None and number.what not in self.made.get(entry.id, {}))

    def count(self, entries: list[Entry]) -> dict[str, int]:
        """How many numbers of the entries have each verdict."""
        total = dict.fromkeys(VERDICTS, 0)
        for entry in entries:
            for number in entry.numbers:
                total[number.verdict(self.of(entry, number))] += number.count
        return total
