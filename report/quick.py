"""python3 -m report.quick reduced|fe|building|fleet|bounds|geometry|study DIR: writes DIR/response.png, the panels of one run,
DIR/building.png, DIR/fleet.png of a sweep, DIR/bounds.png of runs at friction's bounds, or the picture of a study, DIR/geometry.png or DIR/study.png."""
import argparse
import os

from . import building_tables, fleet
from .data_files import read_any_json
from .errors import DataError, run_main
from .figures import building_on_bearings, geometry, response_panels, study
from .figures import fleet as figure_fleet
from .files import require_folder
from .run_folder import load_run

STUDIES = {"geometry": geometry, "study": study}


def draw(kind: str, folder: str) -> str:
    require_folder(folder)
    run = load_run(folder)
    if not run.has("time", "displacement_x", "displacement_y"):
        raise DataError(f"{folder} holds no displacements to draw")
    building_tables.write(run)
    if kind == "building":
        return building_on_bearings.draw(run, os.path.join(folder, "building.png"))
    role, label = ("fitted", "reduced model") if kind == "reduced" else ("fe", "finite elements")
    path = os.path.join(folder, "response.png")
    return response_panels.draw([(role, run)], {role: f"{run.name}, {label}"}, run.lateral_capacity, path)


def draw_fleet(folder: str) -> str:
    path = figure_fleet.draw(fleet.read(folder), os.path.join(folder, "fleet.png"))
    if path is None:
        raise DataError(f"{folder}: no run of the sweep has a result to draw")
    return path


def draw_bounds(folder: str) -> str:
    """The runs of `--bounds` in one picture, each by its own colour."""
    runs = read_any_json(os.path.join(folder, "bounds.json"))["runs"]
    roles = {role: (entry, load_run(os.path.join(folder, entry["bound"]))) for role, entry in zip("ABC", runs)}
    labels = {role: f"{entry['bound']}, friction x {entry['lambda']:.3g}" for role, (entry, _) in roles.items()}
    models = [(role, run) for role, (_, run) in roles.items()]
    return response_panels.draw(models, labels, models[0][1].lateral_capacity, os.path.join(folder, "bounds.png"))


def draw_table(kind: str, folder: str) -> str:
    path = os.path.join(folder, f"{kind}.json")
    try:
        return STUDIES[kind].draw(read_any_json(path), os.path.join(folder, f"{kind}.png"))
    except (KeyError, TypeError, AttributeError, ZeroDivisionError) as error:
        raise DataError(f"{path} is no table of a study ({error!r})") from None


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.quick", description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("reduced", "fe", "building", "fleet", "bounds", *STUDIES))
    parser.add_argument("folder")
    options = parser.parse_args(arguments)
    if options.kind == "fleet":
        draw_fleet(options.folder)
    elif options.kind == "bounds":
        draw_bounds(options.folder)
    elif options.kind in STUDIES:
        draw_table(options.kind, options.folder)
    else:
        draw(options.kind, options.folder)


if __name__ == "__main__":
    run_main(main)
