"""python3 -m report.references [NAME...] --program RIMPACT --output DIR [--list] [--json] [--quiet]: makes kept references again."""
import argparse
import json
import os
import sys

from ..errors import run_main
from ..files import write_whole
from .kept import chosen, references
from .remake import Remade, list_text, moved_text, remake

STOPPED = 4


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="rimpact references", description=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--program", required=True)
    parser.add_argument("--output", required=True)
    for flag in ("--list", "--json", "--quiet"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args(arguments)
    wanted = chosen(options.names, references())
    if options.list:
        rows = [{"name": r.name, "rung": r.summary["rung"], "mesh": r.summary["mesh"], "peak_impact_force_N": r.summary["peak_impact_force_N"],
                 "wall_time_s": r.wall_time_s, "folder": r.folder} for r in wanted]
        print(json.dumps(rows, indent=1) if options.json else list_text(wanted))
        return
    made: list[Remade] = []
    os.makedirs(options.output, exist_ok=True)
    for number, reference in enumerate(wanted, 1):
        if not options.quiet:
            print(f"{number} of {len(wanted)}: {reference.name} (some {reference.wall_time_s / 60:.0f} min when it was kept)", file=sys.stderr)
        made.append(remake(reference, options.program, options.output, options.quiet))
        text = json.dumps([each.as_json() for each in made], indent=1)
        write_whole(os.path.join(options.output, "references.json"), lambda file, text=text: file.write(text.encode()))
    print(text if options.json else moved_text(made))
    if any(each.problem for each in made):
        sys.exit(STOPPED)


run_main(main, "references")
