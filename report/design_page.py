"""python3 -m report.design_page DIR [--output FILE]: a page with sliders over the rims that `rimpact geometry --vary` has pushed."""
import argparse
import json
import os
from typing import Any

from markupsafe import Markup

from . import page
from .data_files import read_any_json
from .errors import DataError, InputError, run_main
from .figures.vary import label_of
from .numbers import percent_up

#: How far depth and strain of curves were from two solid runs made afterwards (rims of 35 and 52 mm at 0.6 m/s, docs/guide/main-and-studies.md); relative.
SEEN = {"depth": 0.011, "strain": 0.095}
KEPT = ("points", "vary", "speed_m_per_s", "mass_kg", "strain_limit", "targets", "curve_error", "answer")


def is_design(folder: str) -> bool:
    """Whether the folder is one of `geometry --vary`."""
    path = os.path.join(folder, "geometry.json")
    return os.path.isfile(path) and "vary" in read_any_json(path)


def read(folder: str) -> dict[str, Any]:
    if not os.path.isfile(os.path.join(folder, "geometry.json")):
        raise InputError(f"{folder}: no geometry.json in it; run `rimpact geometry CASE --vary rim.thickness_mm=20:80 --at speed=0.8 -o {folder}` first")
    study = read_any_json(os.path.join(folder, "geometry.json"))
    if "vary" not in study:
        raise InputError(f"{folder}: its rims are samples (--samples), not rims of one dimension; `rimpact geometry CASE --vary` makes those")
    if not study["points"]:
        raise DataError(f"{folder}: no rim has a result")
    if any("over_severity" not in point for point in study["points"]):
        raise DataError(f"{folder}: geometry.json is of an older version; the same `rimpact geometry` command writes it anew from the curves it has")
    return study


def as_script(study: dict[str, Any]) -> Markup:
    """JSON that ends no script element early."""
    kept = {key: study[key] for key in KEPT}
    return Markup(json.dumps({**kept, "curve_error": {**study["curve_error"], **SEEN}}, allow_nan=False).replace("<", "\\u003c"))


def build(folder: str, output: str | None = None) -> tuple[str, list[str]]:
    """Gives the page's path and the list of problems."""
    study = read(folder)
    output = output or os.path.join(folder, "design.html")
    load = study["load"]
    page.write(output, "design.html.j2", title=f"Rims of {study['bearing']['name']}",
               subtitle=f"{study['mass_kg']:.6g} kg supported, dead load {load['vertical_kN']:.4g} kN ({load['vertical_from']})", sentence=study["sentence"],
               dimension=label_of(study["vary"][0]["key"]), mesh=study["mesh"], rims=", ".join(point["name"] for point in study["points"]),
               curve_error=percent_up(study["curve_error"]["force"]), depth_error=percent_up(SEEN["depth"]), strain_error=percent_up(SEEN["strain"]),
               warnings=study["warnings"], study=as_script(study),
               footer=f"Made of {os.path.basename(os.path.normpath(folder))}/geometry.json: {study['command']}")
    return output, []


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="rimpact design-page", description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE", help="DIR/design.html when not given")
    options = parser.parse_args(arguments)
    build(options.folder, options.output)


if __name__ == "__main__":
    run_main(main, "design-page")
