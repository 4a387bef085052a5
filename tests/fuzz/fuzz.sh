#!/usr/bin/env bash
# fuzz.sh SECONDS [FOLDER]: the readers of AT2 and CSV files under libFuzzer with address and undefined-behaviour
# sanitizers. Needs clang and libclang-rt (Debian: clang, libclang-rt-14-dev). Exit 77: they are not there.
set -eu
seconds=${1:-60}
folder=${2:-$(mktemp -d)}
mkdir -p "$folder"
root=$(cd "$(dirname "$0")/../.." && pwd)
if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long) { return 0; }' |
  clang++ -x c++ -fsanitize=fuzzer - -o "$folder/probe" 2>/dev/null; then
  echo "clang with libFuzzer is not here (packages clang, libclang-rt-14-dev): skipped"
  exit 77
fi
mkdir -p "$folder/corpus"
header='PEER\nrecord\nACCELERATION TIME SERIES IN UNITS OF G\n'
printf "a${header}NPTS= 4, DT= .01 SEC\n -.1234567E-02 .5 1.0D-3-.25E+0\n" >"$folder/corpus/at2"
printf "a${header}    4    .0200    NPTS, DT\n1 2 3 4 0 0\n" >"$folder/corpus/at2_old"
printf 'ctime_s,acceleration_g\n0,0.1\n0.01,-0.2\n0.02,0.3\n' >"$folder/corpus/record"
printf 'rtime_s,ux_m,uy_m,Fx_N,Fy_N,gap_m\n0,1,2,3,4,5\n1,1,2,3,4,5\n' >"$folder/corpus/response"
sources=()
for name in record record_at2 record_csv near_fault_pulse excitation text files response response_csv response_hdf5 hdf5_memory; do
  sources+=("$root/scene/$name.cc")
done
clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -I"$root" -isystem /usr/include/eigen3 -isystem /usr/include/hdf5/serial \
  "$root/tests/fuzz/fuzz_readers.cc" "${sources[@]}" -lfmt -L/usr/lib/x86_64-linux-gnu/hdf5/serial -lhdf5_hl -lhdf5 -o "$folder/fuzz"
"$folder/fuzz" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=4096 -artifact_prefix="$folder/" \
  -print_final_stats=1 "$folder/corpus"
