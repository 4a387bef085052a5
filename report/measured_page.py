"""The report of a laboratory's table: a mapping file, as `rimpact calibrate` and `rimpact compare` take it.

The table is read by the command itself (units, decimal commas, encodings are its business): here its curves are drawn."""
import os
import shutil
import subprocess
import tempfile

from . import interactive, page
from .blocks import Pictures, Section, bullets, note, table
from .data_files import read_any_json
from .errors import DataError, InputError, IoError
from .figures import impacts, response_panels
from .mapping_file import parts_of
from .numbers import fixed, integer, scaled
from .run_folder import Run, load_run
from .series import contact_stretches, impact_curve

ERRORS = {2: InputError, 3: DataError}


def program() -> str:
    """RIMPACT_PROGRAM, else the command that started this process, else the one in PATH."""
    try:
        parent = os.readlink(f"/proc/{os.getppid()}/exe")
    except OSError:
        parent = ""
    for each in (os.environ.get("RIMPACT_PROGRAM"), parent if os.path.basename(parent) == "rimpact" else None, shutil.which("rimpact")):
        if each and os.access(each, os.X_OK):
            return each
    raise InputError("the command rimpact was not found; set RIMPACT_PROGRAM to it")


def read(path: str) -> Run:
    """The table's curves as the command reads them; its own sentence where it refuses them."""
    with tempfile.TemporaryDirectory(prefix="rimpact-measured-") as folder:
        try:
            done = subprocess.run([program(), "compare", path, path, "-o", folder], capture_output=True, text=True, errors="replace", timeout=300)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise IoError(f"{path} was not read: {error}") from None
        if done.returncode:
            said = [line.removeprefix("error: ") for line in done.stderr.splitlines() if line.startswith("error: ")]
            raise ERRORS.get(done.returncode, IoError)((said or [f"{path} was not read"])[-1])
        run = load_run(os.path.join(folder, "curves", "A"), os.path.basename(_stem(path)))
        run.meta.setdefault("version", str(read_any_json(os.path.join(folder, "compare.json")).get("version", "")))
        return run


def _stem(path: str) -> str:
    """The mapping file without its ending, and the test's name where it has several."""
    file, test = parts_of(path)
    return os.path.splitext(file)[0] + (f"-{test}" if test else "")


def build(path: str, output: str | None) -> tuple[str, list[str]]:
    """Gives the report's path and the list of problems. Throws InputError where `output` lies inside the mapping file."""
    if output and os.path.abspath(os.path.dirname(output)) == os.path.abspath(path):
        raise InputError(f"{path} is a file: say where its report goes, -o FILE.html")
    output = output or _stem(path) + ".html"
    run = read(path)
    problems: list[str] = []
    pictures = Pictures(os.path.join(os.path.dirname(os.path.abspath(output)), "figures"), problems)
    models, labels = [("A", run)], {"A": run.name}
    curves = Section("curves", "Curves", lead="As measured, in SI. Forces are drawn as −F.")
    curves.add(pictures.figure(f"response-{run.name}", "", response_panels.draw, models, labels, run.lateral_capacity, curves=interactive.response))
    zoom = pictures.figure(f"impacts-{run.name}", "Rim force through each impact, the first four.", impacts.draw, models, labels, curves=interactive.impacts)
    curves.add(zoom or note("No rim force is measured."))
    numbers = Section("numbers", "Numbers")
    numbers.add(_peaks(run))
    numbers.add(_impacts(run))
    numbers.add(bullets([f"{len(run.time)} instants, one every {fixed(1e3 * float(run.time[-1] - run.time[0]) / (len(run.time) - 1), 3)} ms.",
                         f"Signals: {', '.join(sorted(run.signals))}."]))
    page.write(output, "page.html.j2", title=f"Measured curve {run.name}", subtitle=path, sections=[curves, numbers], problems=problems,
               footer=run.meta.get("version", ""))
    return output, problems


def _peaks(run: Run) -> dict | None:
    names = (("displacement", "largest displacement (mm)", 1e3, 2), ("force", "largest lateral force (kN)", 1e-3, 1), ("impact", "largest rim force (kN)", 1e-3, 1))
    rows = [[title, scaled(float(run.norm(name).max()), factor, digits)] for name, title, factor, digits in names if run.has(f"{name}_x", f"{name}_y")]
    return table(["", run.name], rows, compact=True)


def _impacts(run: Run) -> dict | None:
    rows = []
    for number, part in enumerate(contact_stretches(run), 1):
        time, force, depth = impact_curve(run, part)
        rows.append([integer(number), fixed(float(run.time[part.start]), 4), scaled(float(time[-1]), 1e3, 1), scaled(float(force.max()), 1e-3, 1),
                     scaled(float(depth.max()), 1e3, 2)])
    return table(["stretch of rim force", "from (s)", "lasts (ms)", "largest force (kN)", "penetration (mm)"], rows[:24],
                 caption="" if len(rows) <= 24 else f"The first 24 of {len(rows)}.") if rows else None
