"""python3 -m report.quick reduced|fe|geometry|study DIR: writes DIR/response.png, the panels of one run, or the
picture of a study, DIR/geometry.png or DIR/study.png."""
import argparse
import json
import os

from .errors import DataError, run_main
from .figures import geometry, response_panels, study
from .run_folder import load_run

STUDIES = {"geometry": geometry, "study": study}


def draw(kind, folder):
    if not os.path.isdir(folder):
        raise DataError(f"{folder} is not a folder")
    run = load_run(folder)
    if not run.has("time", "displacement_x", "displacement_y"):
        raise DataError(f"{folder} holds no displacements to draw")
    role, label = ("fitted", "reduced model") if kind == "reduced" else ("fe", "finite elements")
    path = os.path.join(folder, "response.png")
    return response_panels.draw([(role, run)], path, run.lateral_capacity, {role: f"{run.name}, {label}"})


def draw_table(kind, folder):
    path = os.path.join(folder, f"{kind}.json")
    try:
        with open(path, encoding="utf-8") as file:
            table = json.load(file)
    except (OSError, ValueError) as error:
        raise DataError(f"{path} cannot be read: {error}") from error
    return STUDIES[kind].draw(table, os.path.join(folder, f"{kind}.png"))


def main(arguments):
    parser = argparse.ArgumentParser(prog="report.quick", description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("reduced", "fe", *STUDIES))
    parser.add_argument("folder")
    options = parser.parse_args(arguments)
    if options.kind in STUDIES:
        draw_table(options.kind, options.folder)
    else:
        draw(options.kind, options.folder)


if __name__ == "__main__":
    run_main(main)
