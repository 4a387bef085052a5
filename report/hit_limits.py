"""Which share of a fleet's hits on the rim lies where the models are not known to hold: studies/fleets/hit_shares.h writes it."""
import os
from typing import Any

from .blocks import note, table
from .data_files import read_any_json
from .errors import DataError
from .numbers import integer, is_number, percent, sig

PARTS = (("fit", "outside the speeds the element was fitted to"), ("pair", "faster than the thesis's pair is known for"),
         ("rim", "deeper than the rim is thick"), ("steel", "beyond the steel's limit of strain"))
UNKNOWN = "not known"


def read(folder: str) -> dict[str, Any]:
    """FOLDER/limits.json of a sweep; empty: a version before it, or shards that are not gathered."""
    path = os.path.join(folder, "limits.json")
    if not os.path.isfile(path):
        return {}
    limits = read_any_json(path)
    if not isinstance(limits, dict) or not isinstance(limits.get("doubts", []), list):
        raise DataError(f"{path} does not say which hits lie beyond the models' limits")
    return limits


def doubts(limits: dict[str, Any]) -> list[dict[str, str]]:
    return [note(str(sentence), "warning") for sentence in limits.get("doubts", [])]


def _known(limits: dict[str, Any]) -> str:
    low, high = limits.get("known_from_m_s"), limits.get("known_to_m_s")
    if is_number(low) and is_number(high):
        return f"{sig(low, 3)} to {sig(high, 3)} m/s"
    if is_number(low):
        return f"{sig(low, 3)} m/s upwards"
    if not is_number(high):
        return "speeds that are not stored"
    return f"up to {sig(high, 3)} m/s" if high else "no speed on this bearing or at this mass"


def shares(limits: dict[str, Any]) -> dict[str, Any] | None:
    """A table, a row for each limit; what no run tells is said to be unknown."""
    if not limits.get("n_hits"):
        return None
    rows = [[words, integer(limits[f"hits_beyond_{name}"]) if is_number(limits.get(f"hits_beyond_{name}")) else UNKNOWN,
             percent(limits[f"share_beyond_{name}"], 1, False) if is_number(limits.get(f"share_beyond_{name}")) else UNKNOWN]
            for name, words in PARTS]
    speeds = f"{sig(limits.get('slowest_approach_speed_m_s'), 3)} to {sig(limits.get('fastest_approach_speed_m_s'), 3)} m/s"
    said = f"its element is known for {_known(limits)}"
    return table(["hits", "number", "share"], rows, compact=True,
                 caption=f"{integer(limits['n_hits'])} hits on the rim, at {speeds}; {said}.")
