"""The head of the first page: title, whose report it is, date and version, with what the results say where nothing is given."""
from typing import Any

from .. import document
from ..context import Context
from ..document import Document
from ..results import Results
from .common import title_of


def head(context: Context, given: Document) -> dict[str, Any]:
    results = context.results
    said = given.or_else(document.of(results.main.get("document", {})))
    title, subtitle = _defaults(context)
    version = _version(results)
    facts = [(name, getattr(said, key)) for name, key in (("Client", "client"), ("Project", "project"), ("Author", "author")) if getattr(said, key)]
    facts += [("Date", document.today())] + ([("Version", f"rimpact {version}")] if version else [])
    return {"title": said.title or title, "subtitle": subtitle if not said.title else f"{title}. {subtitle}".strip(". "),
            "facts": facts, "date": document.today(), "version": f"rimpact {version}".strip()}


def _defaults(context: Context) -> tuple[str, str]:
    """(title, subtitle) of a report nobody named."""
    results = context.results
    bearing = context.scene.get("bearing", {}).get("name") or results.answer.get("bearing")
    bearing = context.rigid_bodies if context.rigid_bodies else f"bearing {bearing}" if bearing else "friction-pendulum bearing"
    if results.single:
        run = results.only
        kind = "reduced model" if run.rung == "reduced" else f"finite elements, rung {run.rung}"
        return title_of(run.name), f"One run of {bearing}, {kind}"
    if context.measured:
        return f"Rim impact of {bearing}", "Impact law fitted to measured curves"
    source = "finite-element" if any(entry.fe is not None for entry in results.entries) or results.answer.get("source") == "finite elements" else ""
    if not results.calibration:
        return f"Rim impact of {bearing}", f"{source.capitalize()} runs" if source else "Runs"
    return f"Rim impact of {bearing}", f"Impact law fitted to {source + ' ' if source else ''}runs"


def _version(results: Results) -> str:
    version = results.main.get("versions", {}).get("rimpact")
    return version or next((entry.any_run.meta["version"] for entry in results.entries
                            if entry.any_run and entry.any_run.meta.get("version")), "")
