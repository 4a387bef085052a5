"""What a hard case may ask of its run's summary; `of` gives the summary of another case by its name."""
from collections.abc import Callable
from typing import Any

Summary = dict[str, Any]
Check = Callable[[Summary, Callable[[str], Summary]], bool]


def close_to(name: str, within: float) -> Check:
    """Peak force against another case's."""
    return lambda s, of: abs(s["peak_impact_force_N"] / of(name)["peak_impact_force_N"] - 1) < within


def impacts(at_least: int) -> Check:
    return lambda s, of: len(s["impacts"]) >= at_least
