"""superstructure_reference.py RIMPACT FOLDER: the four-degrees-of-freedom model against SciPy's Radau.

The equations are written anew here for motion along x (base on the ellipse, rim, Park-Wen friction, Bouc-Wen frame,
axial spring); touch and release are terminal events. Exit code 77 without SciPy."""
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

R0, A, L_C, W, M, G = 2.25, 0.5625, 0.40, 853e3, 86952.0, 9.81
MU, SLIP, K_I, E = 0.07, 1e-3, 4.5e8, 0.65
GAMMA, T_S, XI, U_Y, R_H, T_V, XI_V = 0.7, 0.6, 0.02, 0.0186, 0.10, 0.1, 0.02
SCALE, T_P, CENTRE, END = 1.2, 1.0, 2.0, 8.0

m_s, m_b = GAMMA * M, (1 - GAMMA) * M
w, w_v = 2 * math.pi / T_S, 2 * math.pi / T_V
log_e = math.log(E)
c_i = 2 * (-log_e / math.hypot(math.pi, log_e)) * math.sqrt(K_I * M)
U, V, ETA, X, XV, ZS, ZV, Z = range(8)


def ground(t):
    p = (math.pi * (t - CENTRE) / T_P) ** 2
    return SCALE * 0.78 * G * (1 - 2 * p) * math.exp(-p)


def dish(u):
    b, root = A * A / R0, math.sqrt(1 - (u / A) ** 2)
    return b - b * root, b * u / (A * A * root), b / (A * A * root**3)


def parts(t, y, pressed):
    h, g, h2 = dish(y[U])
    lateral = -(R_H * w * w * m_s * (y[X] - y[U]) + (1 - R_H) * w * w * m_s * U_Y * y[Z] + 2 * XI * w * m_s * (y[XV] - y[V]))
    axial = -(w_v**2 * m_s * (y[ZS] - h) + 2 * XI_V * w_v * m_s * (y[ZV] - g * y[V]))
    side = math.copysign(1, y[U])
    rim = K_I * (abs(y[U]) - L_C) + c_i * side * y[V] if pressed else 0.0
    fx, fz = -m_b * ground(t) - lateral - side * rim, -W - axial
    s = math.sqrt(1 + g * g)
    normal = (m_b * h2 * y[V] ** 2 + g * fx - fz) / s
    return lateral, axial, rim, fx, g, s, normal


def rates(t, y, pressed):
    lateral, axial, _, fx, g, s, normal = parts(t, y, pressed)
    drift_rate = y[XV] - y[V]
    turning = y[Z] * drift_rate
    d = np.empty(8)
    d[U] = y[V]
    d[V] = (fx - normal * g / s - MU * y[ETA] * normal / s) / m_b
    d[ETA] = (y[V] - y[ETA] * max(0.0, y[ETA] * y[V])) / SLIP
    d[X], d[XV] = y[XV], lateral / m_s - ground(t)
    d[ZS], d[ZV] = y[ZV], axial / m_s
    d[Z] = (drift_rate - y[Z] * 0.5 * (abs(turning) + turning)) / U_Y
    return d


def integrate():
    t, y, pressed = 0.0, np.zeros(8), False
    peaks = {"displacement": 0.0, "drift": 0.0, "impact": 0.0, "normal": 1e99}
    n_impacts = 0
    while t < END:
        edge = lambda t, y, pressed: L_C - abs(y[U])
        edge.terminal, edge.direction = True, 1 if pressed else -1
        run = solve_ivp(rates, (t, END), y, method="Radau", rtol=1e-9, atol=1e-11, events=edge, args=(pressed,),
                        max_step=0.01, dense_output=True)
        for t_i in np.unique(np.concatenate([run.t, np.linspace(t, run.t[-1], 1 + int((run.t[-1] - t) / 2e-4))])):
            at = run.sol(t_i)
            _, _, rim, _, _, _, normal = parts(t_i, at, pressed)
            peaks["displacement"] = max(peaks["displacement"], abs(at[U]))
            peaks["drift"] = max(peaks["drift"], abs(at[X] - at[U]))
            peaks["impact"], peaks["normal"] = max(peaks["impact"], rim), min(peaks["normal"], normal)
        t, y = run.t[-1], run.y[:, -1]
        if run.status == 1:
            n_impacts += not pressed
            pressed = not pressed
    peaks["residual"] = abs(y[X] - y[U])
    return peaks, n_impacts


def ours(program, folder):
    settings = {"reduced.friction": '"park-wen"', "reduced.elastic_slip_mm": SLIP * 1e3, "reduced.mu_fast": MU,
                "reduced.mu_slow": MU, "excitation.scale": SCALE, "superstructure.mass_ratio": GAMMA,
                "bearing.slider.diameter_mm": 240.0, "reduced.tolerance": 1e-10, "excitation.duration_s": END}
    arguments = [argument for key, value in settings.items() for argument in ("--set", f"{key}={value}")]
    subprocess.run([program, "reduced", "frame-four-dof", "-o", folder, "--quiet", *arguments], check=True)
    return json.load(open(folder + "/summary.json"))


def main(program, folder):
    reference, n_impacts = integrate()
    summary = ours(program, folder)
    frame = summary["superstructure"]["storeys"][0]
    pairs = [("peak displacement, m", summary["peak_displacement_m"], reference["displacement"], 1e-6),
             ("peak drift, m", frame["peak_drift_m"], reference["drift"], 1e-5),
             ("residual drift, m", frame["residual_drift_m"], reference["residual"], 1e-4),
             ("peak impact force, N", summary["peak_impact_force_N"], reference["impact"], 1e-4),
             ("smallest normal force, N", summary["min_normal_force_N"], reference["normal"], 1e-3)]
    print(f"{'':26} {'rimpact':>14} {'SciPy Radau':>14} {'relative':>10}")
    wrong = summary["n_impacts"] != n_impacts
    for name, mine, other, bound in pairs:
        error = abs(mine - other) / abs(other)
        wrong |= not error < bound
        print(f"{name:26} {mine:14.8g} {other:14.8g} {error:10.1e}{'' if error < bound else f'  above {bound:g}'}")
    print(f"impacts {summary['n_impacts']} and {n_impacts}; normal force stays positive: {reference['normal'] > 0}")
    if reference["normal"] <= 0:
        print("the reference knows no uplift: lower SCALE")
        wrong = True
    return 1 if wrong or n_impacts == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
