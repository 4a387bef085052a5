"""Operations on sampled series: thinning that keeps every peak, and the stretches of rim contact."""
import numpy as np


def keep_peaks(*series, limit=2400):
    """Indices, in order, that draw like the whole: per bucket the first sample and each series' extremes.
    Buckets are equal in samples, not in time, so stretches sampled densely (impacts) stay dense."""
    n = len(series[0])
    if n <= limit:
        return np.arange(n)
    buckets = max(1, limit // (2 * len(series) + 1))
    edges = np.linspace(0, n, buckets + 1).astype(int)
    kept = {0, n - 1}
    for values in series:
        for first, last in zip(edges[:-1], edges[1:]):
            part = values[first:last]
            kept.update((first, first + int(np.argmin(part)), first + int(np.argmax(part))))
    return np.array(sorted(kept))


def contact_stretches(run):
    """Slices of consecutive samples with rim force."""
    if not run.has("impact_x", "impact_y"):
        return []
    touching = np.concatenate([[False], run.norm("impact") > 0.0, [False]])
    starts = np.flatnonzero(~touching[:-1] & touching[1:])
    ends = np.flatnonzero(touching[:-1] & ~touching[1:])
    return [slice(first, end) for first, end in zip(starts, ends) if end - first > 1]


def radial_impact_force(run, part):
    """Rim force towards the centre [N]: positive while the rim pushes."""
    ux, uy = run.signals["displacement_x"][part], run.signals["displacement_y"][part]
    r = np.maximum(np.hypot(ux, uy), 1e-12)
    return -(run.signals["impact_x"][part] * ux + run.signals["impact_y"][part] * uy) / r


def impact_curve(run, part):
    """(time since touch [s], force [N], penetration -gap [m]) of one impact, closed by the zero force before touch
    and after release: by the neighbouring samples where they are at the rim too, else straight down."""
    gap = run.signals["gap"] if run.has("gap") else None
    at_rim = lambda i: gap is not None and 0 <= i < len(gap) and gap[i] <= 1e-9
    first = part.start - 1 if at_rim(part.start - 1) else part.start
    last = part.stop if at_rim(part.stop) else part.stop - 1
    time, force = run.time[part], radial_impact_force(run, part)
    depth = -gap if gap is not None else np.zeros_like(run.time)
    return (np.concatenate([run.time[[first]], time, run.time[[last]]]) - run.time[first], np.concatenate([[0.0], force, [0.0]]),
            np.concatenate([depth[[first]], depth[part], depth[[last]]]))
