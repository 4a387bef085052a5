"""python3 -m report.thesis WHAT --program RIMPACT --output DIR [--records DIR] [--jobs N] [--cheap] [--calibration DIR] [--json]: list, headlines, one figure or table, or all."""
import argparse
import json
import os

from ..errors import InputError, run_main
from . import catalogue as catalogues
from . import headlines, tables
from .results import Ours


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="rimpact thesis", description=__doc__)
    parser.add_argument("what")
    parser.add_argument("--program", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--records", default=os.environ.get("RIMPACT_RECORDS", "."))
    parser.add_argument("--jobs", type=int, default=0, help="runs side by side (0: one a core)")
    parser.add_argument("--calibration", default="", help="folder of a calibration, whose law the rims of two dishes have")
    for flag in ("--cheap", "--json", "--quiet"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args(arguments)
    if not os.path.isdir(options.records):
        raise InputError(f"--records {options.records} is no folder")
    if options.calibration and not os.path.isfile(os.path.join(options.calibration, "calibration.json")):
        raise InputError(f"--calibration {options.calibration} holds no calibration.json")
    catalogue, ours = catalogues.load(), Ours(options.output, bool(options.calibration))
    if options.what == "list":
        print(json.dumps(tables.list_json(catalogue, ours), indent=1, ensure_ascii=False) if options.json else tables.list_text(catalogue, ours))
        return
    if options.what == "headlines":
        print(json.dumps(headlines.as_json(catalogue, ours), indent=1, ensure_ascii=False) if options.json else headlines.as_text(catalogue, ours))
        return
    entries = catalogue.entries if options.what == "all" else [catalogue.find(options.what)]
    if options.calibration:
        entries = [entry for entry in entries if any(catalogue.runs[name].has_two_dishes for name in entry.runs())]
        if not entries:
            raise InputError(f"{options.what} has no bearing of two dishes: it does not take a --calibration")
    from .make import make  # after the command line: matplotlib takes a second to load
    made = make(catalogue, ours, entries, options)
    if options.json:
        print(json.dumps(made, indent=1, ensure_ascii=False))


run_main(main, "thesis")
