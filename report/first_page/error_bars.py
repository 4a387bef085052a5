"""How far the answer's numbers may be from the bearing's, one bar a number: the record's known parts, and the names of those that are not.

Parts add as squares, so a part's length is its share of the sum of squares; the bar's whole length is the root of that sum, on one
scale for all bars. A part that is known to be nothing is in the record and not drawn."""
import math
from typing import Any

from ..numbers import DASH, is_number, percent_up

QUANTITIES = {"peak_force": "Peak force", "depth": "Depth", "rebound": "Rebound", "k_i": "k_i", "e": "e", "strain": "Strain"}
ROOM = 10.0  #: width of a part, in % of the longest bar, below which its name does not fit into it


def bars(errors: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each with `label`, `total` ("30 %"), `length` (of 100), `parts` (name, value, share of the bar in %) and `unknown`."""
    rows = [_row(name, [e for e in errors if e.get("quantity") == key and e.get("source")]) for key, name in QUANTITIES.items()]
    rows = [row for row in rows if row["parts"] or row["unknown"]]
    longest = max((row["sum"] for row in rows), default=0)
    for row in rows:
        row["length"] = 100 * row["sum"] / longest if longest > 0 else 0
        for part in row["parts"]:
            part["named"] = part["share"] * row["length"] / 100 >= ROOM
    return rows


def _row(label: str, errors: list[dict[str, Any]]) -> dict[str, Any]:
    known = sorted((e for e in errors if is_number(e.get("value")) and e["value"] > 0), key=lambda e: -e["value"])
    squares = sum(e["value"] ** 2 for e in known)
    parts = [{"source": e["source"], "value": percent_up(e["value"]), "how": e.get("how", ""),
              "share": 100 * e["value"] ** 2 / squares} for e in known if squares > 0]
    return {"label": label, "sum": math.sqrt(squares), "total": percent_up(math.sqrt(squares)) if known else DASH,
            "parts": parts, "unknown": [e["source"] for e in errors if not is_number(e.get("value"))]}
