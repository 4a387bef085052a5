"""An HTML page from a template of this package, written whole or not at all."""
import os

import jinja2

from .files import write_whole
from .markup import sentence

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")


def write(path, template, **content):
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters["sub"] = sentence
    html = environment.get_template(template).render(**content)
    write_whole(path, lambda file: file.write(html.encode("utf-8", "replace")))
