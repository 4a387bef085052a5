#!/usr/bin/env python3
"""Checks the direction of dependencies: which module may include which, and who may see deal.II, PETSc and gmsh."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "scene": {"scene"},
    "reduced_models": {"reduced_models", "scene"},
    "buildings": {"buildings", "reduced_models", "scene"},
    "reliability": {"reliability", "scene"},
    "fleets": {"fleets", "reduced_models", "scene"},
    "calibration": {"calibration", "reduced_models", "scene"},
    "meshes": {"meshes", "scene"},
    "fe_contact/laws": {"fe_contact/laws", "scene"},
    "fe_contact/solver": {"fe_contact/solver"},
    "fe_contact/model": {"fe_contact/model", "fe_contact/laws", "fe_contact/solver", "meshes", "scene"},
    "fe_contact/runner": {"fe_contact/runner", "fe_contact/model", "fe_contact/laws", "fe_contact/solver", "meshes", "scene",
                          "reduced_models"},
    "app": {"app", "calibration", "fleets", "reduced_models", "scene", "meshes", "fe_contact/runner"},
}
HEAVY = re.compile(r"deal\.II/|petsc|gmsh\.h|dmumps|slepc")
MAY_SEE_HEAVY = ("meshes/", "fe_contact/", "app/main_fe.cc")


def module_of(path):
    parts = path.split("/")
    name = "/".join(parts[:2]) if parts[0] == "fe_contact" else parts[0]
    return name if name in MAY_INCLUDE else None


def main(root):
    root = pathlib.Path(root)
    errors, n_files = [], 0
    for name in MAY_INCLUDE:
        for file in sorted((root / name).rglob("*.[hc]*")):
            if file.suffix not in (".h", ".cc"):
                continue
            n_files += 1
            relative = str(file.relative_to(root))
            for number, line in enumerate(file.read_text().splitlines(), 1):
                found = re.match(r'\s*#include\s*([<"])([^>"]+)', line)
                if not found:
                    continue
                target = found.group(2)
                if HEAVY.search(target) and not relative.startswith(MAY_SEE_HEAVY):
                    errors.append(f"{relative}:{number}: {target} belongs to the finite-element side")
                other = module_of(target)
                if found.group(1) == '"' and other and other not in MAY_INCLUDE[name]:
                    errors.append(f"{relative}:{number}: {name} must not include {other}")
    print("\n".join(errors) if errors else f"{n_files} files respect the direction of dependencies")
    return 1 if errors or n_files < 50 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
