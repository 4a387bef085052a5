"""What a number and an entry of the catalogue are called, on the screen, as JSON and in documents."""
from typing import Any

from ..numbers import sig
from .catalogue import Entry, Number
from .results import Ours


def printed(number: Number) -> str:
    return f"≥ {sig(number.at_least)}" if number.printed is None and number.at_least is not None else sig(number.printed, 4)


def counts(total: dict[str, int]) -> str:
    compared = total["met"] + total["not met"]
    return (f"{compared} numbers compared: {total['met']} met, {total['not met']} not met with their cause; "
            f"{total['apart']} more prove little (inputs, duplicates, tuned or not printed) and are counted apart; "
            f"{total['not comparable']} not comparable, with a sentence why; {total['not run']} not run yet")


def word(number: Number, verdict: str) -> str:
    return {"not met": number.cause, "not comparable": number.why, "apart": number.apart}.get(verdict, "")


def made_by(entry: Entry) -> str:
    return entry.command or (f"rimpact thesis {entry.id}" if entry.panels or entry.numbers else "")


def span(entry: Entry) -> str:
    return entry.id if not entry.also else f"{entry.id} to {entry.also[-1]}" if len(entry.also) > 2 else ", ".join(entry.ids)


def number_json(n: Number, entry: Entry, ours: Ours) -> dict[str, Any]:
    value = ours.of(entry, n)
    return {"what": n.what, "printed": n.printed, "at_least": n.at_least, "unit": n.unit, "within": n.within, "resolved": n.resolved, "ours": value,
            "without_cause": ours.without_cause(entry, n), "verdict": n.verdict(value), "word": "" if ours.refitted else word(n, n.verdict(value)),
            **({"assumed_rims": ours.assumed.get(entry.id, {}).get(n.what)} if ours.refitted else {})}
