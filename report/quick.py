"""python3 -m report.quick reduced|fe DIR: writes DIR/response.png, the panels of one run."""
import argparse
import os

from .errors import DataError, run_main
from .figures import response_panels
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


def main(arguments):
    parser = argparse.ArgumentParser(prog="report.quick", description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("reduced", "fe"))
    parser.add_argument("folder")
    options = parser.parse_args(arguments)
    draw(options.kind, options.folder)


if __name__ == "__main__":
    run_main(main)
