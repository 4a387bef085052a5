#!/usr/bin/env python3
"""`impact-window` in GetFEM: the slider thrown at the rim that it touches, without weight and friction. Writes a CSV.

In time by Bossak's method (1981), M ((1 - a) x''_1 + a x''_0) + f(x_1) = 0 with Newmark's x_1, x'_1 of beta = (1 - a)^2 / 4, gamma = 1/2 - a;
a = -1/3 leaves half of what a step does not resolve, as ours (rho_inf = 0.5).  mm, N, MPa, t, s; half a bearing.
usage: window_getfem.py MESH.msh SCENE.toml OUT.csv [--step MS]"""
import argparse
import pathlib
import sys
import time
import tomllib

import getfem as gf
import numpy as np
from push_getfem import steel_of
from rim_model import GROUPS, Contact, Mesh, RimModel

BOSSAK = -1 / 3
BETA, GAMMA = (1 - BOSSAK) ** 2 / 4, 0.5 - BOSSAK
SMALLEST = 1e-3  # of a step, where Newton's method fails


class Window:
    """Speeds and accelerations by unknown; the masses of both bodies, and what the top carries beside the slider [t]."""

    def __init__(self, rim: RimModel, density: float, mass: float, speed: float) -> None:
        self.rim, self.time, self.iterations, self.steps, self.cuts = rim, 0.0, 0, 0, 0
        model, slider = rim.model, rim.slider
        own = density * float(gf.asm_generic(slider.full, 0, "1", -1, model))
        area = float(gf.asm_generic(slider.full, 0, "1", GROUPS["top"], model))
        model.add_initialized_data("pace", [1.0])  # (1 - a) / (beta dt^2)
        for body in (rim.rim, slider):
            model.add_fem_data("h" + body.u, body.space)
            model.add_nonlinear_term(body.full, f"{density}*(pace*{body.u}-h{body.u}).Test_{body.u}")
        model.add_initialized_data("hway", [0.0])
        model.add_nonlinear_term(slider.full, f"{(mass - own) / area:.17g}*(pace*way-hway)*Test_way", GROUPS["top"])
        self.names = ("ur", "us", "way")
        self.speed = {name: np.zeros_like(model.variable(name)) for name in self.names}
        self.acceleration = {name: np.zeros_like(model.variable(name)) for name in self.names}
        self.speed["us"][0::3], self.speed["way"][:] = speed, speed

    def advance(self, step: float) -> None:
        """By one step, in halves where Newton's method fails."""
        before, model = self.rim.state(), self.rim.model
        pace = (1 - BOSSAK) / (BETA * step ** 2)
        ahead = {name: before[name] + step * self.speed[name] + (0.5 - BETA) * step ** 2 * self.acceleration[name] for name in self.names}
        model.set_variable("pace", [pace])
        for name in self.names:
            model.set_variable("h" + name, pace * ahead[name] - BOSSAK * self.acceleration[name])
            model.set_variable(name, before[name] + step * self.speed[name])
        report = self.rim.solve()
        self.iterations += report.iterations
        if not report.converged:
            self.rim.put(before)
            self.cuts += 1
            if self.cuts > 1 / SMALLEST:
                raise RuntimeError(f"Newton's method fails at {1e3 * self.time:.3f} ms in steps of {1e3 * step:.2g} ms")
            self.advance(step / 2), self.advance(step / 2)
            return
        for name in self.names:
            now = (model.variable(name) - ahead[name]) / (BETA * step ** 2)
            self.speed[name] = self.speed[name] + step * ((1 - GAMMA) * self.acceleration[name] + GAMMA * now)
            self.acceleration[name] = now
        self.rim.accept()
        self.time, self.steps = self.time + step, self.steps + 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=pathlib.Path), parser.add_argument("scene", type=pathlib.Path), parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--step", type=float, default=0.5, help="ms"), parser.add_argument("--stiffness", type=float, default=1e5)
    options = parser.parse_args()
    gf.util_trace_level(0), gf.util_warning_level(0)
    start = time.process_time()
    scene = tomllib.loads(options.scene.read_text())
    bearing, steel = scene["bearing"], steel_of(scene["bearing"])
    rim = RimModel(Mesh(options.mesh, False), steel, Contact(options.stiffness, friction=bearing["contact"]["rim"]), free=True)
    window = Window(rim, steel.density, 1e-3 * scene["load"]["mass_kg"] / 2, 1e3 * scene["excitation"]["speed_m_per_s"])
    touched = False
    with open(options.out, "w") as file:
        print("time_s,travel_mm,speed_mm_s,force_kN,iterations,processor_s", file=file)
        while window.time < scene["excitation"]["duration_s"]:
            window.advance(1e-3 * options.step)
            force = -2e-3 * rim.force()[0]
            print(f"{window.time:.9g},{rim.model.variable('way')[0]:.9g},{window.speed['way'][0]:.9g},{force:.9g},{window.iterations},{time.process_time() - start:.4g}", file=file,
                  flush=True)
            touched = touched or force > 0
            if touched and force == 0 and window.speed["way"][0] < 0:
                break
    print(f"{rim.model.nbdof()} unknowns, {window.steps} steps, {window.iterations} iterations, {window.cuts} cuts; plastic work {2e-3 * (rim.rim.work() + rim.slider.work()):.0f} J, "
          f"largest strain {max(rim.rim.largest_strain(), rim.slider.largest_strain()):.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
