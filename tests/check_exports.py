#!/usr/bin/env python3
"""No program gives functions of Eigen to the shared libraries it is linked with. gmsh, deal.II and others carry functions under the same
names, compiled for another processor, and would take ours: memory that one allocates and the other frees is then damaged.

usage: check_exports.py BUILD"""
import pathlib
import subprocess
import sys


def exported(program: pathlib.Path) -> list[str]:
    said = subprocess.run(["nm", "--dynamic", "--demangle", "--defined-only", str(program)], capture_output=True, text=True, check=True).stdout
    return [line for line in said.splitlines() if "Eigen::" in line]


def main(build: str) -> int:
    programs = sorted(file for file in pathlib.Path(build, "bin").iterdir() if file.is_file() and file.stat().st_mode & 0o111)
    faults = [f"{program.name} exports {lines[0].split(maxsplit=2)[2]} and {len(lines) - 1} more" for program in programs if (lines := exported(program))]
    print("\n".join(faults) or f"{len(programs)} programs keep their functions of Eigen to themselves")
    return 1 if faults or not programs else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
