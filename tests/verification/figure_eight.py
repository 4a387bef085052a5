#!/usr/bin/env python3
"""VERIFICATION 11, both directions: the figure-eight (0.31 m a side) of rung rigid-dish, whole model, mesh 1, against the quasi-static
reduced model with the terms of the finite pad and the socket. The path's eighths are listed apart: at its corners it turns
faster than the socket's friction, which follows the direction of motion only after some 20 mm, as the closed form does not know.

Errors are vectors' lengths, over the closed form's largest force. Gates: root mean square over the loop but for the hundredth at either end (44 mm), where the slider
sets out and stops, 2 %; lift within 0.1 mm; imbalance below 1e-3. Runs kept in FOLDER are not repeated. usage: figure_eight.py RIMPACT FOLDER"""
import pathlib
import sys

import numpy as np
from kept_run import finish, gate, kept_run
from static_loops import TERMS

LEFT_OUT = 0.01  # of the path's parameter, at both ends


def loop(program, verb, folder, settings, options=()):
    summary = kept_run(program, verb, "static-figure-eight", folder, settings, options)
    table = np.genfromtxt(folder / "response.csv", delimiter=",", names=True)
    return summary, table[np.concatenate([[True], np.diff(table["time_s"]) > 0])]


def main(program, folder):
    folder = pathlib.Path(folder)
    summary, fe = loop(program, "run", folder / "rigid-dish", [], ["--no-fields"])
    _, closed = loop(program, "reduced", folder / "closed", TERMS)
    t = fe["time_s"]
    force, theory, lift = (np.column_stack([np.interp(t, table["time_s"], table[name]) for name in names])
                           for table, names in ((fe, ("Fx_N", "Fy_N")), (closed, ("Fx_N", "Fy_N")), (closed, ("uz_m",))))
    largest = np.linalg.norm(theory, axis=1).max()
    error = np.linalg.norm(force - theory, axis=1) / largest
    rise = fe["uz_m"] - lift[:, 0]
    inner = (t > LEFT_OUT) & (t < 1 - LEFT_OUT)

    lines, failures = ["part of the loop  steps  error_rms_%  error_max_%  lift_error_max_mm"], []
    for eighth in range(8):
        part = (t >= eighth / 8) & (t < (eighth + 1) / 8) & inner
        lines.append(f"{eighth / 8:5.3f} to {(eighth + 1) / 8:5.3f} {part.sum():8d} {100 * np.sqrt(np.mean(error[part] ** 2)):12.2f} "
                     f"{100 * error[part].max():12.2f} {1e3 * np.abs(rise[part]).max():18.3f}")
    rms = np.sqrt(np.trapz(error[inner] ** 2, t[inner]) / (t[inner][-1] - t[inner][0]))
    lines.append(f"# whole loop: {100 * rms:.2f} % (RMS) of {largest / 1e3:.1f} kN; {summary['n_dofs']} unknowns, {summary['n_steps']} steps, "
                 f"{summary['n_newton_iterations']} Newton iterations, {summary['cuts']} cuts, {summary['wall_time_s']:.0f} s, "
                 f"{summary['peak_memory_bytes'] / 1e9:.2f} GB, imbalance {summary['energy']['imbalance_relative']:.1e}")
    gate(failures, "force over the loop (RMS)", rms, 0.02)
    gate(failures, "lift [m]", np.abs(rise[inner]).max(), 1e-4)
    gate(failures, "imbalance", summary["energy"]["imbalance_relative"], 1e-3)
    return finish(folder, lines, failures)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
