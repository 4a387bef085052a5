"""One measured impact with its fit: force over time and over penetration."""
from matplotlib.figure import Figure

from ..curves import ImpactCurve
from ..style import FE, FITTED, MUTED, figure, literal, save, shared_legend


def draw(impact: ImpactCurve, law: str, path: str) -> Figure | str:
    """None without samples."""
    if not len(impact.reference.force):
        return None
    fig, ((over_time, over_depth),) = figure(1, 2, 2.45)
    for curve, label, style in ((impact.reference, literal(impact.source), dict(color=FE, lw=1.0, marker=".", ms=2.2)),
                                (impact.law, f"law {literal(law)}", dict(color=FITTED, lw=1.1))):
        if curve is None or not len(curve.force):
            continue
        over_time.plot(1e3 * curve.time, 1e-3 * curve.force, label=label, **style)
        over_depth.plot(1e3 * curve.penetration, 1e-3 * curve.force, **style)
    over_time.set(title="Force over time", xlabel="time since touch (ms)", ylabel="rim force (kN)")
    over_depth.set(title="Force over penetration", xlabel="penetration (mm)", ylabel="rim force (kN)")
    for ax in (over_time, over_depth):
        ax.axhline(0, color=MUTED, lw=0.5, zorder=0)
    shared_legend(fig, [over_time])
    return save(fig, path)
