"""The bearing to scale: section through plate, dish and rim, the slider at rest and where it touches the rim."""
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from ..bearing import TwoDishes, height, is_double_concave, value
from ..style import FAINT, FE, INK, MUTED, RIM, plt, save

STEEL, SLIDER, PAD = "#d7dee5", "#b9cfe2", "#e9d8b4"
WIDTH, DPI = 4.7, 300


LABELS = {"dish_short": "dish", "rim_short": "rim", "at_rest": "at rest", "at_touch": "at touch"}


def draw(bearing: dict[str, Any], capacity: float | None, whole: bool, path: str, labels: dict[str, str] | None = None) -> str:
    """`bearing`: the resolved [bearing] table. `capacity`: L_c [m]. `whole`: pad and foot take part and are drawn. `labels`: LABELS in
    another language. Throws ValueError where a dimension is missing."""
    size = (DoubleSection if is_double_concave(bearing) else Section)(bearing, capacity)
    fig, ax = plt.subplots(figsize=(WIDTH, WIDTH * size.aspect()), layout="constrained")
    ax.add_patch(Polygon(1e3 * size.plate(), closed=True, facecolor=STEEL, edgecolor=INK, lw=0.7, joinstyle="miter"))
    styles: tuple[tuple[float, dict[str, Any]], ...] = ((0.0, dict(facecolor="none", edgecolor=FE, ls=(0, (3, 1.6)))),
                                                        (size.capacity, dict(facecolor=SLIDER, edgecolor=FE)))
    for travel, style in styles:
        for body, fill in size.bodies(travel, whole):
            own = style | {"facecolor": fill} if fill and travel else style
            ax.add_patch(Polygon(1e3 * body, closed=True, lw=0.7, zorder=3, **own))
    _dimensions(ax, size, labels or LABELS)
    ax.set_xlim(-1e3 * size.outer - 8, 1e3 * size.right() + 8)
    low, high = size.limits()
    ax.set_ylim(1e3 * low, 1e3 * high)
    ax.set_aspect("equal")
    ax.axis("off")
    return save(fig, path, dpi=DPI)


class Section:
    """Outlines (n, 2) in m: x along the travel, z up, the vertex at the origin."""

    def __init__(self, bearing: dict[str, Any], capacity: float | None) -> None:
        self.bearing = bearing
        self.missing: list[str] = []
        self.reach = self._needed("surface", "planar_radius_mm", "reach")
        self.diameter = self._needed("slider", "diameter_mm", "diameter")
        self._stand()
        self.rim_height, self.thickness = self._needed("rim", "height_mm", "rim height"), self._needed("rim", "thickness_mm", "thickness")
        self.base = self._needed("plate", "base_mm", "base")
        if self.missing or not capacity:
            raise ValueError(f"the scene does not give {', '.join(self.missing) or 'L_c'}")
        self.capacity = capacity
        self.wall = self.reach + (value(bearing, "rim", "ledge_mm") or 0.0)
        self.outer, self.edge = self.wall + self.thickness, float(height(bearing, self.reach))

    def _needed(self, part: str, key: str, name: str) -> float:
        found = value(self.bearing, part, key)
        if found is None:
            self.missing.append(name)
        return found or 0.0

    def _stand(self) -> None:
        self.bottom, self.top = self._needed("slider", "bottom_mm", "bottom"), self._needed("slider", "top_mm", "top")

    def middle(self, travel: float) -> np.ndarray:
        """Of the slider."""
        return np.array([travel, (self.bottom + self.top) / 2 + float(height(self.bearing, travel))])

    def highest(self) -> float:
        """Of the slider where it touches."""
        return self.top + float(height(self.bearing, self.capacity))

    def right(self) -> float:
        return self.outer

    def beside_touch(self) -> float:
        """Left of what stands where the slider touches, at its top."""
        return self.capacity - self.diameter / 2

    def plate(self) -> np.ndarray:
        x = np.linspace(-self.reach, self.reach, 201)
        top = self.edge + self.rim_height
        right = [(self.wall, self.edge), (self.wall, top), (self.outer, top), (self.outer, -self.base)]
        return np.array([*zip(x, height(self.bearing, x)), *right, *((-a, b) for a, b in right[::-1])])

    def bodies(self, travel: float, whole: bool) -> list[tuple[np.ndarray, str | None]]:
        """(outline, its own colour or None) of what moves; pad and foot tilt with the surface, the slider does not."""
        lift, half = float(height(self.bearing, travel)), self.diameter / 2
        edge = min(value(self.bearing, "slider", "edge_radius_mm") or 0.0, half)
        low, high = self.bottom + lift, self.top + lift
        around = np.linspace(0, np.pi / 2, 8)
        corner = np.array([(half - edge + edge * np.sin(a), low + edge - edge * np.cos(a)) for a in around])
        right = np.vstack([corner, [(half, high)]])
        slider = np.vstack([right, right[::-1] * [-1, 1]]) + [travel, 0]
        return ([*self._foot(travel, lift)] if whole else []) + [(slider, None)]

    def _foot(self, travel: float, lift: float) -> Iterator[tuple[np.ndarray, str]]:
        names = ("radius_mm", "bottom_mm", "shoulder_mm", "cap_radius_mm"), ("outer_radius_mm", "thickness_mm")
        found = [value(self.bearing, part, name) for part, keys in zip(("foot", "pad"), names) for name in keys]
        known = [size for size in found if size is not None]
        if len(known) < len(found):
            return
        radius, bottom, shoulder, cap, pad, thick = known
        step = 1e-5
        slope = np.arctan((height(self.bearing, travel + step) - height(self.bearing, abs(travel - step))) / (2 * step)) if travel else 0.0
        turn = np.array([[np.cos(slope), np.sin(slope)], [-np.sin(slope), np.cos(slope)]])
        angle = np.linspace(np.arcsin(min(1.0, shoulder / cap)), np.pi / 2, 24)
        right = np.vstack([[(radius, bottom), (radius, shoulder)], np.column_stack([cap * np.cos(angle), cap * np.sin(angle)])])
        for outline, fill in ((np.vstack([right, right[::-1] * [-1, 1]]), SLIDER),
                              (np.array([(-pad, 0), (pad, 0), (pad, thick), (-pad, thick)]), PAD)):
            yield outline @ turn + [travel, lift], fill

    def limits(self) -> tuple[float, float]:
        return -self.base - 0.10 * self.outer, max(self.edge + self.rim_height, self.highest()) + 0.09 * self.outer

    def aspect(self) -> float:
        low, high = self.limits()
        return (high - low) / (self.outer + self.right()) * 1.02


class DoubleSection(Section):
    """Two dishes: the lower plate and its slider as they stand, the upper plate over the slider that touches."""

    def _stand(self) -> None:
        if TwoDishes.missing(self.bearing):
            self.missing += TwoDishes.missing(self.bearing)
            return
        self.two = TwoDishes(self.bearing)

    def middle(self, travel: float) -> np.ndarray:
        return self.two.middle(travel)

    def highest(self) -> float:
        return 2 * float(self.middle(self.capacity)[1]) + self.base

    def right(self) -> float:
        return self.capacity + self.outer

    def beside_touch(self) -> float:
        return self.capacity - self.outer

    def bodies(self, travel: float, whole: bool) -> list[tuple[np.ndarray, str | None]]:
        bodies: list[tuple[np.ndarray, str | None]] = [(piece, None) for piece in self.two.slider(travel)]
        if travel:
            bodies.insert(0, (2 * self.middle(travel) - self.plate(), STEEL))
        return bodies


def _dimensions(ax: Axes, s: Section, words: dict[str, str]) -> None:
    mm, level = 1e3, 1e3 * s.highest() + 0.035e3 * s.outer
    rest, touch = mm * s.middle(0.0), mm * s.middle(s.capacity)
    _arrow(ax, 0, mm * s.capacity, level, f"L$_c$ {mm * s.capacity:.4g}", RIM)
    for x in (0, mm * s.capacity):
        ax.plot([x, x], [0, level], color=MUTED, lw=0.4, ls=(0, (6, 2, 1, 2)), zorder=4)
    _arrow(ax, touch[0] - mm * s.diameter / 2, touch[0] + mm * s.diameter / 2, touch[1],
           f"Ø {mm * s.diameter:.4g}", FE)
    below = -mm * s.base - 45 * s.outer
    _arrow(ax, 0, mm * s.reach, below, f"{words['dish_short']} {mm * s.reach:.4g}", INK)
    _arrow(ax, -mm * s.outer, -mm * s.wall, below, f"{words['rim_short']} {mm * s.thickness:.4g}", INK, side=True)
    for x, z in ((0, 0), (s.reach, s.edge), (-s.outer, -s.base), (-s.wall, s.edge)):
        ax.plot([mm * x, mm * x], [below, mm * z], color=MUTED, lw=0.4, zorder=0 if z >= 0 else 1)
    x = -mm * s.wall + 18 * s.outer
    ax.annotate("", (x, mm * s.edge), (x, mm * (s.edge + s.rim_height)), arrowprops=dict(arrowstyle="<|-|>", lw=0.5, color=INK, mutation_scale=5, shrinkA=0, shrinkB=0), zorder=5)
    for z in (s.edge, s.edge + s.rim_height):
        ax.plot([-mm * s.wall, x + 10], [mm * z, mm * z], color=FAINT if z == s.edge else MUTED, lw=0.4)
    ax.text(x + 14 * s.outer, mm * (s.edge + s.rim_height / 2), f"{mm * s.rim_height:.4g}", fontsize=6.5, va="center")
    ax.text(-mm * s.diameter / 2 - 10, rest[1], words["at_rest"], fontsize=6.2, color=FE, ha="right", va="center")
    ax.text(mm * s.beside_touch() - 10, mm * s.highest(), words["at_touch"], fontsize=6.2, color=FE, ha="right", va="top")


def _arrow(ax: Axes, a: float, b: float, z: float, text: str, colour: str, side: bool = False) -> None:
    ax.annotate("", (a, z), (b, z), arrowprops=dict(arrowstyle="<|-|>", lw=0.5, color=colour, mutation_scale=5, shrinkA=0, shrinkB=0), zorder=5)
    where = dict(x=b + 12, ha="left") if side else dict(x=(a + b) / 2, ha="center")
    ax.text(y=z, s=text, va="center", fontsize=6.5, color=colour, zorder=6,
            bbox=dict(facecolor="white", edgecolor="none", pad=0.8, alpha=0.85) if not side else None, **where)
