#!/usr/bin/env python3
"""The reduced side's unit tests under the address and undefined-behaviour sanitizers of the compiler, each stopped at its first fault.

    check_sanitized.py ROOT [PROGRAM ...]   builds build/asan-reduced, ten minutes or more at first; PROGRAM: some of the programs only
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAMS = ("test_scene", "test_reduced_models", "test_buildings", "test_calibration")
SANITIZERS = "address,undefined"
SETTINGS = ("--preset", "asan", f"-DRIMPACT_SANITIZE={SANITIZERS}", "-DRIMPACT_FE=OFF", "-DRIMPACT_BENCHMARKS=OFF", "-DRIMPACT_UNITY=ON")
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": "halt_on_error=1:detect_stack_use_after_return=1", "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"}
FAULT = re.compile(r"^.*(?:runtime error:|ERROR: \w+Sanitizer|SUMMARY: \w+Sanitizer).*$", re.MULTILINE)
PLANTED = {"heap-buffer-overflow": "int main(int n, char **) { int *a = new int[2]{}; int b = a[n + 1]; delete[] a; return b; }",
           "signed integer overflow": "int main(int n, char **) { int big = 2147483647; return (big + n) == 0; }"}


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", env=ENVIRONMENT)


def planted_faults_missed() -> list[str]:
    """Those of the planted faults that the sanitizers do not tell: then their silence about the tests would say nothing."""
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        for fault, text in PLANTED.items():
            source, program = pathlib.Path(folder) / "planted.cc", str(pathlib.Path(folder) / "planted")
            source.write_text(text, encoding="utf-8")
            built = run("c++", "-O0", f"-fsanitize={SANITIZERS}", str(source), "-o", program)
            done = run(program) if built.returncode == 0 else built
            if done.returncode == 0 or fault not in done.stdout:
                missed.append(f"planted and not told: {fault}; said: {done.stdout}")
    return missed


def built(root: pathlib.Path, programs: list[str]) -> list[str]:
    """What went wrong while the programs were built."""
    folder = str(root / "build/asan-reduced")
    for words in (("cmake", "-S", str(root), "-B", folder, *SETTINGS),
                  ("cmake", "--build", folder, "--parallel", str(min(2, os.cpu_count() or 1)), "--target", *programs)):
        done = run(*words)
        if done.returncode:
            return [f"{' '.join(words)} failed:", *done.stdout.splitlines()[-40:]]
    return []


def told(root: pathlib.Path, program: str) -> list[str]:
    """What the sanitizers and the tests of one program complain of; prints how many tests ran."""
    done = run(str(root / "build/asan-reduced/bin" / program))
    ran = re.findall(r"^\[==========\] .* ran\..*$", done.stdout, re.MULTILINE)
    faults = FAULT.findall(done.stdout) + re.findall(r"^\[  FAILED  \] \S+\.\S+$", done.stdout, re.MULTILINE)
    if done.returncode == 0 and ran and not faults:
        print(f"{program}: {ran[0].removeprefix('[==========] ')} Nothing found.", flush=True)
        return []
    return [f"{program} ended with {done.returncode}:", *(faults or ["no sanitizer spoke"]), *done.stdout.splitlines()[-60:]]


def main(folder: str, *programs: str) -> int:
    root, chosen = pathlib.Path(folder).resolve(), list(programs or PROGRAMS)
    faults = planted_faults_missed() or built(root, chosen) or [fault for program in chosen for fault in told(root, program)]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
