#!/usr/bin/env python3
"""Draws docs/pictures/theory-*.svg, the figures of the theory's pages; --check compares. Schemes: true in proportion where a label says so."""
import math
import pathlib
import sys
from collections.abc import Sequence

from write_or_compare import write_or_compare

Point = tuple[float, float]
ROOT = pathlib.Path(__file__).resolve().parents[2]
STEEL, PLATE, PAD, INK, HOT, COOL = "#c9d3dd", "#dfe5ea", "#efd9b4", "#222", "#b03a2e", "#1f618d"


class Drawing:
    """An SVG whose points go through `to` first; y upwards."""

    def __init__(self, width: float, height: float, scale: float = 1.0, origin: Point = (0, 0)) -> None:
        self.size, self.scale, self.origin, self.parts = (width, height), scale, origin, list[str]()

    def to(self, x: float, y: float) -> Point:
        return round(self.origin[0] + self.scale * x, 1), round(self.origin[1] - self.scale * y, 1)

    def path(self, points: Sequence[Point], fill: str = "none", stroke: str = INK, width: float = 1.4, closed: bool = False, dash: str = "") -> None:
        d = " ".join(f"{'L' if i else 'M'}{x} {y}" for i, (x, y) in enumerate(self.to(*p) for p in points))
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<path d="{d}{" Z" if closed else ""}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"{dashed}/>')

    def circle(self, x: float, y: float, radius: float, fill: str = "none", stroke: str = INK, width: float = 1.4, dash: str = "") -> None:
        cx, cy = self.to(x, y)
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<circle cx="{cx}" cy="{cy}" r="{round(radius * self.scale, 1)}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"{dashed}/>')

    def arrow(self, a: Point, b: Point, stroke: str = INK, width: float = 1.6, both: bool = False) -> None:
        (x1, y1), (x2, y2) = self.to(*a), self.to(*b)
        self.parts.append(f'<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke="{stroke}" stroke-width="{width}"/>')
        for (px, py), (qx, qy) in [((x1, y1), (x2, y2))] + ([((x2, y2), (x1, y1))] if both else []):
            turn = math.atan2(qy - py, qx - px)
            tips = [(qx - 8 * math.cos(turn + s), qy - 8 * math.sin(turn + s)) for s in (0.4, -0.4)]
            self.parts.append(f'<path d="M{qx} {qy} L{tips[0][0]:.1f} {tips[0][1]:.1f} L{tips[1][0]:.1f} {tips[1][1]:.1f} Z" fill="{stroke}"/>')

    def text(self, x: float, y: float, words: str, anchor: str = "middle", fill: str = INK, shift: Point = (0, 0)) -> None:
        px, py = self.to(x, y)
        self.parts.append(f'<text x="{px + shift[0]}" y="{py + shift[1]}" text-anchor="{anchor}" fill="{fill}">{words}</text>')

    def label(self, at: Point, words_at: Point, words: str, anchor: str = "middle") -> None:
        self.path([at, words_at], stroke="#777", width=0.8)
        left = anchor == "start"
        self.text(*words_at, words, anchor, shift=(3 if left else -3 if anchor == "end" else 0, 4 if anchor != "middle" else 14 if words_at[1] < at[1] else -3))

    def svg(self, title: str) -> str:
        w, h = self.size
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" width="{w}" height="{h}" font-family="sans-serif" font-size="14">'
        return "\n".join([head, f"<title>{title}</title>", f'<rect width="{w}" height="{h}" fill="white"/>', *self.parts, "</svg>\n"])


def sub(letter: str, below: str) -> str:
    return f'<tspan font-style="italic">{letter}</tspan><tspan font-size="10" dy="3">{below}</tspan><tspan dy="-3">&#8203;</tspan>'


def italic(letter: str) -> str:
    return f'<tspan font-style="italic">{letter}</tspan>'


def dish(r: float) -> float:
    """Meridian of shfps-225 [mm]."""
    a, b = 562.5, 562.5**2 / 2250
    return b * (1 - math.sqrt(1 - (r / a) ** 2))


def span(a: float, b: float, n: int = 40) -> list[float]:
    return [a + (b - a) * i / n for i in range(n + 1)]


def bearing() -> str:
    """shfps-225 to scale, the slider at rest [mm]."""
    d = Drawing(760, 270, 0.6, (380, 200))
    edge = 520
    d.path([(-560, -50), (-560, dish(edge)), (-edge, dish(edge))] + [(r, dish(abs(r))) for r in span(-edge, edge, 80)]
           + [(560, dish(edge)), (560, -50)], PLATE, closed=True)
    for side in (-1, 1):
        d.path([(side * x, y) for x, y in [(edge, dish(edge)), (edge, dish(edge) + 60), (560, dish(edge) + 60), (560, dish(edge))]], STEEL, HOT, 1.8, True)
    d.path([(r, dish(abs(r))) for r in span(-70, 70)] + [(70, 20), (-70, 20)] if dish(70) > 20 else
           [(r, dish(abs(r))) for r in span(-70, 70)] + [(70, 40), (-70, 40)], PAD, closed=True)
    cap = [(90 * math.sin(t), 6.5 + 90 * math.cos(t)) for t in span(1.271, -1.271)]
    socket = [(90 * math.sin(t), 6.5 + 90 * math.cos(t)) for t in span(0.958, -0.958)]
    d.path([(86, 20), (86, 33)] + cap[1:-1] + [(-86, 33), (-86, 20), (-70, 20), (-70, 40), (70, 40), (70, 20)], "#aebdcb", closed=True)
    d.path([(120, 58.25)] + socket + [(-120, 58.25), (-120, 158.25), (120, 158.25)], STEEL, closed=True)
    d.label((0, 130), (0, 205), "upper slider, with the supported mass")
    d.label((-60, 70), (-190, 150), "foot, in its socket", "end")
    d.label((-45, 25), (-215, 95), "pad", "end")
    d.label((538, 130), (480, 205), "rim")
    d.label((300, dish(300)), (270, 70), "dish")
    d.text(-400, -15, "plate", shift=(0, 4))
    d.arrow((120, 125), (520, 125), HOT, both=True)
    d.text(255, 135, sub("L", "c"), fill=HOT)
    return d.svg("Section of the bearing shfps-225 to scale, the slider at rest")


def gap() -> str:
    """Plan: slider in the ring of the rim, pressed into it at one place; the penetration is enlarged."""
    d = Drawing(600, 360, 1.0, (200, 180))
    wall, slider, turn, deep = 160, 75, 0.45, 12
    travel = wall - slider + deep
    c = (travel * math.cos(turn), travel * math.sin(turn))
    d.circle(0, 0, wall + 16, STEEL)
    d.circle(0, 0, wall, "white", HOT, 1.8)
    d.circle(0, 0, slider, dash="5 4", stroke="#888", width=1)
    d.circle(*c, slider, "#c9d3ddb0")
    d.circle(0, 0, wall, stroke=HOT, width=1.2, dash="3 3")
    d.arrow((0, 0), c, COOL, 2)
    d.text(c[0] * 0.45, c[1] * 0.45, f"{italic('u')}, |{italic('u')}| = {italic('r')}", fill=COOL, shift=(-36, -10))
    across = (-math.sin(turn), math.cos(turn))
    d.arrow(c, (c[0] + 48 * across[0], c[1] + 48 * across[1]))
    d.text(c[0] + 48 * across[0], c[1] + 48 * across[1], italic("s"), "start", shift=(6, -2))
    d.text(205, 0, f"{italic('s')} is counted along the wall", "start")
    hit = ((wall + 2) * math.cos(turn), (wall + 2) * math.sin(turn))
    d.label(hit, (205, 60), f"{italic('d')} = {italic('r')} − {sub('L', 'c')} &gt; 0", "start")
    d.label((wall * math.cos(-0.8), wall * math.sin(-0.8)), (205, -105), "rim's wall", "start")
    d.label((slider * math.cos(-2.2), slider * math.sin(-2.2)), (-70, -115), "slider at rest")
    push = (c[0] - 62 * math.cos(turn), c[1] - 62 * math.sin(turn))
    d.arrow((c[0] + 60 * math.cos(turn), c[1] + 60 * math.sin(turn)), (push[0] + 62 * math.cos(turn), push[1] + 62 * math.sin(turn)), HOT, 2)
    d.text(c[0], c[1], italic("F"), fill=HOT, shift=(34, 6))
    return d.svg("Slider and rim seen from above: travel, gap and penetration")


def law() -> str:
    """Elastoplastic loop and the pair of the same first slope, in x = k d / F_y and F / F_y."""
    h, p, a, m, w = 0.156, 0.75, 0.38, 0.5, 0.5
    c = 1 - h

    def load(x: float) -> float:
        return c * x / math.hypot(1, c * x) + h * ((1 + x) ** p - 1) / p
    deep = 9.0
    top = load(deep)
    length = (1 + w) * top / (1 + a * deep**m)

    def back(x: float) -> float:
        s = 1 - (deep - x) / length
        return top * ((1 - w) * s + w * s * s)
    d = Drawing(620, 340, 46, (60, 290))
    left = deep - length
    d.path([(x, load(x) * 2.2) for x in span(0, deep)] + [(x, 2.2 * back(x)) for x in span(deep, left)], "#f5e3e0", HOT, 2.2, False)
    d.path([(deep, 2.2 * load(deep)), *[(x, 2.2 * load(x)) for x in span(deep, 11.4)]], stroke=HOT, width=1.6, dash="6 4")
    d.arrow((0, 0), (12, 0))
    d.arrow((0, 0), (0, 6.1))
    d.text(12, 0, italic("d"), shift=(-4, 20))
    d.text(0, 6.1, italic("F"), shift=(-14, 10))
    d.path([(0, 0), (2.4, 2.2 * 2.4)], stroke="#777", width=1, dash="4 3")
    d.text(2.4, 5.3, italic("k"), shift=(8, 4))
    d.path([(0, 2.2), (11.4, 2.2)], stroke="#999", width=0.9, dash="2 3")
    d.text(0, 2.2, sub("F", "y"), "end", shift=(-6, 4))
    d.path([(deep, 0), (deep, 2.2 * top)], stroke="#999", width=0.9, dash="2 3")
    d.text(deep, 0, italic("D"), shift=(0, 18))
    d.text(left, 0, f"{italic('D')} − {italic('l')}", shift=(0, 18))
    d.arrow((left, 0.35), (deep, 0.35), COOL, 1.2, True)
    d.text((left + deep) / 2 + 0.3, 0.35, italic("l"), fill=COOL, shift=(16, -6))
    d.text(4.2, 1.2, "lost in the rim", fill=HOT)
    d.text(4.3, 2.2 * load(4.3), "first loading", fill=HOT, shift=(-10, -12))
    d.text(deep - 1.0, 2.6, "return", "end", fill=HOT)
    return d.svg("Force over penetration of the elastoplastic law: first loading, return, dent")


def return_map() -> str:
    """Plane of the friction traction: a trial beyond the circle is brought back onto it, one inside stays."""
    d = Drawing(560, 320, 1.0, (180, 170))
    d.circle(0, 0, 110, "#eef3f7")
    d.arrow((-150, 0), (165, 0), "#888", 1)
    d.arrow((0, -140), (0, 150), "#888", 1)
    turn = 0.6
    trial, back = (200 * math.cos(turn), 200 * math.sin(turn)), (110 * math.cos(turn), 110 * math.sin(turn))
    start = (40, -45)
    d.path([start, trial], stroke="#777", dash="4 3")
    d.arrow(trial, back, HOT, 2)
    d.arrow((0, 0), back, COOL, 2)
    d.circle(*start, 3, INK)
    d.circle(*trial, 3, INK)
    d.circle(*back, 3, COOL, COOL)
    d.text(*start, sub("λ", "T"), "start", shift=(8, 12))
    d.text(*trial, "trial <tspan font-weight='bold'>t</tspan>*, outside: slips", "start", shift=(8, 4))
    d.text(*back, "<tspan font-weight='bold'>t</tspan>", "end", fill=COOL, shift=(-12, 4))
    d.arrow((0, 0), (110 * math.cos(2.4), 110 * math.sin(2.4)), "#555", 1.2)
    d.text(110 * math.cos(2.4) / 2, 110 * math.sin(2.4) / 2, f"{italic('μp')}", shift=(6, -10))
    stick = (-50, -60)
    d.circle(*stick, 3, INK)
    d.label(stick, (-85, -128), "inside: sticks, stays")
    return d.svg("Return map of friction in the plane of the tangential traction")


FIGURES = {"theory-bearing": bearing, "theory-gap": gap, "theory-law": law, "theory-return-map": return_map}


def main(*options: str) -> int:
    made = {ROOT / "docs/pictures" / f"{name}.svg": draw() for name, draw in FIGURES.items()}
    return write_or_compare(made, options, "docs/generate/figures.py draws; run it")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
