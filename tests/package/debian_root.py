"""A bare Debian or Ubuntu in a folder, for tests that install there. Needs root and debootstrap."""
import contextlib
import glob
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator

MIRRORS = {"noble": "http://archive.ubuntu.com/ubuntu"}
DEBIAN = os.environ.get("RIMPACT_MIRROR", "http://deb.debian.org/debian")
PLACES = ("proc", "dev/pts", "dev/shm")
#: What lets this machine, and so a root on it, reach its mirrors: names, certificates, pip's registry.
FROM_HERE = ("/etc/resolv.conf", "/etc/hosts", "/etc/pip.conf", *glob.glob("/usr/local/share/ca-certificates/*.crt"), *glob.glob("/etc/apt/apt.conf.d/*"))


def skip_unless_possible() -> None:
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        print("skipped: a bare root needs the rights of root and debootstrap")
        sys.exit(77)


def own_suite() -> str:
    """The suite of this machine: bookworm, trixie, noble."""
    lines = pathlib.Path("/etc/os-release").read_text(encoding="utf-8").splitlines()
    return next(line.split("=")[1].strip('"') for line in lines if line.startswith("VERSION_CODENAME="))


def call(*command: object, output: int | None = None) -> None:
    subprocess.run([str(word) for word in command], check=True, stdout=output)


def words_for(suite: str, root: pathlib.Path) -> list[object]:
    if suite not in MIRRORS:
        return ["--variant=minbase", suite, root, DEBIAN]
    # Debian's debootstrap may not know the newest Ubuntu by name, nor its keys: all of them are made as gutsy was.
    return ["--variant=minbase", "--no-check-gpg", "--components=main,universe", suite, root, MIRRORS[suite], "/usr/share/debootstrap/scripts/gutsy"]


def mounted_in(root: pathlib.Path) -> list[str]:
    lines = pathlib.Path("/proc/mounts").read_text(encoding="utf-8").splitlines()
    return [place for place in (line.split()[1] for line in lines) if place.startswith(f"{root}/")]


@contextlib.contextmanager
def bare_root(suite: str) -> Iterator[pathlib.Path]:
    """A root with the suite's smallest system, gone afterwards."""
    root = pathlib.Path(tempfile.mkdtemp(prefix=f"rimpact-{suite}-"))
    root.chmod(0o755)  # users other than root live there, too
    try:
        call("debootstrap", *words_for(suite, root), output=subprocess.DEVNULL)
        for file in filter(os.path.exists, FROM_HERE):
            (root / file[1:]).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, root / file[1:])
        for place in PLACES:
            call("mount", "--bind", f"/{place}", root / place)
        yield root
    finally:
        for place in reversed(mounted_in(root)):
            subprocess.run(["umount", place], check=False)
        if not mounted_in(root):  # or what is mounted would go with it
            shutil.rmtree(root)


class Inside:
    """Runs commands in a root, says how each went and how long it took, and keeps those that did not."""

    def __init__(self, root: pathlib.Path, **environment: str) -> None:
        self.root, self.failures = root, list[str]()
        self.environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive", "MANPAGER": "cat", **environment}

    def __call__(self, what: str, command: str, holds: str = "") -> str:
        """What the command prints. It has to end well, and to print what `holds` says."""
        begin = time.monotonic()
        done = subprocess.run(["chroot", str(self.root), "sh", "-c", command], capture_output=True, text=True, check=False, env=self.environment)
        said = done.stdout + done.stderr
        good = done.returncode == 0 and holds in said
        print(f"{'ok      ' if good else 'FAILED  '}{what} ({(time.monotonic() - begin) / 60:.1f} min)", flush=True)
        if not good:
            self.failures.append(what)
            print(said[-3000:], flush=True)
        return said
