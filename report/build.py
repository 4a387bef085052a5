"""From a results folder to report.html: read, draw, fill the template, write."""
import os
import re

import jinja2
from markupsafe import Markup, escape

from . import calibration_file, sections
from .blocks import Pictures
from .errors import IoError
from .results import load_results

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")


def with_subscripts(value):
    """L_c, k_i, u_z ... in running text as proper subscripts."""
    return Markup(re.sub(r"(?<![\w.])([A-Za-zΔμ])_([a-z]{1,3})(?![\w])", r"<i>\1</i><sub>\2</sub>", str(escape(value))))


class Context:
    """Everything a section may read, and where it puts its pictures."""

    def __init__(self, folder, figures):
        self.results = load_results(folder)
        self.calibration = calibration_file.read(self.results.calibration)
        for entry in self.results.entries:  # main.json tells the roles; without it the calibration does
            if entry.role == "history":
                entry.role = self.calibration.role(entry.name) or entry.role
        self.problems = self.results.problems
        self.pictures = Pictures(figures, self.problems)


def build(folder, output=None):
    """Writes the report and its pictures (DIR/figures/); gives the report's path and the list of problems."""
    output = output or os.path.join(folder, "report.html")
    context = Context(folder, os.path.join(folder, "figures"))
    made = [section for section in (make(context) for make in sections.CATALOGUE) if section is not None]
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters["sub"] = with_subscripts
    page = environment.get_template("report.html.j2").render(
        head=sections.head(context), sections=made, problems=list(dict.fromkeys(context.problems)))
    _write(output, page)
    return output, context.problems


def _write(path, page):
    """Beside the final name, then renamed: a full disk leaves an earlier report readable."""
    try:
        with open(path + ".part", "w", encoding="utf-8") as file:
            file.write(page)
            file.flush()
            os.fsync(file.fileno())
        os.replace(path + ".part", path)
    except OSError as error:
        raise IoError(f"cannot write {path}: {error.strerror}") from None
