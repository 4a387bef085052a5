"""Operations on sampled series: the stretches of rim contact, and the curve of one impact."""
import dataclasses

import numpy as np

from .numbers import is_number
from .run_folder import Run


def shown_part(run: Run) -> Run:
    """Of a window the impact: from its start to as long again, at least 20 ms, past the last release. The flight
    across the dish behind it says nothing of it. Other runs as they are."""
    ends = [impact["release_time_s"] for impact in run.impacts if is_number(impact.get("release_time_s"))]
    if run.kind != "window" or not ends or "time" not in run.signals:
        return run
    shown = run.time <= max(ends) + max(0.02, max(ends) - run.time[0])
    if shown.sum() < 2 or shown.all():
        return run
    cut = {name: values[shown] if len(values) == len(shown) else values for name, values in run.signals.items()}
    return dataclasses.replace(run, signals=cut)


def contact_stretches(run: Run) -> list[slice]:
    """Slices of consecutive samples with rim force."""
    if not run.has("impact_x", "impact_y"):
        return []
    touching = np.concatenate([[False], run.norm("impact") > 0.0, [False]])
    starts = np.flatnonzero(~touching[:-1] & touching[1:])
    ends = np.flatnonzero(touching[:-1] & ~touching[1:])
    return [slice(first, end) for first, end in zip(starts, ends) if end - first > 1]


def radial_impact_force(run: Run, part: slice) -> np.ndarray:
    """Rim force towards the centre [N]: positive while the rim pushes."""
    ux, uy = run.signals["displacement_x"][part], run.signals["displacement_y"][part]
    r = np.maximum(np.hypot(ux, uy), 1e-12)
    return -(run.signals["impact_x"][part] * ux + run.signals["impact_y"][part] * uy) / r


def impact_curve(run: Run, part: slice) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(time since touch [s], force [N], penetration [m]) of one impact, closed by the zero force before touch and after
    release: by the neighbouring samples where they are at the rim too, else straight down. The penetration is -gap; of a
    triple pendulum, whose gap is counted to the last of its rims, it is that of the top plate's."""
    gap = run.signals["gap"] if run.has("gap") else None
    if run.has("face_4_rim_penetration"):
        gap = -run.signals["face_4_rim_penetration"]
    at_rim = lambda i: gap is not None and 0 <= i < len(gap) and gap[i] <= 1e-9
    first = part.start - 1 if at_rim(part.start - 1) else part.start
    last = part.stop if at_rim(part.stop) else part.stop - 1
    time, force = run.time[part], radial_impact_force(run, part)
    depth = -gap if gap is not None else np.zeros_like(run.time)
    return (np.concatenate([run.time[[first]], time, run.time[[last]]]) - run.time[first], np.concatenate([[0.0], force, [0.0]]),
            np.concatenate([depth[[first]], depth[part], depth[[last]]]))
