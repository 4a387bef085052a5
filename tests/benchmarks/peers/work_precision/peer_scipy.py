"""peer_scipy.py PROBLEM.json TOLERANCE...: SciPy's Radau on the plain Park-Wen form (problem.cc in Python).

Prints a JSON line for each tolerance: seconds and the displacements at the output instants."""
import json
import math
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp


def ground_of(p):
    if "pulse" in p:
        pulse = p["pulse"]

        def ground(t):
            w = math.pi * (t - pulse["centre"]) / pulse["period"]
            return pulse["amplitude"] * (1 - 2 * w * w) * math.exp(-w * w), 0.0

        return ground
    dt, ax, ay = p["record_dt"], p["record_x"], p["record_y"]

    def sampled(t):
        k = min(int(t / dt), len(ax) - 2)
        s = t / dt - k
        return ax[k] + s * (ax[k + 1] - ax[k]), ay[k] + s * (ay[k + 1] - ay[k])

    return sampled


def rhs_of(p):
    R0, a, m, W, mu, q = (p[key] for key in ("R0", "a", "mass", "weight", "mu", "slip"))
    k, c, capacity, ground = p["k_i"], p["c_i"], p["capacity"], ground_of(p)

    def rhs(t, state):
        x, y, vx, vy, ex, ey = state
        r = math.hypot(x, y)
        s = math.sqrt(1 - r * r / (a * a))
        slope = 1 / (R0 * s)
        bend = slope / (a * a * s * s)
        gx, gy = slope * x, slope * y
        S = math.sqrt(1 + gx * gx + gy * gy)
        ax, ay = ground(t)
        Fx, Fy, xv = -m * ax, -m * ay, x * vx + y * vy
        if r > capacity:
            push = (k * (r - capacity) + c * xv / r) / r
            Fx, Fy = Fx - push * x, Fy - push * y
        curvature = slope * (vx * vx + vy * vy) + bend * xv * xv
        N = (m * curvature + gx * Fx + gy * Fy + W) / S
        e2, ez = ex * ex + ey * ey, gx * ex + gy * ey
        rub = mu * math.sqrt(e2 / (e2 + ez * ez)) if e2 > 0 else 0.0
        work = max(0.0, ex * vx + ey * vy)
        return (vx, vy, (Fx - N * gx / S - N * rub * ex) / m, (Fy - N * gy / S - N * rub * ey) / m,
                (vx - work * ex) / q, (vy - work * ey) / q)

    return rhs


def main():
    with open(sys.argv[1]) as file:
        problem = json.load(file)
    n = round(problem["duration"] / problem["output_step"])
    instants = np.minimum(problem["output_step"] * np.arange(n + 1), problem["duration"])
    for tolerance in map(float, sys.argv[2:]):
        begin = time.process_time()
        run = solve_ivp(rhs_of(problem), (0, problem["duration"]), np.zeros(6), method="Radau", rtol=tolerance,
                        atol=tolerance, max_step=0.01, t_eval=instants)
        seconds = time.process_time() - begin
        if not run.success:
            sys.exit("Radau: " + run.message)
        print(json.dumps({"tolerance": tolerance, "seconds": seconds, "x": list(run.y[0]), "y": list(run.y[1])}))


main()
