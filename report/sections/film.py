"""The film of a run's stored fields, written beside the report; of several runs, of the one with most instants."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING

from .. import film
from ..blocks import Section, text
from ..errors import DataError
from ..stored_fields import instants
from .common import title_of

if TYPE_CHECKING:
    from ..context import Context


def make(context: Context) -> Section | None:
    try:
        found = [(len(film.longest(instants(entry.fe))), entry.name, entry.fe) for entry in context.results.entries if entry.fe is not None]
        most, name, run = max(found, key=lambda item: item[0], default=(0, "", None))
        if run is None or most < film.LEAST:
            return None
        files = film.make(run, os.path.join(context.beside, "film.html"), film.FRAMES)
    except DataError as error:
        context.problems.append(f"film: {error}")
        return None
    section = Section("film", "Film")
    names = " and ".join(f"`{os.path.basename(file)}`" for file in files)
    section.add(text(f"{title_of(name)}: {names} beside this report {'plays' if len(files) == 1 else 'play'} {most} stored instants in equal steps of time."))
    return section
