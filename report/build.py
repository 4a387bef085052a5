"""From a results folder to report.html: read, draw, fill the template, write."""
import os

from . import first_page, page, sections
from .context import Context
from .document import Document


def build(folder: str, output: str | None = None, given: Document | None = None) -> tuple[str, list[str]]:
    """Writes the report and its pictures (DIR/figures/); gives the report's path and the list of problems.
    `given`: what the command line says of title, client, project and author."""
    output = output or os.path.join(folder, "report.html")
    ordinary = not os.path.exists(output) or os.path.isfile(output)
    context = Context(folder, os.path.join(folder, "figures"), os.path.dirname(os.path.abspath(output)) if ordinary else folder)
    context.pictures.begin()
    first = first_page.make(context)
    made = [section for section in (make(context) for make in sections.CATALOGUE) if section is not None and section.blocks]
    context.pictures.finish()
    page.write(output, "report.html.j2", head=sections.head(context, given or Document()), page=first, sections=made,
               problems=list(dict.fromkeys(context.problems)))
    return output, context.problems
