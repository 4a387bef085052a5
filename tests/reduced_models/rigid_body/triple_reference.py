"""triple_reference.py RIMPACT FOLDER: a triple pendulum against all its rims, beside SciPy's LSODA on equations of its own.

The sliders are a chain of three pendulums here: the centres of the spheres hang on each other, three turns are all the unknowns. Nothing of contact
points, gaps or normal springs is in it; friction is a moment at each centre, smoothed at small speed, and rims push by virtual work. No edge can lift
here, so the pulse is one in which none does. Exit code 77 without SciPy."""
import json
import math
import subprocess
import sys

try:
    import numpy as np
    from scipy.integrate import solve_ivp
except ImportError:
    print("skipped: SciPy is not installed")
    sys.exit(77)

G, MASS, AMPLITUDE, PERIOD, CENTRE, END = 9.81, 13345e3 / 9.81, 0.372, 2.4, 4.8, 6.5
R, H = (3.9624, 0.5588, 0.5588, 3.9624), (0.2159, 0.1651, 0.1651, 0.2159)  # [m], from the ground up
HALF, TRAVEL = (0.3555, 0.254, 0.254, 0.3555), (0.53336, 0.1016, 0.1016, 0.53336)
MU = (0.04, 0.012, 0.012, 0.06)  # of the faces
SLIDERS = ((320.0, 0.711, H[0] - H[1]), (350.0, 0.508, H[1] + H[2]), (320.0, 0.711, H[3] - H[2]))  # mass, diameter, height
K_RIM, E, AT, SPEED = 1e9, 0.65, 0.4, 2e-5  # the rim's law; speed [m/s] below which friction is smoothed

EFF = [r - h for r, h in zip(R, H)]
LENGTH = np.array([EFF[0] - EFF[1], EFF[1] + EFF[2], EFF[3] - EFF[2]])
PHI = [math.asin(a / r) for a, r in zip(HALF, R)]
WALL = [r * math.sin(math.asin(d / r) + p) for r, d, p in zip(R, TRAVEL, PHI)]
#: Turn of each face by the three bodies' turns, and the body whose axis its points lie about.
FACE = np.array([[1, 0, 0], [-1, 1, 0], [0, 1, -1], [0, 0, 1]], float)
POINTS = (0, 1, 1, 2)


def dissipation() -> float:
    """chi of K d (1 + chi d'), by which an impact at AT returns E: d' goes from AT to -E AT on one loop, in closed form."""
    low, high = 1e-6, 1 / (E * AT) * (1 - 1e-12)
    for _ in range(200):  # chi (1 + E) v = ln((1 + chi v) / (1 - chi E v))
        chi = (low + high) / 2
        rest = math.log((1 + chi * AT) / (1 - chi * E * AT)) - chi * (1 + E) * AT
        low, high = (chi, high) if rest < 0 else (low, chi)
    return chi


CHI = dissipation()


def ground(t: float) -> float:
    p = (math.pi * (t - CENTRE) / PERIOD) ** 2
    return AMPLITUDE * G * (1 - 2 * p) * math.exp(-p)


def bodies() -> list[tuple[float, np.ndarray, float]]:
    """(mass, lever of each turn at the mass's centre, inertia and its turn) of sliders and plate; a lever l puts the centre at l (sin, -cos)."""
    (m1, d1, h1), (m2, d2, h2), (m3, d3, h3) = SLIDERS
    across = lambda m, d, h: m * (d * d / 16 + h * h / 12)
    return [(m1, np.array([R[0] - h1 / 2, 0, 0]), across(m1, d1, h1)), (m2, np.array([LENGTH[0], EFF[1], 0]), across(m2, d2, h2)),
            (m3, np.array([LENGTH[0], LENGTH[1], LENGTH[2] - (R[3] - h3 / 2)]), across(m3, d3, h3)), (MASS, LENGTH, 0.0)]


BODIES = bodies()


def rims(a: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, list[float]]:
    """Generalised forces of the four rims, and each one's force."""
    force, sizes = np.zeros(3), []
    turn, rate = FACE @ a, FACE @ v
    for i in range(4):
        side = math.copysign(1, turn[i])
        angle = abs(turn[i]) + PHI[i]
        d, arm = R[i] * math.sin(angle) - WALL[i], R[i] * math.cos(angle)
        size = max(0.0, K_RIM * d * (1 + CHI * arm * side * rate[i])) if d > 0 else 0.0
        force -= size * arm * side * FACE[i]
        sizes.append(size)
    return force, sizes


def accelerations(t: float, a: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Of the turns."""
    s, c = np.sin(a), np.cos(a)
    M, base = np.zeros((3, 3)), np.zeros(3)
    for k, (mass, lever, inertia) in enumerate(BODIES):
        jx, jz = lever * c, lever * s  # of x = l sin, z = -l cos
        M += mass * (np.outer(jx, jx) + np.outer(jz, jz))
        if k < 3:
            M[k, k] += inertia
        ax, az = -(lever * s) @ v**2, (lever * c) @ v**2
        base -= mass * (jx * (ax + ground(t)) + jz * (az + G))
    base += rims(a, v)[0]
    slide = np.tanh(FACE @ v * np.array(R) / SPEED)
    F, W = 0.0, MASS * G  # of the mass on the chain: along x, and down
    for _ in range(30):  # friction goes by the load, and the load by the acceleration
        moment = np.zeros(3)
        for i in range(4):
            turn, z = a[POINTS[i]], slide[i]
            along, across = W * math.cos(turn) + F * math.sin(turn), F * math.cos(turn) - W * math.sin(turn)
            moment -= MU[i] * R[i] * z * (along + MU[i] * z * across) / (math.cos(PHI[i]) * (1 + MU[i] ** 2)) * FACE[i]
        acc = np.linalg.solve(M, base + moment)
        before = F, W
        F = -MASS * ((LENGTH * c) @ acc - (LENGTH * s) @ v**2 + ground(t))
        W = MASS * ((LENGTH * s) @ acc + (LENGTH * c) @ v**2 + G)
        if abs(F - before[0]) + abs(W - before[1]) < 1e-9 * MASS * G:
            break
    return acc


def reference() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Instants, displacement x, largest rim force of each face."""
    rates = lambda t, y: np.concatenate([y[3:], accelerations(t, y[:3], y[3:])])
    run = solve_ivp(rates, (0, END), np.zeros(6), method="LSODA", rtol=1e-7, atol=1e-10, max_step=5e-3)
    if not run.success:
        raise RuntimeError(run.message)
    forces = np.array([rims(y[:3], y[3:])[1] for y in run.y.T])
    return run.t, LENGTH @ np.sin(run.y[:3]), forces


def ours(program: str, folder: str) -> tuple[np.ndarray, np.ndarray, dict]:
    settings = {"excitation.amplitude_g": AMPLITUDE, "excitation.period_s": PERIOD, "excitation.centre_s": CENTRE, "excitation.duration_s": END,
                "load.vertical_kN": MASS * G / 1e3, "load.mass_kg": MASS, "reduced.mu_fast": MU[0], "reduced.mu_slow": MU[0],
                "reduced.k_i_kN_per_m": K_RIM / 1e3, "reduced.restitution": E, "reduced.reference_speed_m_per_s": AT, "isolator.mu_of": '"faces"',
                "isolator.inner.mu_fast": MU[1], "isolator.inner.mu_slow": MU[1], "isolator.top_mu_fast": MU[3], "isolator.top_mu_slow": MU[3],
                "isolator.contact_stiffness_kN_per_m": 1e9, "isolator.inner.rim_height_mm": 200, "isolator.rim_height_mm": 200}
    words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([program, "reduced", "tfp-pulse", "-o", folder, "--force", "--quiet", *words], check=True)
    with open(folder + "/response.csv") as file:
        header = file.readline().strip().split(",")
        table = np.array([[float(x) for x in line.split(",")[:2]] for line in file])
    assert header[:2] == ["time_s", "ux_m"], header
    with open(folder + "/summary.json") as file:
        return table[:, 0], table[:, 1], json.load(file)


def main(program: str, folder: str) -> int:
    t, u, forces = reference()
    mine_t, mine, summary = ours(program, folder)
    assert summary["status"] == "done", summary.get("reason")
    peak = np.abs(u).max()
    apart = np.abs(np.interp(t, mine_t, mine) - u).max()
    print(f"displacement: {1e3 * np.abs(mine).max():.2f} mm, LSODA {1e3 * peak:.2f} mm; farthest apart {1e3 * apart:.2f} mm")
    failed = abs(np.abs(mine).max() / peak - 1) > 0.005 or apart > 0.01 * peak
    least = min(point["min_N"] for point in summary["isolator"]["point_forces"].values())
    print(f"least normal force of a point: {least / 1e3:.0f} kN")
    failed |= not least > 0
    for i, face in enumerate(summary["isolator"]["faces"]):
        theirs = forces[:, i].max()
        touched = t[np.argmax(forces[:, i] > 0)] if theirs > 0 else math.nan
        print(f"rim {i + 1}: {face['rim_peak_force_N'] / 1e3:.1f} kN from {face['rim_touched_s']} s, LSODA {theirs / 1e3:.1f} kN from {touched:.4f} s")
        failed |= not theirs > 0 or abs(face["rim_peak_force_N"] / theirs - 1) > 0.01 or abs(face["rim_touched_s"] - touched) > 0.005
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
