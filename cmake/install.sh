# shellcheck shell=bash
# Shared by ./run and ./test: installs what is missing from Debian or Ubuntu, configures, builds. Sourced, not run.

packages="g++ cmake ninja-build ccache pkg-config dpkg-dev file git ca-certificates libdeal.ii-dev libpetsc-real-dev libgmsh-dev libseccomp-dev libzip-dev libceres-dev
  libsundials-dev libopenblas0-pthread libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libgtest-dev
  libgmock-dev libbenchmark-dev libeigen3-dev libhdf5-openmpi-dev libhdf5-dev python3-h5py python3-matplotlib python3-pil python3-jinja2 pybind11-dev python3-dev
  python3-venv python3-pandas help2man mkdocs tcl"

say() { printf '%s\n' "$*" >&2; }

install_missing() {
  local missing="" package sudo=""
  command -v apt-get >/dev/null || {
    # shellcheck disable=SC2086
    say "error: no apt-get here; on other systems than Debian and Ubuntu install by hand, then use --no-install:" $packages
    exit 1
  }
  for package in $packages; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
  done
  if [ -n "$missing" ]; then
    say "Installing from Debian (about 3 GB with what they need):$missing"
    if [ "$(id -u)" -ne 0 ]; then
      command -v sudo >/dev/null || { say "error: these packages need root; install them by hand or install sudo"; exit 1; }
      sudo=sudo
    fi
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2 || { say "error: apt-get update failed"; exit 1; }
    # shellcheck disable=SC2086
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2 ||
      { say "error: apt-get install failed; see above"; exit 1; }
  fi
}

# python_environments NAME ...: build/NAME holds what tests/NAME/requirements.txt pins, from PyPI. Tests that miss it are
# skipped by name; nothing of the product needs it.
python_environments() {
  local name system
  for name in "$@"; do
    system="" # build/python sees the system's NumPy, for which the compiled module of rimpact is made
    [ "$name" = python ] && system=--system-site-packages
    cmp -s "tests/$name/requirements.txt" "build/$name/installed.txt" && continue
    say "Installing tests/$name/requirements.txt from PyPI into build/$name"
    mkdir -p build && rm -rf "build/$name"
    {
      /usr/bin/python3 -m venv $system "build/$name" &&
        "build/$name/bin/pip" install --timeout 15 --retries 1 -r "tests/$name/requirements.txt" &&
        cp "tests/$name/requirements.txt" "build/$name/installed.txt"
    } >"build/$name.log" 2>&1 && continue
    rm -rf "build/$name"
    say "warning: build/$name could not be installed from PyPI (see build/$name.log): the tests that need it are skipped"
  done
}

# The reference BLAS makes factorisations 10 to 20 times slower: prefer OpenBLAS for this process and its children.
prefer_openblas() {
  local folder
  for folder in /usr/lib/*/openblas-pthread; do
    [ -e "$folder/libblas.so.3" ] && export LD_LIBRARY_PATH="$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" && return
  done
  say "warning: OpenBLAS was not found; the runs will take 10 to 20 times longer"
}

# build [TARGET ...]: all, or these and what they need.
build() {
  local jobs memory
  memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo) # deal.II units take over 1 GB each
  jobs=$(nproc)
  [ "$memory" -lt "$jobs" ] && jobs=$((memory > 0 ? memory : 1))
  say "Configuring and building in build/release with $jobs job(s)"
  mkdir -p build
  cmake --preset release >build/configure.log 2>&1 || {
    tail -n 30 build/configure.log >&2
    say "error: configuring failed; all of it is in build/configure.log"
    exit 1
  }
  cmake --build --preset release --parallel "$jobs" ${1:+--target "$@"} >&2 || { say "error: the build failed"; exit 1; }
}
