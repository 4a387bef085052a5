#!/usr/bin/env python3
"""Checks the direction of dependencies: which module may include which, which target may link which, and who may see deal.II,
PETSc and gmsh. A target compiles its own folder only."""
import pathlib
import re
import sys
from collections.abc import Iterator

BASE = {"io/files", "laws/friction", "laws/impact", "io/records", "scene", "responses"}
FE = "fe_contact/"
UNDER_APP = {"calibration/data", "calibration/fit", "calibration/laws", "calibration/studies", "calibration/answer", "calibration/export",
             "studies/fleets", "studies/risk", "studies/reliability", "buildings", "reduced_models", "meshes", FE + "planning", FE + "drive"} | BASE
MAY_INCLUDE = {
    "io/files": {"io/files"},
    "io/records": {"io/records", "io/files"},
    "laws/friction": {"laws/friction", "io/files"},
    "laws/impact": {"laws/impact", "io/files"},
    "scene": {"scene", "laws/friction", "laws/impact", "io/records", "io/files"},
    "responses": BASE,
    "reduced_models": {"reduced_models"} | BASE,
    FE + "planning": {FE + "planning", "reduced_models"} | BASE,
    "buildings": {"buildings", "reduced_models"} | BASE,
    "studies/reliability": {"studies/reliability", "io/files"},
    "studies/fleets": {"studies/fleets", "reduced_models"} | BASE,
    "studies/risk": {"studies/risk", "studies/fleets", "studies/reliability", "reduced_models"} | BASE,
    "calibration/data": {"calibration/data", "reduced_models"} | BASE,
    "calibration/fit": {"calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/laws": {"calibration/laws", "calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/studies": {"calibration/studies", "calibration/fit", "calibration/data", "reduced_models"} | BASE,
    "calibration/answer": {"calibration/answer", "calibration/studies", "calibration/laws", "calibration/fit", "calibration/data",
                           "reduced_models"} | BASE,
    "calibration/export": {"calibration/export", "calibration/answer", "calibration/laws", "calibration/fit", "calibration/data",
                           "reduced_models"} | BASE,
    "python": {"python", "reduced_models"} | BASE,
    "meshes": {"meshes", "io/files", "scene"},
    FE + "laws": {FE + "laws", "laws/friction", "scene"},
    FE + "solver": {FE + "solver"},
    FE + "engine": {FE + "engine", FE + "laws", FE + "solver", "laws/friction", "meshes", "scene", "io/files"},
    FE + "rungs": {FE + "rungs", FE + "engine", FE + "laws", FE + "solver", "meshes", "reduced_models"} | BASE,
    FE + "drive": {FE + "drive", FE + "rungs", FE + "engine", FE + "laws", FE + "solver", "meshes", FE + "planning",
                   "reduced_models"} | BASE,
    "app/console": {"app/console"} | BASE,
    "app/words": {"app/words", "app/console"} | UNDER_APP,
    "app/jobs": {"app/jobs", "app/words", "app/console"} | UNDER_APP,
    "app/verbs": {"app/verbs", "app/jobs", "app/words", "app/console"} | UNDER_APP,
    "app": {"app/verbs", "app/jobs", "app/console"} | UNDER_APP,
}
HEAVY = re.compile(r"deal\.II/|petsc|gmsh\.h|dmumps|slepc")
MAY_SEE_HEAVY = ("meshes/", "fe_contact/", "app/main_fe.cc")
ROOMS = ("app", "calibration", "fe_contact", "io", "laws", "studies")  #: whose folders are modules


def module_of(path: str) -> str:
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] in ROOMS and len(parts) > 2 else parts[0]


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


def lists_of(root: pathlib.Path) -> list[pathlib.Path]:
    """CMakeLists.txt of every room outside tests/."""
    found = [*root.glob("*/CMakeLists.txt"), *root.glob("*/*/CMakeLists.txt")]
    return sorted(file for file in found if file.relative_to(root).parts[0] not in ("tests", "build"))


def targets_of(root: pathlib.Path) -> dict[str, tuple[str, set[str]]]:
    """{target: (folder, names it links)} of every library and program outside tests/."""
    targets: dict[str, tuple[str, set[str]]] = {}
    for file in lists_of(root):
        folder = str(file.parent.relative_to(root))
        text = re.sub(r"#[^\n]*", "", file.read_text())
        for name in re.findall(r"(?:add_library|add_executable|pybind11_add_module)\(\s*(\S+)", text):
            targets[name] = (folder, set())
        for name, links in re.findall(r"target_link_libraries\(\s*(\S+)([^)]*)\)", text):
            targets[name][1].update(links.split())
    return targets


def folder_of(module: str, folders: set[str]) -> str:
    """The nearest folder that has targets."""
    return module if module in folders else module.split("/")[0]


def link_errors(root: pathlib.Path) -> Iterator[str]:
    targets = targets_of(root)
    top: dict[str, set[str]] = {}  # what a folder with a CMakeLists.txt may link: its modules' own, by such folders
    folders = {folder for folder, _ in targets.values()}
    for name, allowed in MAY_INCLUDE.items():
        top.setdefault(folder_of(name, folders), set()).update(folder_of(other, folders) for other in allowed)
    for name, (folder, links) in targets.items():
        for link in sorted(links & set(targets)):
            if targets[link][0] not in top[folder]:
                yield f"{folder}/CMakeLists.txt: {name} must not link {link} of {targets[link][0]}"
    for file in lists_of(root):
        for found in re.findall(r"\S*\.\./\S*\.cc|\$\{PROJECT_SOURCE_DIR\}\S*\.cc", file.read_text()):
            yield f"{file.relative_to(root)}: {found} is another folder's"


def main(folder: str) -> int:
    root = pathlib.Path(folder)
    errors, n_files = list(link_errors(root)), 0
    for name in MAY_INCLUDE:
        for file in sorted((root / name).glob("*.[hc]*") if name in ROOMS else (root / name).rglob("*.[hc]*")):
            if file.suffix in (".h", ".cc"):
                n_files += 1
                errors += include_errors(root, name, file)
    print("\n".join(errors) if errors else f"{n_files} files respect the direction of dependencies")
    return 1 if errors or n_files < 50 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
