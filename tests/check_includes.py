#!/usr/bin/env python3
"""Checks the direction of dependencies: which module may include which, which target may link which, and who may see deal.II,
PETSc and gmsh. A target compiles its own folder only."""
import pathlib
import re
import sys
from collections.abc import Iterator

BASE = {"files", "friction_laws", "impact_laws", "records", "scene", "responses"}
FE = "fe_contact/"
MAY_INCLUDE = {
    "files": {"files"},
    "records": {"records", "files"},
    "friction_laws": {"friction_laws", "files"},
    "impact_laws": {"impact_laws", "files"},
    "scene": {"scene", "friction_laws", "impact_laws", "records", "files"},
    "responses": BASE,
    "reduced_models": {"reduced_models"} | BASE,
    "planning": {"planning", "reduced_models"} | BASE,
    "buildings": {"buildings", "reduced_models"} | BASE,
    "reliability": {"reliability", "files"},
    "fleets": {"fleets", "reduced_models"} | BASE,
    "risk": {"risk", "fleets", "reliability", "reduced_models"} | BASE,
    "calibration/data": {"calibration/data", "reduced_models"} | BASE,
    "calibration/fit": {"calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/laws": {"calibration/laws", "calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/studies": {"calibration/studies", "calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/answer": {"calibration/answer", "calibration/studies", "calibration/laws", "calibration/fit", "calibration/data",
                           "reduced_models"} | BASE,
    "calibration/export": {"calibration/export", "calibration/answer", "calibration/laws", "calibration/fit", "calibration/data",
                           "reduced_models"} | BASE,
    "python": {"python", "reduced_models"} | BASE,
    "meshes": {"meshes", "files", "scene"},
    FE + "laws": {FE + "laws", "friction_laws", "scene"},
    FE + "solver": {FE + "solver"},
    FE + "engine": {FE + "engine", FE + "laws", FE + "solver", "friction_laws", "meshes", "scene", "files"},
    FE + "rungs": {FE + "rungs", FE + "engine", FE + "laws", FE + "solver", "meshes", "reduced_models"} | BASE,
    FE + "drive": {FE + "drive", FE + "rungs", FE + "engine", FE + "laws", FE + "solver", "meshes", "planning",
                   "reduced_models"} | BASE,
    "app": {"app", "calibration/data", "calibration/fit", "calibration/laws", "calibration/studies", "calibration/answer",
            "calibration/export", "fleets", "risk", "buildings", "reliability", "planning", "reduced_models", "meshes", FE + "drive"} | BASE,
}
HEAVY = re.compile(r"deal\.II/|petsc|gmsh\.h|dmumps|slepc")
MAY_SEE_HEAVY = ("meshes/", "fe_contact/", "app/main_fe.cc")
ROOMS = ("fe_contact", "calibration")


def module_of(path: str) -> str:
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] in ROOMS else parts[0]


def include_errors(root: pathlib.Path, name: str, file: pathlib.Path) -> Iterator[str]:
    relative = str(file.relative_to(root))
    for number, line in enumerate(file.read_text().splitlines(), 1):
        found = re.match(r'\s*#include\s*([<"])([^>"]+)', line)
        if not found:
            continue
        target = found.group(2)
        if HEAVY.search(target) and not relative.startswith(MAY_SEE_HEAVY):
            yield f"{relative}:{number}: {target} belongs to the finite-element side"
        other = module_of(target)
        if found.group(1) == '"' and other in MAY_INCLUDE and other not in MAY_INCLUDE[name]:
            yield f"{relative}:{number}: {name} must not include {other}"


def targets_of(root: pathlib.Path) -> dict[str, tuple[str, set[str]]]:
    """{target: (folder, names it links)} of every library and program outside tests/."""
    targets: dict[str, tuple[str, set[str]]] = {}
    for file in sorted(root.glob("*/CMakeLists.txt")):
        folder = file.parent.name
        if folder in ("tests", "build"):
            continue
        text = re.sub(r"#[^\n]*", "", file.read_text())
        for name in re.findall(r"(?:add_library|add_executable|pybind11_add_module)\(\s*(\S+)", text):
            targets[name] = (folder, set())
        for name, links in re.findall(r"target_link_libraries\(\s*(\S+)([^)]*)\)", text):
            targets[name][1].update(links.split())
    return targets


def link_errors(root: pathlib.Path) -> Iterator[str]:
    targets = targets_of(root)
    top: dict[str, set[str]] = {}
    for name, allowed in MAY_INCLUDE.items():
        top.setdefault(name.split("/")[0], set()).update(other.split("/")[0] for other in allowed)
    for name, (folder, links) in targets.items():
        for link in sorted(links & set(targets)):
            if targets[link][0] not in top[folder]:
                yield f"{folder}/CMakeLists.txt: {name} must not link {link} of {targets[link][0]}"
    for file in root.glob("*/CMakeLists.txt"):
        for found in re.findall(r"\S*\.\./\S*\.cc|\$\{PROJECT_SOURCE_DIR\}\S*\.cc", file.read_text()):
            if file.parent.name != "tests":
                yield f"{file.parent.name}/CMakeLists.txt: {found} is another folder's"


def main(folder: str) -> int:
    root = pathlib.Path(folder)
    errors, n_files = list(link_errors(root)), 0
    for name in MAY_INCLUDE:
        for file in sorted((root / name).rglob("*.[hc]*")):
            if file.suffix in (".h", ".cc"):
                n_files += 1
                errors += include_errors(root, name, file)
    print("\n".join(errors) if errors else f"{n_files} files respect the direction of dependencies")
    return 1 if errors or n_files < 50 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
