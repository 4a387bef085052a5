"""The Debian package alone on a system like this one that has nothing else: installed, walked and taken away without a trace.

usage: fresh_root.py BUILD [PACKAGE.deb [SUITE]] (root and debootstrap are needed, else exit 77: skipped)

Inside: version, man page, completion, Python's import, the main job on the coarsest mesh, the tutorial and four examples as their
pages say, `apt-get purge`. What is installed from Debian is what the package depends on, and man-db."""
import glob
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from debian_root import Inside, bare_root, call, own_suite, skip_unless_possible

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGES = ("docs/tutorial.md", "examples/own-rim/README.md", "examples/record/README.md", "examples/laboratory-curve/README.md", "examples/ida/README.md")
DOCUMENTS = "/usr/share/doc/rimpact"


def package_of(build, folder):
    call("cpack", "-G", "DEB", "--config", f"{build}/CPackConfig.cmake", "-B", folder, output=subprocess.DEVNULL)
    return glob.glob(f"{folder}/*.deb")[0]


def walk(inside):
    inside("it says its version", "rimpact version", "PETSc")
    inside("its man page", "man rimpact-reduced", "--sweep")
    inside("bash completes its verbs", "bash -c '. /usr/share/bash-completion/completions/rimpact && complete -p rimpact'", "rimpact")
    inside("Python runs a window in its own process", "cd /tmp && python3 -c \"import rimpact; print(len(rimpact.run_reduced('impact-window', 'w').impacts))\"", "1")
    inside("the main job, coarsest mesh", "cd /tmp && rimpact main --windows-only --mesh 0 --speeds 0.05,0.1,0.2 -o main && test -s main/report.html")
    for page in PAGES:
        inside(f"{page} as it says", f"cd /tmp && RIMPACT=/usr/bin/rimpact RIMPACT_SOURCE={DOCUMENTS} python3 run_pages.py --light --only {page}")


def main():
    build, given = sys.argv[1], sys.argv[2:]
    skip_unless_possible()
    with tempfile.TemporaryDirectory(prefix="rimpact-deb-") as folder, bare_root(given[1] if len(given) > 1 else own_suite()) as root:
        shutil.copy(given[0] if given else package_of(build, folder), root / "rimpact.deb")
        shutil.copy(SOURCE / "tests/docs/run_pages.py", root / "tmp")
        inside = Inside(root)
        # minbase leaves man pages out of what is installed
        for file in glob.glob(f"{root}/etc/dpkg/dpkg.cfg.d/*"):
            os.remove(file)
        inside("apt installs it with what it depends on", "apt-get update -q && apt-get install -q -y --no-install-recommends /rimpact.deb man-db")
        before = "find / -xdev \\( -path /proc -o -path /tmp -o -path /var -o -path /root \\) -prune -o -name '*rimpact*' -print"
        walk(inside)
        inside("apt takes it away", "apt-get purge -q -y rimpact")
        inside("no file of it is left", f"left=$({before} | grep -v '^/rimpact.deb$'); test -z \"$left\" || {{ echo \"$left\"; false; }}")
    print(f"{len(inside.failures)} failures")
    sys.exit(bool(inside.failures))


if __name__ == "__main__":
    main()
