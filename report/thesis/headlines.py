"""The thesis's own results: the numbers that its abstract and conclusions give, each judged, each with its run."""
from typing import Any

from ..numbers import sig
from .catalogue import Catalogue, Entry, Number
from .results import Ours
from .words import made_by, number_json, printed, word


def of(catalogue: Catalogue) -> list[tuple[Entry, Number]]:
    """In the order of the chapters."""
    return [(entry, number) for entry in catalogue.entries for number in entry.numbers if number.headline]


def as_text(catalogue: Catalogue, ours: Ours) -> str:
    """A line each, then the causes of those that are not met."""
    lines, causes = [], []
    for entry, number in of(catalogue):
        verdict = number.verdict(ours.of(entry, number))
        values = f"thesis {printed(number)} {number.unit}", f"ours {sig(ours.of(entry, number), 3)} {number.unit}", f"within {sig(number.within)} points"
        lines.append(f"{number.headline:85} {values[0]:16} {values[1]:14} {verdict:8} ({values[2]})  {made_by(entry)}")
        causes += [f"{number.headline}: {word(number, verdict)}"] if word(number, verdict) else []
    return "\n".join([*lines, "", *causes])


def as_json(catalogue: Catalogue, ours: Ours) -> list[dict[str, Any]]:
    return [{"headline": number.headline, "entry": entry.id, "command": made_by(entry), **number_json(number, entry, ours)} for entry, number in of(catalogue)]


def as_table(catalogue: Catalogue, ours: Ours) -> list[str]:
    """Lines of Markdown."""
    lines = ["| | thesis | ours | met within | | made by | |", "|---|---|---|---|---|---|---|"]
    for entry, number in of(catalogue):
        verdict = number.verdict(ours.of(entry, number))
        cells = [number.headline, f"{printed(number)} {number.unit}", f"{sig(ours.of(entry, number), 3)} {number.unit}", f"{sig(number.within)} points", verdict,
                 f"`{made_by(entry)}`", word(number, verdict)]
        lines.append(f"| {' | '.join(cells)} |")
    return lines
