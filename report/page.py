"""An HTML page from a template of this package, written whole or not at all."""
import functools
import itertools
import os
import string
from typing import Any

import jinja2

from .blocks import Section
from .files import write_whole
from .markup import sentence

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")


SCRIPTS = {"curves": "plot.js", "model": "view3d.js", "frames": "film.js"}  #: by the part of a block that needs one


def _scripts(sections: list[Section]) -> list[str]:
    return [script for part, script in SCRIPTS.items() if any(block.get(part) for section in sections for block in section.blocks)]


@functools.cache
def _environment() -> jinja2.Environment:
    """It keeps the templates it has compiled, which takes longer than to fill them."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters["sub"] = sentence
    return environment


def _number(sections: list[Section]) -> None:
    """1, 2, ... and, for appendices, A, B, ..."""
    chapters, appendices = itertools.count(1), iter(string.ascii_uppercase)
    for section in sections:
        section.number = next(appendices) if section.appendix else str(next(chapters))


def write(path: str, template: str, **content: Any) -> None:
    sections = content.get("sections", [])
    for section in sections:
        section.blocks = [block for block in section.blocks if block]  # without figures that could not be painted
    _number(sections)
    html = _environment().get_template(template).render(scripts=_scripts(sections), **content)
    write_whole(path, lambda file: file.write(html.encode("utf-8", "replace")))
