"""The one page that can be sent: whose it is, the bearing, the load, what was done, the answer, where it holds, whether
the steel bears it, what was assumed, what is doubted. Everything else stands behind it.

make(context) gives what templates/first_page.html.j2 reads."""
from typing import Any

from ..context import Context
from . import answer, device, run
from .work import done


def make(context: Context) -> dict[str, Any]:
    results = context.results
    middle = run.make(context) if results.single else answer.make(context)
    judged = ((middle or {}).get("strain") or {}).get("sentence")  # it stands in a column of its own
    page = {"bearing": device.make(context), "done": done(context), "assumptions": device.assumptions(context),
            "doubts": [doubt for doubt in context.doubts.lines if doubt.sentence != judged], "middle": middle,
            "kind": "run" if results.single else "answer"}
    page["density"] = density(page)
    return page


def density(page: dict[str, Any]) -> str:
    """How close the page is set, so that all doubts fit on it: the more is said, the smaller it is."""
    said = sum(len(d.sentence) + sum(map(len, d.runs)) + 60 for d in page["doubts"])
    said += sum(len(str(part)) for part in page["assumptions"]) + sum(map(len, page["done"]))
    middle = page["middle"]
    if page["kind"] == "answer" and not middle["missing"]:  # its three columns are as long as the longest
        strain, band = middle["strain"] or {}, middle["band"] or {}
        judged = " ".join([strain.get("sentence", ""), *strain.get("beside", [])])
        columns = (middle["pair"]["sentence"], middle["holds"] + middle["mesh_error"], judged)
        said += 600 + 110 * len(middle["bars"]) if middle["bars"] else 0
        said += 100 * len(band.get("rows", [])) + sum(map(len, (*middle["findings"], *band.get("sentences", []), *strain.get("places", []))))
        said += 3 * max(0, max(map(len, columns)) - 200) + 60 * max(0, len(middle["numbers"]) - 4)
    return "plain" if said < 900 else "close" if said < 2000 else "closest" if said < 3000 else "closest dense"
