"""The answer at a glance: rim force of a pulse that was not fitted, and k_i over approach speed."""
from ..series import contact_stretches, impact_curve, keep_peaks
from ..style import figure, line_of, save, shared_legend
from .response_panels import LABELS
from .windows import draw_stiffness


def draw(models, title, calibration, path):
    """models: (role, run) pairs of one pulse, the reference first. None when neither panel has anything to show."""
    impacts = [(role, run, contact_stretches(run)) for role, run in models]
    impacts = [(role, run, max(parts, key=lambda part: run.norm("impact")[part].max())) for role, run, parts in impacts
               if parts]
    if not impacts and not any(row.k_i for row in calibration.windows):
        return None
    fig, ((force_ax, k_ax),) = figure(1, 2, 2.6, gridspec_kw={"width_ratios": [1.15, 1]})
    for role, run, part in impacts:
        time, force, _ = impact_curve(run, part)
        kept = keep_peaks(force, limit=900)
        force_ax.plot(1e3 * time[kept], 1e-3 * force[kept], label=LABELS[role], **line_of(role))
    force_ax.set(title=f"{title}: hardest impact", xlabel="time since the model's own touch (ms)",
                 ylabel="rim force (kN)")
    draw_stiffness(k_ax, calibration, "Impact stiffness over speed")
    shared_legend(fig, (force_ax, k_ax), n_columns=3)
    return save(fig, path)
