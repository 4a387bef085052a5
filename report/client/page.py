"""From a results or calibration folder to client-LANGUAGE.html, two pages of A4."""
import os
from typing import Any

from .. import page
from ..context import Context
from ..document import Document, today_as_number
from ..document import of as document_of
from ..errors import InputError
from ..figures import bearing as bearing_figure
from ..figures import law as law_figure
from ..style import plt
from . import facts, fonts
from .words import Words


def build(folder: str, language: str, output: str | None = None, given: Document | None = None) -> tuple[str, list[str]]:
    """Writes the page and its pictures (DIR/figures/); gives its path and the list of problems. Throws InputError where the folder
    holds no law to hand over."""
    words = Words(language)
    if not os.path.isdir(folder):
        raise InputError(f"{folder} is no folder: the client's pages are made of results of `main` or of a calibration")
    output = output or os.path.join(folder, f"client-{language}.html")
    context = Context(folder, os.path.join(folder, "figures"), os.path.dirname(os.path.abspath(output)))
    found = facts.of(context)
    if found["law"] is None:
        raise InputError(f"{folder} holds no fitted law: the client's pages are made of results of `main` or of a calibration")
    page.write(output, "client.html.j2", w=words, f=found, head=_head(context, given or Document(), words), pictures=_pictures(context, found, words),
               font=fonts.family_for(language) or "", version=context.results.main.get("versions", {}).get("rimpact", ""))
    return output, context.problems


def _head(context: Context, given: Document, words: Words) -> dict[str, Any]:
    known = given.or_else(document_of(context.results.main.get("document", {})))
    facts_of = [(key, getattr(known, key)) for key in ("client", "project", "author") if getattr(known, key)]
    return {"title": known.title or words("title"), "facts": [*facts_of, ("date", today_as_number())]}


def _pictures(context: Context, found: dict[str, Any], words: Words) -> dict[str, Any]:
    """Labelled in the language where a font has its letters, else in English."""
    family = fonts.family_for(words.language)
    spoken = words if family is not None else Words("en")
    labels = {key: spoken(key) for key in ("at_rest", "at_touch", "dish_short", "rim_short", "rim_force", "penetration", "law_name")}
    name = found["law"]["name"]
    labels["law"] = spoken(name) if spoken.has(name) else name
    sources = [spoken(part) if spoken.has(part) else part for part in found["source"]]
    labels["source"] = ", ".join(sources)
    bearing = context.scene.get("bearing") if not context.rigid_bodies else None
    draw, prefix = context.pictures.figure, f"client-{words.language}"
    with plt.rc_context({"font.sans-serif": [*([family] if family else []), *plt.rcParams["font.sans-serif"]]}):
        section = draw(f"{prefix}-bearing", "", bearing_figure.draw, bearing, context.capacity, context.whole_bearing, labels=labels) if bearing else None
        law = draw(f"{prefix}-law", "", law_figure.draw, context.results.impacts, name, labels=labels, number=spoken.number)
    return {"section": section, "law": law}
