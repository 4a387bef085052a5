"""Curves that can be zoomed in the page: what the script plot.js draws over a figure's picture. Without the script, and in print,
the picture stands."""
import base64
import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from markupsafe import Markup

from .run_folder import Run
from .series import contact_stretches, impact_curve
from .style import FE, FITTED, RIM, line_of

MOST = 4000        #: samples kept of one curve
TOLERANCE = 2e-4   #: of a signal's range, by which what is left out may depart from the straight line between its neighbours


@dataclass
class Line:
    label: str
    x: np.ndarray
    y: np.ndarray
    colour: str = FE
    dash: str = ""    #: canvas dashes, "4 2"
    width: float = 1.5


@dataclass
class Panel:
    title: str
    x: str            #: name and unit of the axis
    y: str
    lines: list[Line] = field(default_factory=list)
    over: bool = True   #: y is a function of x, so that y follows the range of x
    levels: list[float] = field(default_factory=list)   #: of x or y (`mark`), drawn dotted
    mark: str = "y"
    group: str = ""     #: panels of one group share the range of x
    equal: bool = False  #: one unit is as long along y as along x


def kept(columns: Sequence[np.ndarray], most: int = MOST) -> np.ndarray:
    """Indices of the samples that tell a curve: those left out lie within TOLERANCE of the lines between the kept."""
    values = np.column_stack([np.asarray(c, float) / max(np.ptp(c), 1e-300) for c in columns])
    n = len(values)
    chosen, waiting, place = {0, n - 1}, [(0, n - 1)], np.linspace(0.0, 1.0, n) if n > 1 else np.zeros(n)
    time = np.asarray(columns[0], float)
    place = time if np.all(np.diff(time) > 0) else place
    while waiting:
        first, last = waiting.pop(0)
        if last - first < 2 or len(chosen) >= most:
            continue
        share = ((place[first:last + 1] - place[first]) / (place[last] - place[first]))[:, None]
        off = np.abs(values[first:last + 1] - values[first] - share * (values[last] - values[first])).max(axis=1)
        worst = int(np.argmax(off))
        if off[worst] > TOLERANCE:
            chosen.add(first + worst)
            waiting += [(first, first + worst), (first + worst, last)]
    return np.array(sorted(chosen))


def _packed(values: np.ndarray) -> str:
    return base64.b64encode(np.asarray(values, "<f4").tobytes()).decode()


def data(panels: list[Panel]) -> Markup | None:
    """The panels as JSON for the page; None where nothing is drawn."""
    shown = [panel for panel in panels if panel.lines]
    if not shown:
        return None
    said = [{"title": p.title, "x": p.x, "y": p.y, "over": p.over, "levels": p.levels, "mark": p.mark, "group": p.group, "equal": p.equal,
             "lines": [{"label": line.label, "colour": line.colour, "dash": line.dash, "width": line.width, "x": _packed(line.x),
                        "y": _packed(line.y)} for line in p.lines]} for p in shown]
    return Markup(json.dumps(said, allow_nan=False).replace("<", "\\u003c"))


def style_of(role: str) -> dict[str, Any]:
    """What line_of() says, in the canvas's words."""
    said = line_of(role)
    dash = said.get("ls", "-")
    return {"colour": said["color"], "width": said["lw"] + 0.3, "dash": "" if isinstance(dash, str) else " ".join(str(3 * d) for d in dash[1])}


def response(models: list[tuple[str, Run]], labels: dict[str, str], capacity: float | None) -> list[Panel]:
    """The panels of figures/response_panels.py."""
    planar = all(run.is_planar() for _, run in models)
    time = models[0][1].time_label
    limit = [1e3 * capacity] if capacity else []
    both = [level for value in limit for level in (value, -value)]
    names = ["x", "y"] if not planar else [""]
    u = Panel("Lateral displacement" + ("" if planar else ", norm"), time, "displacement u (mm)", levels=both if planar else limit, group="t")
    f = Panel("Lateral force" + ("" if planar else ", norm"), time, "lateral force −F (kN)", group="t")
    loops = [Panel("Loop" + (f" in {n}" if n else ""), f"displacement u{n} (mm)", f"lateral force −F{n} (kN)", over=False, levels=both, mark="x")
             for n in names]
    z = Panel("Vertical displacement", time, "uz (mm), up positive", group="t")
    path = Panel("Path in plan", "ux (mm)", "uy (mm)", over=False, equal=True)
    for role, run in models:
        _add_response(u, f, loops, path, z, run, dict(label=labels[role], **style_of(role)), models[0][1].direction() if planar else None)
    if path.lines and limit:
        angle = np.linspace(0, 2 * np.pi, 181)
        path.lines.append(Line("L_c", limit[0] * np.cos(angle), limit[0] * np.sin(angle), RIM, "2 3", 1.0))
    return [u, f, *loops, path, z]


def _add_response(u: Panel, f: Panel, loops: list[Panel], path: Panel, z: Panel, run: Run, style: dict[str, Any], direction: np.ndarray | None) -> None:
    zero = np.zeros_like(run.time)
    if direction is not None:
        way = [1e3 * run.along("displacement", direction)]
        force = [-1e-3 * run.along("force", direction) if run.has("force_x", "force_y") else zero]
    else:
        way = [1e3 * run.signals[f"displacement_{axis}"] for axis in "xy"]
        force = [-1e-3 * run.signals[f"force_{axis}"] if run.has(f"force_{axis}") else zero for axis in "xy"]
    up = 1e3 * run.signals["displacement_z"] if run.has("displacement_z") else zero
    at = kept([run.time, *way, *force, up])
    t, up, way, force = run.time[at], up[at], [w[at] for w in way], [p[at] for p in force]
    u.lines.append(Line(x=t, y=way[0] if len(way) == 1 else np.hypot(*way), **style))
    f.lines.append(Line(x=t, y=force[0] if len(force) == 1 else np.hypot(*force), **style))
    for loop, w, p in zip(loops, way, force):
        loop.lines.append(Line(x=w, y=p, **style))
    if len(way) == 2:
        path.lines.append(Line(x=way[0], y=way[1], **style))
    if run.has("displacement_z"):
        z.lines.append(Line(x=t, y=up, **style))


def impacts(models: list[tuple[str, Run]], labels: dict[str, str], most: int = 4) -> list[Panel]:
    """The panels of figures/impacts.py."""
    panels = []
    stretches = [(role, run, contact_stretches(run)) for role, run in models]
    for row in range(min(most, max((len(parts) for *_, parts in stretches), default=0))):
        over_time = Panel(f"Impact {row + 1}: force over time", "time since the model's own touch (ms)", "rim force (kN)")
        over_depth = Panel(f"Impact {row + 1}: force over penetration", "penetration (mm)", "rim force (kN)", over=False)
        for role, run, parts in stretches:
            if row >= len(parts):
                continue
            time, force, depth = impact_curve(run, parts[row])
            at = kept([time, force, depth])
            over_time.lines.append(Line(labels[role], 1e3 * time[at], 1e-3 * force[at], **style_of(role)))
            over_depth.lines.append(Line(labels[role], 1e3 * depth[at], 1e-3 * force[at], **style_of(role)))
        panels += [over_time, over_depth]
    return panels


def over_time(run: Run, shown: Sequence[tuple[str, float, str, str]]) -> list[Panel]:
    """Both horizontal directions of signals NAME_x and NAME_y, as (name, factor, title, axis)."""
    panels = []
    for name, factor, title, label in shown:
        panel = Panel(title, run.time_label, label, group="t")
        for axis, colour in (("x", FE), ("y", FITTED)):
            values = run.signals.get(f"{name}_{axis}")
            if values is not None and (axis == "x" or np.any(values != 0)):
                at = kept([run.time, values])
                panel.lines.append(Line(axis, run.time[at], factor * values[at], colour))
        panels.append(panel)
    return panels
