"""Writes test-07.csv and test-08.csv as a German data logger would: semicolons, decimal commas, ms, mm with an offset, tf, noise; and both
in one file, campaign.csv, with text around the table, a row of units, 10 ms of flight before each touch, and a force 0.4 ms late.

The rim behind it is known: k_i 900,000 kN/m, F_y 650 kN, h 0.15, a 0.40 of the elastoplastic law; a fit should find them again."""
import numpy as np
import rimpact

LAW = {"reduced.impact_law": "elastoplastic", "reduced.k_i_kN_per_m": 9e5, "reduced.yield_force_kN": 650, "reduced.hardening": 0.15,
       "reduced.unloading_gain": 0.40}
random = np.random.default_rng(7)
campaign = ["Campaign 24-117;;;", "Sampled at 5 kHz;;;", "Test;Time;Travel;Force", "-;ms;mm;kN"]
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
    before = np.arange(-0.01, -1e-9, 2e-4)
    long = np.concatenate([before, time])
    travel = np.concatenate([run.displacement_x.iloc[0] + speed * before, np.interp(time, run.index, run.displacement_x)]) + random.normal(0, 3e-6, long.size)
    force = np.interp(long - 0.4e-3, run.index, run.impact_x, left=0) + random.normal(0, 2e3, long.size)
    campaign += [f"{number};{1e3 * t + 10:.1f};{1e3 * u:.4f};{f / 1e3:.3f}" for t, u, f in zip(long, travel, force)]
with open("campaign.csv", "w", encoding="utf-8") as file:
    file.write("\n".join([*campaign, "", "End of measurement;;;"]) + "\n")
