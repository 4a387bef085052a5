#!/usr/bin/env bash
# fuzz.sh SECONDS [FOLDER] [READERS]: the readers of AT2, CSV, HDF5, TOML, JSON and mesh files under libFuzzer with address and
# undefined-behaviour sanitizers, so many seconds each. READERS: letters of fuzz_readers.cc, e.g. "ht". Needs a build's generated
# headers (build/release, or the folder RIMPACT_BUILD), clang and libclang-rt (Debian: clang, libclang-rt-14-dev). Exit 77: they are not there.
set -eu
seconds=${1:-60}
folder=${2:-$(mktemp -d)}
readers=${3:-acrhtjmkevl}
mkdir -p "$folder"
root=$(cd "$(dirname "$0")/../.." && pwd)
if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long) { return 0; }' |
  clang++ -x c++ -fsanitize=fuzzer - -o "$folder/probe" 2>/dev/null; then
  echo "clang with libFuzzer is not here (packages clang, libclang-rt-14-dev): skipped"
  exit 77
fi
build=${RIMPACT_BUILD:-$root/build/release}
hdf5=/usr/lib/x86_64-linux-gnu/hdf5/serial
flags=(-std=c++20 -g -O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
  -fno-sanitize=unreachable # toml++ tests non-ASCII characters outside strings by a switch whose default it calls unreachable
  -DNDEBUG # as it is shipped: toml++ asserts of a key what it reports as an error behind the assertion
  -DRIMPACT_VERSION="\"fuzz\"" -I"$root" -I"$build/responses/generated"
  -isystem /usr/include/eigen3 -isystem /usr/include/hdf5/serial)
objects=()
for source in "$root"/{files,records,friction_laws,impact_laws,scene,responses}/*.cc "$root"/calibration/{data/mapping,fit/run_facts}.cc "$root"/meshes/mesh_kind.cc "$root"/tests/fuzz/fuzz_readers.cc; do
  object=$folder/$(basename "$(dirname "$source")")_$(basename "$source" .cc).o
  [ "$object" -nt "$source" ] || clang++ "${flags[@]}" -c "$source" -o "$object"
  objects+=("$object")
done
clang++ -fsanitize=fuzzer,address,undefined "${objects[@]}" -lfmt -lcrypto -L$hdf5 -lhdf5_hl -lhdf5 -o "$folder/fuzz"

# One small file of each kind to begin with; what has been found since stays in the folder.
header='PEER\nrecord\nACCELERATION TIME SERIES IN UNITS OF G\n'
for reader in $(echo "$readers" | fold -w1); do mkdir -p "$folder/corpus_$reader"; done
begin() { [ ! -d "$folder/corpus_$1" ] || cat >"$folder/corpus_$1/$2"; }
printf "${header}NPTS= 4, DT= .01 SEC\n -.1234567E-02 .5 1.0D-3-.25E+0\n" | begin a peer
printf "${header}    4    .0200    NPTS, DT\n1 2 3 4 0 0\n" | begin a old
printf 'time_s,acceleration_g\n0,0.1\n0.01,-0.2\n0.02,0.3\n' | begin c record
printf 'time_s,ux_m,uy_m,Fx_N,Fy_N,gap_m\n0,1,2,3,4,5\n1,1,2,3,4,5\n' | begin r response
printf 'Origin Time 2011\nLat. 38\nSampling Freq(Hz) 100Hz\nScale Factor 3920(gal)/6182761\nMemo.\n 1000 3000\n 2\n' | begin k knet
printf 'EVENT_NAME: X\nSAMPLING_INTERVAL_S: 0.005\nNDATA: 3\nUNITS: cm/s^2\n0.5\n-1e1\n2\n' | begin e esm
{ printf 'Corrected acceleration\n 100 Real-header values follow on 17 lines, Format = (6F13.6)\n'
  for _ in $(seq 17); do printf '%13.6f' .005 .005 .005 .005 .005 .005; echo; done
  printf '3 acceleration pts, approx 0 secs, units=cm/s^2,Format=(8F10.5)\n   0.50000-100.00000   2.00000\n'; } | begin v cosmos
printf 'remark\nrsn;factor\n31;0,55\n' | begin l table
begin h response <"$root/tests/fuzz/corpus/response.h5"
begin t scene <"$root/tests/fuzz/corpus/scene.toml"
begin j summary <"$root/tests/fuzz/corpus/summary.json"
printf '$MeshFormat\n4.1 0 8\n$EndMeshFormat\n' | begin m mesh
printf '// script\nPoint(1) = {0,0,0};\nPrintf("SystemCall");\n' | begin m script
for reader in $(echo "$readers" | fold -w1); do
  echo "reader $reader"
  RIMPACT_READER=$reader "$folder/fuzz" -max_total_time="$seconds" -max_len=16384 -timeout=10 -rss_limit_mb=4096 -artifact_prefix="$folder/$reader-" \
    -print_final_stats=1 "$folder/corpus_$reader" 2>"$folder/$reader.log" || { tail -n 40 "$folder/$reader.log"; exit 1; }
  grep -E "number_of_executed_units|Done" "$folder/$reader.log"
done
