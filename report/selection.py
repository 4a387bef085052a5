"""python3 -m report.selection CSV PNG: spectra of selected records, their mean and the target. Columns: period_s, target_g,
mean_g, then one a record."""
import argparse

import numpy as np

from .data_files import read_table
from .errors import DataError, run_main
from .style import FE, MUTED, RIM, figure, save


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.selection", description=__doc__.splitlines()[0])
    parser.add_argument("csv")
    parser.add_argument("png")
    options = parser.parse_args(arguments)
    names, table = read_table(options.csv)
    if names[:3] != ["period_s", "target_g", "mean_g"] or not np.all(np.isfinite(table)):
        raise DataError(f"{options.csv} needs finite columns period_s, target_g and mean_g")
    fig, grid = figure(1, 1, 2.6)
    ax = grid[0, 0]
    for column in table.T[3:]:
        ax.plot(table[:, 0], column, color=MUTED, lw=0.5)
    ax.plot(table[:, 0], table[:, 2], color=FE, lw=1.6, label="mean")
    ax.plot(table[:, 0], table[:, 1], color=RIM, lw=1.6, label="target")
    ax.plot(table[:, 0], 0.9 * table[:, 1], color=RIM, lw=0.8, ls="--", label="0.9 target")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("period (s)")
    ax.set_ylabel("$S_a$, 5 % damping (g)")
    ax.legend(frameon=False, fontsize=7)
    save(fig, options.png)


if __name__ == "__main__":
    run_main(main)
