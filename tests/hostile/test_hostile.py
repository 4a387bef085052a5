"""Hostile input, table-driven: every row is one attack on the command and what must happen. `test_hostile.py --list` counts the rows."""
import collections
import os
import resource
import signal
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Callable
from dataclasses import dataclass

SECONDS = 20
FREE = '[excitation]\nkind = "free"\ndisplacement_m = [0.1, 0]\nduration_s = 0.1\n'
AT2 = "PEER NGA STRONG MOTION DATABASE RECORD\nA RECORD\nACCELERATION TIME SERIES IN UNITS OF G\n"


@dataclass
class Row:
    area: str
    name: str
    words: list  # after `rimpact`, in a folder of its own that holds `file`
    code: int
    says: str = ""
    file: tuple = ()  # (name, text or bytes)
    limit: Callable | None = None  # called in the child before the command starts
    kept: str = ""  # a file that must be there, unchanged, afterwards
    open: bool = False  # known to fail: the suite fails once it holds, so that the mark is taken away


def toml(name, content, code, says=""):
    return Row("TOML", name, ["check", "x.toml"], code, says, ("x.toml", content))


def record(name, content, code, says="", file="x.AT2"):
    return Row("records", name, ["motion", file], code, says, (file, content))


def limits(which, amount):
    return lambda: resource.setrlimit(which, (amount, amount))


def ignoring_the_signal():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    limits(resource.RLIMIT_FSIZE, 4096)()


def in_a_read_only_folder():
    """The folder cannot be written into; permissions do not bind root, so the command is nobody's."""
    os.chmod(".", 0o555)
    if os.geteuid() == 0:
        os.setresgid(65534, 65534, 65534)
        os.setresuid(65534, 65534, 65534)


def without_a_terminal():
    """Of no session that has one, and none to be read from, as under cron."""
    os.setsid()
    os.environ.pop("TERM", None)
    os.dup2(os.open("/dev/null", os.O_RDONLY), 0)


def where_commas_are_decimal():
    os.environ.update(LC_ALL="de_DE.UTF-8", LC_NUMERIC="de_DE.UTF-8", LANG="de_DE.UTF-8")


def script(name, content, says):
    return Row("meshes", name, ["check", "impact-window", "--allow-script", "--set", 'model.own_mesh.file="x.geo"'], 3, says, ("x.geo", content), kept="x.geo")


def mesh(name, content, says, file="x.msh"):
    return Row("meshes", name, ["check", "impact-window", "--set", f'model.own_mesh.file="{file}"'], 3, says, (file, content), kept=file)


ROWS = [
    toml("a value of another type", FREE.replace("0.1\n", '"long"\n'), 2, "duration_s"),
    toml("a key twice", FREE + "duration_s = 1.0\n", 2, "x.toml:5"),
    toml("a duration of inf", FREE.replace("= 0.1\n", "= inf\n"), 2, "duration_s"),
    toml("a duration of nan", FREE.replace("= 0.1\n", "= nan\n"), 2, "duration_s"),
    toml("a byte order mark", "\ufeff" + FREE, 0),
    toml("lines ended by CR LF", FREE.replace("\n", "\r\n"), 0),
    toml("a name in Chinese", 'name = "\u6469\u64e6"\n' + FREE, 0),
    toml("bytes that are no UTF-8", b'name = "\xff"\n', 2, "x.toml"),
    toml("a bracket left open", "[excitation\n", 2, "x.toml:1"),
    toml("a thousand brackets", "a = " + "[" * 1000, 2, "x.toml"),
    toml("a NUL", b"a = \0\n", 2, "x.toml:1: a NUL"),
    toml("a NUL in a table's name", b"a = 1\n[\0b]\n", 2, "x.toml:2: a NUL"),
    toml("two megabytes", "a = [" + "1," * 1000000 + "]\n", 2, "1048576"),
    record("columns that touch at a minus sign", AT2 + "NPTS= 3, DT= .01 SEC\n .1E-01-.2E-01 .1E-01\n", 0, "PGA 0.0200 g"),
    record("fewer values than NPTS", AT2 + "NPTS= 4, DT= .01 SEC\n .1 .2 .1\n", 3, "truncated"),
    record("a step of 0", AT2 + "NPTS= 3, DT= 0.0 SEC\n .1 .2 .1\n", 3, "x.AT2"),
    record("a value of nan", AT2 + "NPTS= 3, DT= .01 SEC\n .1 nan .1\n", 3, "x.AT2"),
    record("a value of 1e300", AT2 + "NPTS= 3, DT= .01 SEC\n .1 1e300 .1\n", 3, "x.AT2:5"),
    record("a cell of 1e300", "time_s,acceleration_g\n0,0\n1,1e300\n", 3, "x.csv:3", "x.csv"),
    record("an empty file", "", 3, "x.AT2"),
    record("a time that goes back", "time_s,acceleration_g\n0,0\n1,0.1\n0.5,0\n", 3, "x.csv", "x.csv"),
    record("a cell too many", "time_s,acceleration_g\n0,0,1\n1,0.1\n", 3, "x.csv", "x.csv"),
    mesh("a truncated mesh", "$MeshFormat\n4.1 0 8\n", "x.msh"),
    mesh("an empty mesh", "", "x.msh"),
    mesh("a script called mesh", 'SystemCall "touch PWNED";\n', "x.msh"),
    mesh("a script nobody allowed", "Point(1) = {0,0,0};\n", "--allow-script", "x.geo"),
    script("a script that includes a file", 'Include "other.geo";\n', "Include in line 1 leaves the script"),
    script("a script that merges a file", 'Point(1) = {0,0,0};\nMerge "other.step";\n', "Merge in line 2 leaves the script"),
    script("a script that ends its reader", "Exit;\n", "Exit in line 1 leaves the script"),
    Row("names", "a name that climbs", ["reduced", "x.toml"], 2, "name", ("x.toml", 'name = "../../x"\n' + FREE), kept="x.toml"),
    Row("names", "a name of markup", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", 'name = "<script>alert(1)"\n' + FREE), kept="x.toml"),
    Row("names", "a name of 300 characters", ["reduced", "x.toml"], 0, "", ("x.toml", f'name = "{"n" * 300}"\n' + FREE), kept="x.toml"),
    Row("names", "a name that steers the terminal", ["check", "x.toml"], 0, "", ("x.toml", 'name = "a\\u001b[31m"\n' + FREE)),
    Row("process", "a limit on file sizes, its signal ignored", ["reduced", "x.toml", "-o", "o"], 6, "", ("x.toml", FREE), ignoring_the_signal, "x.toml"),
    Row("process", "a limit on file sizes", ["reduced", "x.toml", "-o", "o"], 6, "", ("x.toml", FREE), limits(resource.RLIMIT_FSIZE, 4096), "x.toml"),
    Row("process", "two records of one name to be drawn", ["motion", "x.AT2", "./x.AT2", "--png", "p"], 2, "both be drawn",
        ("x.AT2", AT2 + "NPTS= 3, DT= .01 SEC\n .1 .2 .1\n"), kept="x.AT2"),
    Row("process", "a capacity of nan", ["compare", "x.toml", "x.toml", "--capacity-mm", "nan"], 2, "capacity-mm nan", ("x.toml", FREE), kept="x.toml"),
    Row("process", "a mass ratio of nan", ["design", "--displacement-m", "0.3", "--gamma", "nan"], 2, "gamma", ("x.toml", FREE)),
    Row("process", "an address space of 400 MB", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), limits(resource.RLIMIT_AS, 400 << 20), "x.toml"),
    Row("process", "finite elements in 500 MB", ["run", "impact-window", "-o", "o"], 4, "500 MB", ("x.toml", FREE), limits(resource.RLIMIT_AS, 500 << 20), "x.toml"),
    Row("process", "finite elements in 950 MB", ["run", "impact-window", "--mesh", "1", "-o", "o"], 4, "limit of memory",
        ("x.toml", FREE), limits(resource.RLIMIT_AS, 950 << 20), "x.toml"),
    Row("process", "a hundred thousand threads", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), lambda: os.environ.update(RIMPACT_THREADS="100000"), "x.toml"),
    Row("process", "a pipe for a scene", ["check", "pipe"], 2, "a pipe", ("x.toml", FREE), lambda: os.mkfifo("pipe"), "x.toml"),
    Row("process", "a scene that cannot be read", ["check", "/proc/self/mem"], 2, "cannot be read", ("x.toml", FREE), None, "x.toml"),
    Row("process", "a rim pressed through", ["reduced", "impact-window", "--set", "excitation.speed_m_per_s=5", "--set", "reduced.k_i_kN_per_m=2e4", "-o", "o"], 0,
        "no bearing does so", ("x.toml", FREE)),
    Row("process", "ten file handles", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), limits(resource.RLIMIT_NOFILE, 10), "x.toml"),
    Row("process", "a read-only folder", ["reduced", "x.toml", "-o", "o"], 6, "cannot create the folder o", ("x.toml", FREE), in_a_read_only_folder, "x.toml"),
    Row("process", "a picture into a read-only folder", ["motion", "x.AT2", "--png", "p"], 6, "p",
        ("x.AT2", AT2 + "NPTS= 3, DT= .01 SEC\n .1 .2 .1\n"), in_a_read_only_folder, "x.AT2"),
    Row("process", "a sweep in a read-only folder", ["reduced", "x.toml", "--sweep", "reduced.mu_fast=0.05:0.06:2", "-o", "o"], 6, "o",
        ("x.toml", FREE), in_a_read_only_folder, "x.toml"),
    Row("process", "no terminal", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), without_a_terminal, "x.toml"),
    Row("process", "no terminal, and a mistake", ["reduced", "x.toml", "--mesg", "-o", "o"], 2, "error: ", ("x.toml", FREE), without_a_terminal, "x.toml"),
    Row("process", "no input stream", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), lambda: os.close(0), "x.toml"),
    Row("process", "a locale of decimal commas", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), where_commas_are_decimal, "x.toml"),
    Row("process", "a device for a folder", ["reduced", "x.toml", "-o", "/dev/full/o"], 6, "/dev/full/o", ("x.toml", FREE), kept="x.toml"),
    Row("process", "ranks that are none", ["run", "x.toml", "--ranks", "0"], 2, "--ranks 0", ("x.toml", FREE), kept="x.toml"),
    Row("process", "no output stream", ["reduced", "x.toml", "-o", "o"], 0, "", ("x.toml", FREE), lambda: os.close(1), "x.toml"),
]


def counts():
    areas = collections.Counter(row.area for row in ROWS)
    return "".join(f"{area}: {count}\n" for area, count in areas.items()) + f"all: {len(ROWS)}, of them known to fail: {sum(row.open for row in ROWS)}\n"


def wrong_with(row):
    """What is wrong with the answer to a row; empty where nothing is."""
    with tempfile.TemporaryDirectory() as folder:
        content = row.file[1] if isinstance(row.file[1], bytes) else row.file[1].encode()
        with open(os.path.join(folder, row.file[0]), "wb") as file:
            file.write(content)
        try:
            run = subprocess.run([os.environ["RIMPACT"], *row.words], cwd=folder, capture_output=True, timeout=SECONDS, preexec_fn=row.limit, check=False)
        except subprocess.TimeoutExpired:
            return f"still running after {SECONDS} s"
        said = (run.stdout + run.stderr).decode(errors="replace")
        found = [f"exit code {run.returncode}, not {row.code}"] if run.returncode != row.code else []
        found += [f'"{row.says}" is not said'] if row.says not in said else []
        found += ["an escape sequence reaches the terminal"] if "\033" in said else []
        found += ["a line is rewritten where no terminal is"] if "\r" in said else []
        found += ["a traceback"] if "Traceback" in said else []
        found += ["a foreign program ran"] if os.path.exists(os.path.join(folder, "PWNED")) else []
        if row.kept:
            with open(os.path.join(folder, row.kept), "rb") as file:
                found += [f"{row.kept} was changed"] if file.read() != content else []
        csv = os.path.join(folder, "o", "response.csv")
        if run.returncode == 0 and os.path.exists(csv):
            with open(csv, encoding="utf-8") as file:
                found += ["nan in response.csv"] if "nan" in file.read().lower() else []
        return "; ".join(found) and "; ".join(found) + "\n" + said[-600:]


class Hostile(unittest.TestCase):
    def test_every_row(self):
        findings = 0
        for row in ROWS:
            with self.subTest(f"{row.area}: {row.name}"):
                wrong = wrong_with(row)
                findings += bool(wrong)
                print(f"{'FINDING' if wrong else 'holds  '} {row.area:8} {row.name}{' (known)' if row.open else ''}")
                if row.open:
                    self.assertNotEqual(wrong, "", "the row holds now: take its mark away")
                else:
                    self.assertEqual(wrong, "")
        print(f"{len(ROWS)} rows, {findings} findings")

    def test_the_names_are_unique(self):
        self.assertEqual(len({(row.area, row.name) for row in ROWS}), len(ROWS))

    def test_the_docs_give_the_counts(self):
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/verification.md"), encoding="utf-8") as file:
            self.assertIn(f"```\n{counts()}```", file.read())


if __name__ == "__main__":
    if "--list" in sys.argv:
        sys.stdout.write(counts())
    else:
        unittest.main()
