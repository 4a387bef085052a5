"""What the bearing carries: drift of the first storey, the roof, the storey shear, the roof's acceleration."""
import numpy as np

from ..run_folder import Run
from ..style import FE, FITTED, MUTED, figure, save, shared_legend

PANELS = (("drift", 1e3, "First storey's drift", "drift (mm)"), ("roof", 1e3, "Roof, relative to the base", "displacement (mm)"),
          ("storey_shear", 1e-3, "First storey's shear on the base", "force (kN)"),
          ("roof_acceleration", 1 / 9.80665, "Roof's acceleration, absolute", "acceleration (g)"))


def draw(run: Run, path: str) -> str | None:
    """None when the run stores none of these signals."""
    shown = [panel for panel in PANELS if run.has(f"{panel[0]}_x", f"{panel[0]}_y")]
    if not shown:
        return None
    fig, grid = figure(-(-len(shown) // 2), 2, 0.4 + 1.85 * -(-len(shown) // 2))
    for ax in grid.flat[len(shown):]:
        ax.axis("off")
    for ax, (name, factor, title, label) in zip(grid.flat, shown):
        for axis, colour in (("x", FE), ("y", FITTED)):
            values = factor * run.signals[f"{name}_{axis}"]
            if axis == "x" or np.any(np.abs(values) > 1e-9 * max(1e-12, np.abs(factor * run.signals[f"{name}_x"]).max())):
                ax.plot(run.time, values, color=colour, lw=0.9, label=axis)
        ax.set(title=title, xlabel=run.time_label, ylabel=label)
        ax.margins(x=0)
        ax.axhline(0, color=MUTED, lw=0.4, zorder=0)
    shared_legend(fig, grid.flat[:len(shown)])
    return save(fig, path)
