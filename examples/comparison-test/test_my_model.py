"""Holds `my_model` against impacts that finite elements have computed: python3 -m pytest. Limits are in per cent, times in ms."""
import os
import pathlib

import my_model
import rimpact

#: The kept runs of the source tree, else those that the program is installed with.
REFERENCES = pathlib.Path(os.environ.get("RIMPACT_REFERENCES", pathlib.Path(__file__).resolve().parents[2] / "data/references"))


def hold(window: str, limits: dict[str, float]) -> None:
    """Flies the model from where the kept run begins, and raises where a limit is not met."""
    reference = rimpact.load(REFERENCES / window)
    start = reference.response.iloc[0]
    speed = reference.impacts.approach_speed_m_s[0]
    own = my_model.impact(rimpact.Scene(REFERENCES / window), start.displacement_x, speed, reference.response.index[-1])
    rimpact.compare(reference, own, limits).check()


def test_a_gentle_impact() -> None:
    hold("window-0.20", {"peak": 5, "rebound": 15, "time_ms": 0.2})


def test_an_impact_as_earthquakes_bring_it() -> None:
    hold("window-0.35", {"peak": 5, "rebound": 15, "time_ms": 0.2})


def test_a_hard_impact() -> None:
    hold("window-0.50", {"peak": 5, "rebound": 15, "time_ms": 0.2, "rms_force": 6})
