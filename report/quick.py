"""python3 -m report.quick reduced|fe|building|geometry|study DIR: writes DIR/response.png, the panels of one run,
DIR/building.png, or the picture of a study, DIR/geometry.png or DIR/study.png."""
import argparse
import os

from .data_files import read_any_json
from .errors import DataError, run_main
from .figures import building_on_bearings, geometry, response_panels, study
from .run_folder import load_run

STUDIES = {"geometry": geometry, "study": study}


def draw(kind, folder):
    if not os.path.isdir(folder):
        raise DataError(f"{folder} is not a folder")
    run = load_run(folder)
    if not run.has("time", "displacement_x", "displacement_y"):
        raise DataError(f"{folder} holds no displacements to draw")
    if kind == "building":
        return building_on_bearings.draw(run, os.path.join(folder, "building.png"))
    role, label = ("fitted", "reduced model") if kind == "reduced" else ("fe", "finite elements")
    path = os.path.join(folder, "response.png")
    return response_panels.draw([(role, run)], {role: f"{run.name}, {label}"}, run.lateral_capacity, path)


def draw_table(kind, folder):
    path = os.path.join(folder, f"{kind}.json")
    try:
        return STUDIES[kind].draw(read_any_json(path), os.path.join(folder, f"{kind}.png"))
    except (KeyError, TypeError, AttributeError, ZeroDivisionError) as error:
        raise DataError(f"{path} is no table of a study ({error!r})") from None


def main(arguments):
    parser = argparse.ArgumentParser(prog="report.quick", description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("reduced", "fe", "building", *STUDIES))
    parser.add_argument("folder")
    options = parser.parse_args(arguments)
    if options.kind in STUDIES:
        draw_table(options.kind, options.folder)
    else:
        draw(options.kind, options.folder)


if __name__ == "__main__":
    run_main(main)
