"""python3 -m report DIR [--output FILE] [--title ...] [--pdf]: the report of a run folder, of a `rimpact main` results folder, of
a calibration, of a sweep, of a reliability study or of a laboratory's curve (its mapping file, with --output)."""
import argparse
import os
import sys

from . import document
from .design_page import is_design
from .errors import InputError, run_main
from .fleet import is_fleet
from .mapping_file import is_mapping


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="rimpact report", description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE", help="DIR/report.html when not given")
    parser.add_argument("--document", metavar="FILE.toml", help="title, client, project and author")
    for key in document.KEYS:
        parser.add_argument(f"--{key}", default="")
    parser.add_argument("--language", metavar="LANGUAGE", help="two pages for the client instead: en, es, it, ja or tr")
    parser.add_argument("--pdf", action="store_true", help="a PDF beside the HTML file as well")
    options = parser.parse_args(arguments)
    given = document.of(vars(options))
    if options.document:
        given = given.or_else(document.read(options.document))
    if options.pdf and options.output and os.path.exists(options.output) and not os.path.isfile(options.output):
        raise InputError(f"--pdf prints an ordinary file; --output {options.output} is none")
    # After the command line: matplotlib takes a second to load.
    if options.language:
        _client(options, given)
        return
    if os.path.exists(os.path.join(options.folder, "reliability.json")):
        from .reliability.__main__ import build as build_reliability
        path, _ = build_reliability(options.folder, options.output)
    elif is_design(options.folder):
        from .design_page import build as build_design
        path, _ = build_design(options.folder, options.output or os.path.join(options.folder, "report.html"))
    elif not os.path.isdir(options.folder) and is_mapping(options.folder):
        from .measured_page import build as build_measured
        path, _ = build_measured(options.folder, options.output)
    elif is_fleet(options.folder):
        from .fleet_page import build as build_fleet
        path, _ = build_fleet(options.folder, options.output)
    else:
        from .build import build
        path, _ = build(options.folder, options.output, given)
    print(path)
    if options.pdf:
        _print(path)


def _client(options: argparse.Namespace, given: document.Document) -> None:
    from . import client
    from .client import fonts
    path, problems = client.build(options.folder, options.language, options.output, given)
    print(path)
    for problem in problems:
        print(f"rimpact report: {problem}", file=sys.stderr)
    unwritable = fonts.missing(options.language)
    if unwritable:
        print(f"rimpact report: {unwritable}", file=sys.stderr)
    elif options.pdf:
        _print(path)


def _print(html: str) -> None:
    from .pdf import print_to
    path = os.path.splitext(html)[0] + ".pdf"
    missing = print_to(html, path)
    print(f"rimpact report: {missing}", file=sys.stderr) if missing else print(path)


run_main(main)
