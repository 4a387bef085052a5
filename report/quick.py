"""python3 -m report.quick reduced|fe|geometry DIR: writes DIR/response.png, the panels of one run, or DIR/geometry.png."""
import argparse
import json
import os

from .errors import DataError, run_main
from .figures import geometry, response_panels
from .run_folder import load_run


def draw(kind, folder):
    if not os.path.isdir(folder):
        raise DataError(f"{folder} is not a folder")
    run = load_run(folder)
    if not run.has("time", "displacement_x", "displacement_y"):
        raise DataError(f"{folder} holds no displacements to draw")
    role, label = ("fitted", "reduced model") if kind == "reduced" else ("fe", "finite elements")
    path = os.path.join(folder, "response.png")
    return response_panels.draw([(role, run)], path, run.lateral_capacity, {role: f"{run.name}, {label}"})


def draw_geometry(folder):
    path = os.path.join(folder, "geometry.json")
    try:
        with open(path) as file:
            study = json.load(file)
    except (OSError, ValueError) as error:
        raise DataError(f"{path} cannot be read: {error}") from error
    return geometry.draw(study, os.path.join(folder, "geometry.png"))


def main(arguments):
    parser = argparse.ArgumentParser(prog="report.quick", description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("reduced", "fe", "geometry"))
    parser.add_argument("folder")
    options = parser.parse_args(arguments)
    if options.kind == "geometry":
        draw_geometry(options.folder)
    else:
        draw(options.kind, options.folder)


if __name__ == "__main__":
    run_main(main)
