#!/usr/bin/env python3
"""`rim-push` in GetFEM: the slider's top pressed beyond first touch along the dish, and back until the walls part. Writes a CSV.

usage: push_getfem.py MESH.msh SCENE.toml OUT.csv [--steps N] [--multipliers DEGREE] [--locked]"""
import argparse
import math
import pathlib
import sys
import time
import tomllib
from typing import Any

import getfem as gf
from rim_model import Contact, Mesh, RimModel
from steel import Steel

FIRST, SMALLEST, GROWTH, FEW, DRAWN = 0.02, 1e-4, 1.6, 8, 1.2  # steps of travel [mm]; iterations after which they grow; way back at most


class Dish:
    """The ellipse that the slider rises on beyond its travel, of a scene.toml that a run of ours wrote [mm]."""

    def __init__(self, bearing: dict[str, Any]) -> None:
        surface = bearing["surface"]
        if surface["kind"] != "ellipse":
            raise ValueError(f"surface.kind is {surface['kind']}; this push knows the ellipse only")
        self.half_width = 1e3 * surface["a_m"]
        self.height = self.half_width ** 2 / (1e3 * surface["R0_m"])
        self.capacity = surface["planar_radius_mm"] + bearing["rim"]["ledge_mm"] - bearing["slider"]["diameter_mm"] / 2

    def rise(self, travel: float) -> float:
        """From first touch on."""
        height = lambda r: self.height * (1 - math.sqrt(1 - (r / self.half_width) ** 2))
        return height(self.capacity + travel) - height(self.capacity)


def steel_of(bearing: dict[str, Any]) -> Steel:
    numbers = bearing["material"]["steel"]
    return Steel(numbers["E_MPa"], numbers["nu"], numbers["yield_MPa"], numbers["tangent_modulus_MPa"], 1e-12 * numbers["density_kg_per_m3"])


class Push:
    def __init__(self, rim: RimModel, dish: Dish, travel: float, largest: float) -> None:
        self.rim, self.dish, self.deepest, self.largest = rim, dish, travel, largest
        self.travel, self.step, self.way = 0.0, FIRST, 1
        self.last: tuple[dict, float] | None = None
        self.iterations = self.cuts = self.steps = 0

    def advance(self) -> None:
        """One step, cut until it converges; begun as the last one went on."""
        before = self.rim.state()
        while True:
            aim = min(self.travel + self.way * self.step, self.deepest)
            if self.last:
                self.rim.put({name: values + (aim - self.travel) / self.last[1] * self.last[0][name] for name, values in before.items()})
            self.rim.model.set_variable("target", [aim, 0.0, self.dish.rise(aim)])
            report = self.rim.solve()
            self.iterations += report.iterations
            if report.converged:
                break
            self.rim.put(before)
            self.step, self.last, self.cuts = self.step / 2, None, self.cuts + 1
            if self.step < SMALLEST:
                raise RuntimeError(f"no equilibrium beyond {self.travel:.4f} mm: Newton's method fails in steps of {SMALLEST} mm")
        self.last = ({name: values - before[name] for name, values in self.rim.state().items()}, aim - self.travel)
        self.rim.accept()
        self.travel, self.steps = aim, self.steps + 1
        if report.iterations <= FEW:
            self.step = min(self.largest if self.way > 0 else self.largest / 2, GROWTH * self.step)

    def turn(self) -> None:
        self.way, self.step, self.last = -1, 2 * FIRST, None


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=pathlib.Path), parser.add_argument("scene", type=pathlib.Path), parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--steps", type=int, default=24, help="of the whole way, at least")
    parser.add_argument("--multipliers", type=int, default=0), parser.add_argument("--stiffness", type=float, default=1e5)
    parser.add_argument("--locked", action="store_true", help="the volume's part at all points")
    options = parser.parse_args()
    gf.util_trace_level(0), gf.util_warning_level(0)
    start = time.process_time()
    scene = tomllib.loads(options.scene.read_text())
    bearing, travel = scene["bearing"], scene["excitation"]["travel_mm"] * scene["excitation"]["scale"]
    rim = RimModel(Mesh(options.mesh, False), steel_of(bearing), Contact(options.stiffness, options.multipliers, bearing["contact"]["rim"]), 5 if options.locked else 3)
    push = Push(rim, Dish(bearing), travel, travel / options.steps)
    with open(options.out, "w") as file:
        print("travel_mm,force_kN,lift_kN,iterations,processor_s", "0,0,0,0,0", sep="\n", file=file)
        while True:
            push.advance()
            fx, _, fz = rim.force()
            print(f"{push.travel:.9g},{-2e-3 * fx:.9g},{2e-3 * fz:.9g},{push.iterations},{time.process_time() - start:.4g}", file=file, flush=True)
            if push.way > 0 and push.travel >= travel - 1e-9:
                push.turn()
            elif push.way < 0 and (abs(fx) < 1 or push.travel < travel - DRAWN):
                break
    strain = max(rim.rim.largest_strain(), rim.slider.largest_strain())
    print(f"{rim.model.nbdof()} unknowns, {push.steps} steps, {push.iterations} iterations, {push.cuts} cuts; plastic work {2e-3 * (rim.rim.work() + rim.slider.work()):.0f} J, "
          f"largest strain {strain:.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
