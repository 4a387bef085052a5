"""python3 -m report.compare DIR: draws what DIR/compare.json holds, two or more responses, the first being the reference.

Writes DIR/figures/response.png and impacts.png and DIR/compare.html. The responses stand in DIR/curves/A, B, ..., as run
folders. Needs displacements, forces and rim forces in x and y; what else is missing leaves its panel empty."""
import argparse
import os
from collections.abc import Callable
from typing import Any

from . import interactive, page
from .blocks import Pictures, Section, heading, note, table, text
from .data_files import read_json
from .errors import run_main
from .figures import impacts, response_panels
from .numbers import integer, percent, scaled
from .run_folder import load_run
from .series import contact_stretches
from .shapes import FLAG, NUMBER, TEXT, numbers, texts

METRICS = numbers("peak_force_error peak_displacement_error approach_speed_error rebound_error restitution_error nrmse_displacement nrmse_force "
                  "nrmse_lateral_force touch_time_difference")
SHAPE = {"version": TEXT, "capacity_m": NUMBER,
         "items": [{**texts("name path"), "metrics": METRICS, "notes": [TEXT],
                    "differences": [{**texts("key a b"), "comparable": FLAG}]}]}


class Comparison:
    """The items, and their curves by letter."""

    def __init__(self, folder: str) -> None:
        data = read_json(os.path.join(folder, "compare.json"), SHAPE)
        self.items, self.capacity, self.version = data["items"], data.get("capacity_m"), data.get("version", "")
        self.models = [(item["name"], load_run(os.path.join(folder, "curves", item["name"]), item["name"])) for item in self.items]
        self.labels = {item["name"]: f"{item['name']}: {_short(item['path'])}" for item in self.items}


def _short(path: str, most: int = 28) -> str:
    return path if len(path) <= most else "…" + path[1 - most:]


def _peaks(comparison: Comparison) -> dict[str, Any] | None:
    """What each response holds by itself."""
    header = ["", *(item["name"] for item in comparison.items)]
    runs = [run for _, run in comparison.models]
    return table(header, [
        ["peak displacement (mm)", *(scaled(run.norm("displacement").max(), 1e3, 2) for run in runs)],
        ["peak lateral force (kN)", *(scaled(run.norm("force").max(), 1e-3, 1) for run in runs)],
        ["peak impact force (kN)", *(scaled(run.norm("impact").max(), 1e-3, 1) for run in runs)],
        ["impacts", *(integer(len(contact_stretches(run))) for run in runs)],
        ["displacement at the end (mm)", *(scaled(run.norm("displacement")[-1], 1e3, 2) for run in runs)]])


ROWS: tuple[tuple[str, str, Callable[[Any], str]], ...] = (
        ("peak impact force", "peak_force_error", percent), ("peak displacement", "peak_displacement_error", lambda v: percent(v, 2)),
        ("approach speed", "approach_speed_error", percent), ("rebound speed", "rebound_error", percent),
        ("restitution (rebound over approach)", "restitution_error", percent),
        ("first touch, later (ms)", "touch_time_difference", lambda v: scaled(v, 1e3, 2)),
        ("displacement, rms over L_c", "nrmse_displacement", lambda v: percent(v, 2, False)),
        ("impact force, rms over peak", "nrmse_force", lambda v: percent(v, 2, False)),
        ("lateral force, rms over peak", "nrmse_lateral_force", lambda v: percent(v, 2, False)))


def _metrics(comparison: Comparison) -> dict[str, Any] | None:
    others = comparison.items[1:]
    rows = [[title, *(write(item["metrics"].get(key)) for item in others)] for title, key, write in ROWS]
    return table(["against A", *(item["name"] for item in others)], rows,
                 caption="Signed errors are relative to A. Root mean squares run from A's first touch to 0.5 s after its last release, "
                         "or over the whole of it where A does not touch.")


def _differences(section: Section, comparison: Comparison) -> None:
    for item in comparison.items[1:]:
        rows = [[d["key"], d["a"], d["b"], "" if d.get("comparable") else "runs of different things"] for d in item.get("differences", [])]
        section.add(heading(f"A and {item['name']}"))
        section.add(table(["key", "A", item["name"], ""], rows, left=4, prose=True) or
                    text("Their scenes are the same, or not known."))
        for sentence in item.get("notes", []):
            section.add(note(sentence))


def build(folder: str) -> str:
    """Gives the page's path."""
    comparison = Comparison(folder)
    problems: list[str] = []
    pictures = Pictures(os.path.join(folder, "figures"), problems)
    curves = Section("curves", "Curves", lead="Forces are drawn as −F, so that a positive displacement meets a positive force.")
    planar = all(run.is_planar() for _, run in comparison.models)
    curves.add(pictures.figure(
        "response", "Displacement, lateral force, loop" + ("" if planar else "s, path in plan") + " and vertical displacement. "
        "Dotted red: lateral capacity L_c.", response_panels.draw, comparison.models, comparison.labels, comparison.capacity, curves=interactive.response))
    zoom = pictures.figure("impacts", "Rim force through each impact, the first four, each curve from its own touch.",
                           impacts.draw, comparison.models, comparison.labels, curves=interactive.impacts)
    curves.add(zoom or note("The rim is touched in none of them."))
    numbers_section = Section("numbers", "Numbers")
    numbers_section.add(_peaks(comparison))
    numbers_section.add(_metrics(comparison))
    scenes = Section("scenes", "What differs between the scenes")
    _differences(scenes, comparison)
    path = os.path.join(folder, "compare.html")
    page.write(path, "page.html.j2", title="Responses compared", subtitle="; ".join(f"{item['name']} = {item['path']}" for item in comparison.items),
               sections=[curves, numbers_section, scenes], problems=problems, footer=comparison.version)
    return path


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.compare", description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    print(build(parser.parse_args(arguments).folder))


if __name__ == "__main__":
    run_main(main, "compare")
