"""The Debian package alone on a Debian that has nothing else: installed, walked and taken away without a trace.

usage: fresh_root.py BUILD [PACKAGE.deb] (root and debootstrap are needed, else exit 77: skipped)

Inside: version, man page, completion, Python's import, the main job on the coarsest mesh, the tutorial and four examples as their
pages say, `apt-get purge`. What is installed from Debian is what the package depends on, and man-db."""
import contextlib
import glob
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MIRROR = os.environ.get("RIMPACT_MIRROR", "http://deb.debian.org/debian")
PLACES = ("proc", "dev/pts", "dev/shm")
PAGES = ("docs/tutorial.md", "examples/own-rim/README.md", "examples/record/README.md", "examples/laboratory-curve/README.md", "examples/ida/README.md")
DOCUMENTS = "/usr/share/doc/rimpact"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def call(*command, **more):
    subprocess.run([str(word) for word in command], check=True, **more)


def package_of(build, folder):
    call("cpack", "-G", "DEB", "--config", f"{build}/CPackConfig.cmake", "-B", folder, stdout=subprocess.DEVNULL)
    return glob.glob(f"{folder}/*.deb")[0]


@contextlib.contextmanager
def debian():
    """A root with Debian 12's smallest system, gone afterwards."""
    root = pathlib.Path(tempfile.mkdtemp(prefix="rimpact-root-"))
    try:
        call("debootstrap", "--variant=minbase", "bookworm", root, MIRROR, stdout=subprocess.DEVNULL)
        for file in ("resolv.conf", "hosts"):
            shutil.copy(f"/etc/{file}", root / "etc" / file)
        for file in glob.glob("/etc/apt/apt.conf.d/*"):  # proxies and the like
            shutil.copy(file, root / "etc/apt/apt.conf.d")
        for place in PLACES:
            call("mount", "--bind", f"/{place}", root / place)
        yield root
    finally:
        for place in reversed(PLACES):
            subprocess.run(["umount", str(root / place)], check=False, stderr=subprocess.DEVNULL)
        if not any(os.path.ismount(root / place) for place in PLACES):
            shutil.rmtree(root)


class Inside:
    def __init__(self, root):
        self.root, self.failures = root, []

    def __call__(self, what, command, holds=""):
        environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive", "MANPAGER": "cat"}
        done = subprocess.run(["chroot", self.root, "sh", "-c", command], capture_output=True, text=True, check=False, env=environment)
        good = done.returncode == 0 and holds in done.stdout + done.stderr
        print(("ok      " if good else "FAILED  ") + what, flush=True)
        if not good:
            self.failures.append(what)
            print((done.stdout + done.stderr)[-1500:])
        return good


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
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        skip("root and debootstrap are needed")
    with tempfile.TemporaryDirectory(prefix="rimpact-deb-") as folder, debian() as root:
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
