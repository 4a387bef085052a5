"""Writes test-07.csv as a German data logger would: semicolons, decimal commas, ms, mm with an offset, tf, noise.

The rim behind it is known: k_i 900,000 kN/m, F_y 650 kN, h 0.15, a 0.40 of the elastoplastic law; a fit should find them again."""
import numpy as np
import rimpact

LAW = {"reduced.impact_law": "elastoplastic", "reduced.k_i_kN_per_m": 9e5, "reduced.yield_force_kN": 650, "reduced.hardening": 0.15,
       "reduced.unloading_gain": 0.40}
random = np.random.default_rng(7)
for number, speed in ((7, 0.25), (8, 0.6)):
    motion = {"excitation.speed_m_per_s": speed, "excitation.duration_s": 0.06, "reduced.output_step_ms": 0.1}
    run = rimpact.run_reduced(rimpact.Scene("impact-window", LAW | motion)).response
    time = np.arange(0, run.index[-1], 2e-4)
    travel = 1e3 * np.interp(time, run.index, run.displacement_x) + random.normal(0, 0.003, time.size)
    force = np.interp(time, run.index, run.impact_x) / 9806.65 + random.normal(0, 0.3, time.size)
    with open(f"test-{number:02d}.csv", "w", encoding="utf-8") as file:
        file.write('sep=;\n"t";"LVDT 1";"cell"\n')
        for row in zip(1e3 * time, 12.5 - travel, force):
            file.write(";".join(f"{value:.4f}".replace(".", ",") for value in row) + "\n")
