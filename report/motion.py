"""python3 -m report.motion CSV PNG: a ground motion over time. Columns: time, acceleration and, where known,
velocity and displacement; SI unless the column's name ends in _g (acceleration in g)."""
import argparse

import numpy as np
from matplotlib.figure import Figure

from .data_files import read_table
from .errors import DataError, run_main
from .style import FE, MUTED, RIM, figure, save

GRAVITY = 9.81
PANELS = (("acceleration", 1 / GRAVITY, "acceleration (g)", "PGA", "g"),
          ("velocity", 1e2, "velocity (cm/s)", "PGV", "cm/s"),
          ("displacement", 1e2, "displacement (cm)", "PGD", "cm"))


def read(path: str) -> dict[str, np.ndarray]:
    """{"time": ..., "acceleration": ...} in SI."""
    names, table = read_table(path)
    if len(table) < 2 or not np.all(np.isfinite(table)):
        raise DataError(f"{path} needs at least two rows of finite numbers")
    columns = {}
    for name, values in zip(names, table.T):
        base = name.lower().split("_")[0]
        columns[base] = values * (GRAVITY if base == "acceleration" and name.endswith("_g") else 1.0)
    if "time" not in columns or "acceleration" not in columns:
        raise DataError(f"{path} needs the columns time and acceleration, and has {', '.join(names)}")
    return columns


def draw(columns: dict[str, np.ndarray], path: str) -> Figure | str:
    shown = [panel for panel in PANELS if panel[0] in columns]
    fig, grid = figure(len(shown), 1, 0.4 + 1.4 * len(shown), sharex=True)
    for ax, (name, factor, label, peak_name, unit) in zip(grid[:, 0], shown):
        values = factor * columns[name]
        top = int(np.argmax(np.abs(values)))
        ax.plot(columns["time"], values, color=FE, lw=0.8)
        ax.plot(columns["time"][top], values[top], "o", ms=3.5, color=RIM)
        ax.annotate(f"{peak_name} {abs(values[top]):.3g} {unit} at {columns['time'][top]:.2f} s",
                    (columns["time"][top], values[top]), xytext=(5, 0), textcoords="offset points", va="center",
                    fontsize=6.5, color=RIM)
        ax.axhline(0, color=MUTED, lw=0.4)
        ax.set_ylabel(label)
        ax.margins(x=0, y=0.12)
    grid[-1, 0].set_xlabel("time (s)")
    return save(fig, path)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.motion", description=__doc__.splitlines()[0])
    parser.add_argument("csv")
    parser.add_argument("png")
    options = parser.parse_args(arguments)
    draw(read(options.csv), options.png)


if __name__ == "__main__":
    run_main(main, "motion")
