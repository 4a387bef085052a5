#!/usr/bin/env python3
"""A window and a push of rung rim by an explicit program of another formulation, on our mesh, against ours.

Its cells have 8 nodes: the vertices of ours, or with --divided all 27, eight cells for one. A run of ours is made by RIMPACT.
usage: explicit_rim.py RIMPACT PROGRAM FOLDER [--mesh 0] [--divided] [--speed 0.3 | --push] [--friction MU] [--rate-D PER_SECOND] [--step SECONDS] [--ours MESH ...]"""
import argparse
import csv
import json
import math
import pathlib
import resource
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

DEPTHS = np.arange(0.5, 8.01, 0.5)  # mm
EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7))
FACES = ((0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7))
CORNERS = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))
Cell = Sequence[int]


def lattice() -> dict[tuple[int, ...], int]:
    """Place in 0..2 of each of a cell's 27 nodes, in gmsh's order: corners, edges, faces, centre."""
    places = [np.array(corner) for corner in CORNERS]
    groups = (*((a,) for a in range(8)), *EDGES, *FACES, tuple(range(8)))
    return {tuple(int(v) for v in sum(places[a] for a in group) // len(group)): index for index, group in enumerate(groups)}


PLACES = lattice()


class Mesh:
    """Nodes [mm], cells of 8 nodes and of all 27 by volume, quadrilaterals by group."""

    def __init__(self, file: pathlib.Path, divided: bool) -> None:
        lines = iter(file.read_text().splitlines())
        names: dict[tuple[int, int], str] = {}
        nodes: dict[int, np.ndarray] = {}
        self.cells: dict[str, list[list[int]]] = {}
        self.whole: dict[str, list[list[int]]] = {}
        quads: list[tuple[str, frozenset[int]]] = []
        for line in lines:
            if line == "$PhysicalNames":
                for _ in range(int(next(lines))):
                    dimension, tag, name = next(lines).split()
                    names[int(dimension), int(tag)] = name.strip('"')
            elif line == "$Nodes":
                for _ in range(int(next(lines))):
                    tag, *x = next(lines).split()
                    nodes[int(tag)] = 1e3 * np.array(x, float)
            elif line == "$Elements":
                for _ in range(int(next(lines))):
                    kind, n_tags, group, *rest = map(int, next(lines).split()[1:])
                    own = rest[n_tags - 1:]
                    if len(own) >= 8:
                        self.cells.setdefault(names[3, group], []).extend(parts(own) if divided else [own[:8]])
                    else:
                        quads.append((names[2, group], frozenset(own[:4])))
                    if len(own) == 27:
                        self.whole.setdefault(names[3, group], []).append(own)
                        self.remember(own)
        self.nodes, self.quads = nodes, quads
        self.divided = divided

    faces_of: dict[frozenset[int], list[int]] = {}

    def remember(self, cell: Cell) -> None:
        """The 9 nodes of each face by its corners."""
        for axis in range(3):
            for end in (0, 2):
                own = [index for place, index in PLACES.items() if place[axis] == end]
                self.faces_of[frozenset(cell[i] for i in own if i < 8)] = [cell[i] for i in own]

    def nodes_on(self, group: str) -> set[int]:
        found: set[int] = set()
        for name, corners in self.quads:
            if name == group:
                found |= set(self.faces_of[corners]) if self.divided else corners
        return found

    def faces(self, group: str, volumes: Sequence[str]) -> list[list[int]]:
        """Faces of cells whose nodes are all in the group, counter-clockwise from outside."""
        on, found = self.nodes_on(group), []
        for cell in (cell for volume in volumes for cell in self.cells[volume]):
            middle = np.mean([self.nodes[n] for n in cell], axis=0)
            for face in FACES:
                own = [cell[i] for i in face]
                if not on.issuperset(own):
                    continue
                x = [self.nodes[n] for n in own]
                out = np.dot(np.cross(x[2] - x[0], x[3] - x[1]), np.mean(x, axis=0) - middle)
                found.append(own if out > 0 else own[::-1])
        return found


def parts(cell: Cell) -> list[list[int]]:
    """The eight cells between a cell's 27 nodes."""
    return [[cell[PLACES[i + a // 2, j + b // 2, k + c // 2]] for a, b, c in CORNERS] for i in (0, 1) for j in (0, 1) for k in (0, 1)]


def held(mesh: Mesh) -> list[tuple[int, np.ndarray]]:
    """What does not move: the fixed face; the plane of symmetry across it; of the sector's cuts the inner one radially, the end one around."""
    fixed, top, cuts, symmetry = (mesh.nodes_on(group) for group in ("fixed", "top", "sector_end", "symmetry"))
    radius = {n: math.hypot(*mesh.nodes[n][:2]) for n in cuts - fixed}
    inner, widest = min(radius.values()), max(math.atan2(mesh.nodes[n][1], mesh.nodes[n][0]) for n in cuts)
    ways = [(n, way) for n in fixed for way in np.eye(3)] + [(n, np.array([0.0, 1.0, 0.0])) for n in symmetry - top]
    for n, r in radius.items():
        x, y = mesh.nodes[n][:2] / r
        if r < inner + 1e-3:
            ways.append((n, np.array([x, y, 0.0])))
        if abs(math.atan2(y, x) - widest) < 1e-9:
            ways.append((n, np.array([-y, x, 0.0])))
    return ways


def write_deck(file: pathlib.Path, mesh: Mesh, numbers: dict[str, float]) -> None:
    fixed_part = sorted({n for volume in ("plate", "rim") for cell in mesh.cells[volume] for n in cell})
    slider = sorted({n for cell in mesh.cells["upper_slider"] for n in cell})
    index = {n: i for i, n in enumerate([*fixed_part, *slider])}
    numbers["slider_begins"] = len(fixed_part)
    words = [f"number {name} {value:.12g}" for name, value in numbers.items()]
    words += [f"node {' '.join(f'{v:.12g}' for v in mesh.nodes[n])}" for n in index]
    words += [f"cell {' '.join(str(index[n]) for n in cell)}" for cells in mesh.cells.values() for cell in cells]
    for name, group, volumes in (("slider", "slider_side", ["upper_slider"]), ("wall", "rim_wall", ["rim"])):
        words += [f"{name} {' '.join(str(index[n]) for n in face)}" for face in mesh.faces(group, volumes)]
    words += [f"top {index[n]}" for n in sorted(mesh.nodes_on("top"))]
    words += [f"held {index[n]} {' '.join(f'{v:.12g}' for v in way)}" for n, way in held(mesh) if n in index]
    file.write_text("\n".join(words) + "\n")


def numbers_of(options: argparse.Namespace) -> dict[str, float]:
    E, nu, tangent = 200000.0, 0.3, 1450.0
    push_time = 0.04
    return {"shear": E / 2 / (1 + nu), "bulk": E / 3 / (1 - 2 * nu), "yield": 360.0, "hardening": tangent / (1 - tangent / E), "density": 7.85e-9, "mass": 86.952 / 2,
            "speed": 1e3 * options.speed, "step": options.step, "contact": 4 * E / 6, "friction": options.friction, "damping": 300.0 if options.push else 0.0,
            "duration": push_time * 0.75 if options.push else options.duration, "push_time": push_time if options.push else 0.0, "travel": 8.0, "half_width": 562.5, "height": 140.625,
            "capacity": 400.0, "rate_D": options.rate_D, "rate_q": 5.0}


@dataclass
class Run:
    """Whole bearing: travel [mm] and force [kN] while it presses, rebound over the approach (windows), processor seconds, words on its size."""
    name: str
    travel: np.ndarray
    force: np.ndarray
    rebound: float | None
    seconds: float
    note: str

    def at_depths(self) -> np.ndarray:
        deepest = int(np.argmax(self.travel))
        return np.where(DEPTHS <= self.travel[deepest], np.interp(DEPTHS, self.travel[:deepest + 1], self.force[:deepest + 1]), np.nan)


def timed(words: Sequence[Any]) -> tuple[str, float]:
    """What it prints, and its processor time [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def settings_of(options: argparse.Namespace, mesh: int) -> list[str]:
    settings = [f"model.mesh={mesh}", f"bearing.contact.rim={options.friction}", *([] if options.push else [f"excitation.speed_m_per_s={options.speed}"]),
                *(['bearing.material.steel.rate="cowper-symonds"', f"bearing.material.steel.rate_D_per_s={options.rate_D}"] if options.rate_D else [])]
    return [word for setting in settings for word in ("--set", setting)]


def explicit(options: argparse.Namespace, scene: str) -> Run:
    mesh_file, deck, out = (options.folder / f"{scene}-{options.mesh}{suffix}" for suffix in (".msh", ".deck", ".csv"))
    timed([options.rimpact, "mesh", "--scene", scene, "--curved", "-o", mesh_file, "--quiet", *settings_of(options, options.mesh)])
    write_deck(deck, Mesh(mesh_file, options.divided), numbers_of(options))
    said, seconds = timed([options.program, deck, out])
    return of_rows(options, out, seconds, said.strip())


def kept(options: argparse.Namespace, scene: str) -> Run:
    """The same, not run again where the program is older than what it wrote."""
    out = options.folder / f"{scene}-{options.mesh}.csv"
    if out.exists() and out.stat().st_mtime > pathlib.Path(options.program).stat().st_mtime:
        return of_rows(options, out, math.nan, "")
    return explicit(options, scene)


def of_rows(options: argparse.Namespace, out: pathlib.Path, seconds: float, note: str) -> Run:
    with open(out) as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    rebound = None if options.push else -rows[-1]["speed_mm_s"] / 1e3 / options.speed
    return Run(f"explicit, mesh {options.mesh}{' divided' if options.divided else ''}", np.array([row["travel_mm"] for row in rows]),
               np.array([-2e-3 * row["contact_N"] for row in rows]), rebound, seconds, note)


def ours(options: argparse.Namespace, scene: str, mesh: int) -> Run:
    folder = options.folder / f"ours-{scene}-{mesh}"
    length = [] if options.push else ["--set", f"excitation.duration_s={options.duration}"]
    _, seconds = timed([options.rimpact, "run", scene, "-o", folder, "--quiet", "--no-fields", "--force", *settings_of(options, mesh), *length])
    summary = json.loads((folder / "summary.json").read_text())
    with open(folder / "response.csv") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    rebound = None if options.push else summary["impacts"][0]["restitution"]
    return Run(f"ours, mesh {mesh}", np.array([-1e3 * row["gap_m"] for row in rows]), np.array([-1e-3 * row["Fx_N"] for row in rows]), rebound, seconds,
               f"unknowns {summary['n_dofs']} steps {summary['n_steps']}")


def missed(own: Run, other: Run, gate: Sequence[float]) -> int:
    """1 where peak force, depth (relative) or rebound (over the approach) are further apart than the gate."""
    off = [own.force.max() / other.force.max() - 1, own.travel.max() / other.travel.max() - 1, (own.rebound or 0) - (other.rebound or 0)]
    for what, value, bound in zip(("peak force", "depth", "rebound"), off, gate):
        print(f"{what} {100 * value:+.2f} %" + ("" if abs(value) <= bound else f": MISSED, not within {100 * bound:g} %"))
    return int(any(abs(value) > bound for value, bound in zip(off, gate)))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rimpact"), parser.add_argument("program"), parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--mesh", type=int, default=0), parser.add_argument("--divided", action="store_true"), parser.add_argument("--push", action="store_true")
    parser.add_argument("--speed", type=float, default=0.3), parser.add_argument("--friction", type=float, default=0.0), parser.add_argument("--step", type=float, default=2e-7)
    parser.add_argument("--rate-D", type=float, default=0.0, help="the steel's, of Cowper and Symonds with q = 5; 0: knows no rate")
    parser.add_argument("--duration", type=float, default=0.045), parser.add_argument("--ours", type=int, nargs="*", default=[], help="meshes of runs of ours beside it")
    parser.add_argument("--gate", type=float, nargs=3, default=(0.04, 0.07, 0.01), help="peak force, depth, rebound")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    scene = "rim-push" if options.push else "impact-window"
    own = explicit(options, scene)
    runs = [own, *(ours(options, scene, mesh) for mesh in options.ours)]
    print(f"{scene}, friction of the rim {options.friction:g}" + ("" if options.push else f", {options.speed:g} m/s"))
    for run in runs:
        back = "" if run.rebound is None else f"  rebound {run.rebound:.4f}"
        print(f"{run.name:<26} peak {run.force.max():7.1f} kN  depth {run.travel.max():6.3f} mm{back}  {run.seconds:7.1f} s  {run.note}")
    print("depth_mm " + " ".join(f"{run.name:>26}" for run in runs))
    for i, depth in enumerate(DEPTHS):
        values = [run.at_depths()[i] for run in runs]
        if not any(math.isnan(value) for value in values):
            print(f"{depth:8.2f} " + " ".join(f"{value:26.1f}" for value in values) + "".join(f" {100 * (values[0] / value - 1):+7.2f} %" for value in values[1:]))
    return max((missed(own, run, options.gate) for run in runs[1:]), default=0)


if __name__ == "__main__":
    sys.exit(main())
