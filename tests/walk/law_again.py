"""Laws of the rim typed in here once more, an impact flown by a Runge-Kutta method, and a fit of a yielding law to windows: nothing of the program is in it."""
import math
from collections.abc import Callable

Law = Callable[[float, float, float], float]  #: force [N] at penetration [m], its rate [m/s], deepest so far [m]
Impact = dict[str, float]  #: in the units of the record's table


def yielding(n: dict[str, float]) -> Law:
    """Of laws `elastoplastic` (docs/theory/rim.md) and `bilinear`; n in kN and m."""
    k, f_y, h = n["k_i"] * 1e3, n["yield_force"] * 1e3, n["hardening"]

    def loading(d: float) -> float:
        x = k * d / f_y
        if "unloading_gain" not in n:
            return k * d if x <= 1 else f_y * (1 + h * (x - 1))
        p, c = n["hardening_exponent"], (1 - h) * x
        return f_y * (c / math.hypot(1, c) + h * ((1 + x) ** p - 1) / p)

    def force(d: float, _: float, deepest: float) -> float:
        if d >= deepest:
            return loading(d)
        top = loading(deepest)
        if "unloading_gain" not in n:
            return top - k * (deepest - d)
        slope = k * (1 + n["unloading_gain"] * (k * deepest / f_y) ** n["unloading_exponent"])
        w = min(0.5, slope * deepest / top - 1)
        s = 1 - (deepest - d) * slope / ((1 + w) * top)
        return top * s * (1 - w + w * max(0.0, s))
    return force


def damping(k: float, e: float, mass: float) -> float:
    """2 xi sqrt(k m), xi = -ln e / sqrt(pi^2 + ln^2 e) [N s/m]."""
    return -2 * math.log(e) / math.hypot(math.pi, math.log(e)) * math.sqrt(k * mass)


def pair(k: float, e: float, mass: float) -> Law:
    """Of law `no-tension`; k in N/m."""
    c = damping(k, e, mass)
    return lambda d, rate, _: max(0.0, k * d + c * rate)


def flown(law: Law, mass: float, speed: float, h: float = 2e-6) -> Impact:
    """A weightless impact, by Nystroem's method of three evaluations."""
    d, v, t, deepest, peak = 0.0, speed, 0.0, 0.0, 0.0
    while t < 1.0:
        k1 = -law(d, v, deepest) / mass
        middle = d + h * v / 2 + h * h * k1 / 8
        k2 = -law(middle, v + h * k1 / 2, max(deepest, middle)) / mass
        end = d + h * v + h * h * k2 / 2
        k3 = -law(end, v + h * k2, max(deepest, end)) / mass
        d, v, t = d + h * v + h * h * (k1 + 2 * k2) / 6, v + h * (k1 + 4 * k2 + k3) / 6, t + h
        deepest = max(deepest, d)
        force = law(d, v, deepest)
        peak = max(peak, force)
        if v < 0 and force <= 0:
            break
    return {"peak_force_kN": peak / 1e3, "penetration_mm": 1e3 * deepest, "contact_time_ms": 1e3 * t, "restitution": -v / speed}


def _solved(matrix: list[list[float]], right: list[float]) -> list[float]:
    """By elimination with pivots."""
    rows = [[*row, value] for row, value in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        best = max(range(i, n), key=lambda j: abs(rows[j][i]))
        rows[i], rows[best] = rows[best], rows[i]
        for j in range(i + 1, n):
            share = rows[j][i] / rows[i][i]
            rows[j] = [a - share * b for a, b in zip(rows[j], rows[i])]
    found = [0.0] * n
    for i in reversed(range(n)):
        found[i] = (rows[i][n] - sum(rows[i][j] * found[j] for j in range(i + 1, n))) / rows[i][i]
    return found


def fitted(numbers: dict[str, float], free: list[str], windows: list[tuple[float, Impact]], mass: float, steps: int = 6) -> dict[str, float]:
    """`free` of `numbers` so that peak, depth and rebound of the windows (speed, impact) are met to 1 %, by Gauss and Newton over logarithms."""
    coarse, difference = 2e-5, 1e-3
    now = dict(numbers)

    def misfits(n: dict[str, float]) -> list[float]:
        law = yielding(n)
        own = [flown(law, mass, speed, coarse) for speed, _ in windows]
        return [(a[key] / b[key] - 1) / 0.01 for a, (_, b) in zip(own, windows) for key in ("peak_force_kN", "penetration_mm", "restitution")]
    for _ in range(steps):
        here = misfits(now)
        columns = [[(a - b) / difference for a, b in zip(misfits({**now, name: now[name] * math.exp(difference)}), here)] for name in free]
        normal = [[sum(a * b for a, b in zip(one, two)) for two in columns] for one in columns]
        step = _solved(normal, [-sum(a * b for a, b in zip(one, here)) for one in columns])
        now.update({name: now[name] * math.exp(max(-0.5, min(0.5, change))) for name, change in zip(free, step)})
    return now
