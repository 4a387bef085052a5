"""degrading_loop.py DEGRADING_LOOP: force and lost energy of the degrading law against SciPy's integration of the equations,
written down apart. Exit 77: no SciPy."""
import subprocess
import sys

import numpy as np

try:
    from scipy.integrate import solve_ivp
except ImportError:
    print("no SciPy")
    sys.exit(77)

F_Y, D_Y, R, N, BETA, NU, ETA = 350, 0.003, 0.04, 1.5, 0.7, 0.03, 0.08


def path(t):
    return 0.004 * t * np.sin(2 * t)


def rates(t, y):
    z, e = y
    speed = 0.004 * (np.sin(2 * t) + 2 * t * np.cos(2 * t)) / D_Y
    lost = (1 + NU * e) * abs(z) ** N * (BETA * abs(speed * z) + (1 - BETA) * speed * z)
    resisted = (1 + NU * e) * abs(z) ** (N - 1) * (BETA * abs(speed) * z + (1 - BETA) * speed * abs(z))
    return [(speed - resisted) / (1 + ETA * e), lost]


rows = np.array([line.split() for line in subprocess.run(sys.argv[1], check=True, capture_output=True, text=True).stdout.splitlines()], float)
t, d, force, energy = rows.T
answer = solve_ivp(rates, (0, t[-1]), [0, 0], t_eval=t, rtol=1e-10, atol=1e-12, max_step=1e-3)
z, e = answer.y
expected = R * F_Y / D_Y * path(t) + (1 - R) * F_Y * z
force_error, energy_error = np.abs(force - expected).max() / F_Y, np.abs(energy - e).max() / e[-1]
print(f"lost energy {e[-1]:.1f} F_y d_y, strength left {(1 + NU * e[-1]) ** (-1 / N):.2f}; errors: force {force_error:.1e} F_y, energy {energy_error:.1e}")
sys.exit(0 if force_error < 1e-3 and energy_error < 1e-3 and np.abs(d - path(t)).max() < 1e-9 else 1)
