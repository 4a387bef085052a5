"""Pictures for notebooks; they need matplotlib."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rimpact.laws import Law
    from rimpact.results import Run


def draw_run(run: Run, path: str | os.PathLike | None = None) -> Figure:
    """Displacement and rim force over time, and the loop along the axis that moves more."""
    from matplotlib.figure import Figure
    response = run.response
    axis = max("xy", key=lambda each: float(response[f"displacement_{each}"].abs().max()))
    displacement = 1e3 * response[f"displacement_{axis}"]
    figure = Figure(figsize=(7.2, 4.2), layout="constrained")
    panels = figure.subplot_mosaic([["u", "loop"], ["F", "loop"]])
    panels["u"].plot(response.index, displacement, lw=1.0)
    panels["u"].set(ylabel=f"displacement {axis} (mm)")
    panels["F"].plot(response.index, -1e-3 * response[f"impact_{axis}"], lw=1.0, color="#a3123a")
    panels["F"].set(xlabel="time (s)", ylabel="force on the rim (kN)")
    panels["loop"].plot(displacement, -1e-3 * response[f"force_{axis}"], lw=1.0)
    panels["loop"].set(xlabel=f"displacement {axis} (mm)", ylabel="lateral force (kN)")
    if path is not None:
        figure.savefig(path)
    return figure


def draw_law(law: Law, path: str | os.PathLike | None = None) -> Figure:
    """Force over penetration up to the depth that is known: first loading, and the way back from five depths."""
    from matplotlib.figure import Figure
    deepest = law.known_depth[0]
    figure = Figure(figsize=(4.2, 3.0), layout="constrained")
    ax = figure.subplots()
    depths = np.linspace(0, deepest, 400)
    ax.plot(1e3 * depths, 1e-3 * np.asarray(law(depths)), lw=1.4, label="first loading")
    if law.yields:
        for share in (0.2, 0.4, 0.6, 0.8, 1.0):
            back = np.linspace(0, share * deepest, 200)
            ax.plot(1e3 * back, 1e-3 * np.asarray(law(back, deepest=np.full_like(back, share * deepest))), lw=0.7, color="#66727f")
    ax.set(xlabel="penetration (mm)", ylabel="force of the rim (kN)", title=f"{law.name}, known to {1e3 * deepest:.3g} mm")
    if path is not None:
        figure.savefig(path)
    return figure
