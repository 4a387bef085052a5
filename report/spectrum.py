"""python3 -m report.spectrum CSV PNG: response spectra of records, and a target where there is one. Columns: file, period_s, sa_g, rotd50_g,
target_g, a row for each record and period."""
import argparse

import pandas as pd

from .errors import DataError, run_main
from .style import FE, MUTED, RIM, figure, save


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.spectrum", description=__doc__.splitlines()[0])
    parser.add_argument("csv")
    parser.add_argument("png")
    options = parser.parse_args(arguments)
    table = pd.read_csv(options.csv)
    missing = {"station", "file", "period_s", "sa_g", "rotd50_g", "target_g"} - set(table.columns)
    if missing or table.empty:
        raise DataError(f"{options.csv} needs rows, and the columns {', '.join(sorted(missing)) or 'it has'}")
    fig, grid = figure(1, 1, 2.6)
    ax = grid[0, 0]
    for _, record in table.groupby(["station", "file"], sort=False):
        ax.plot(record["period_s"], record["sa_g"], color=MUTED, lw=0.5)
    of_pairs = table.dropna(subset=["rotd50_g"]).drop_duplicates(["station", "period_s"])
    for number, (_, pair) in enumerate(of_pairs.groupby("station", sort=False)):
        ax.plot(pair["period_s"], pair["rotd50_g"], color=FE, lw=1.0, label="RotD50" if number == 0 else None)
    target = table.dropna(subset=["target_g"]).drop_duplicates("period_s")
    if not target.empty:
        ax.plot(target["period_s"], target["target_g"], color=RIM, lw=1.6, label="target")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("period (s)")
    ax.set_ylabel("$S_a$, 5 % damping (g)")
    if ax.get_legend_handles_labels()[0]:
        ax.legend(frameon=False, fontsize=7)
    save(fig, options.png)


if __name__ == "__main__":
    run_main(main)
