#!/usr/bin/env python3
"""Checks that the light command loads neither deal.II nor PETSc nor gmsh: with them it would take a second to start."""
import re
import subprocess
import sys

HEAVY = re.compile(r"deal.?ii|petsc|gmsh|mumps|slepc|trilinos", re.IGNORECASE)


def main(program: str) -> int:
    listing = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    libraries = [line.split()[0] for line in listing.splitlines() if line.strip()]
    heavy = [name for name in libraries if HEAVY.search(name)]
    print("\n".join(f"{program} loads {name}" for name in heavy) or f"{len(libraries)} libraries, none of them heavy")
    return 1 if heavy or not libraries else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
