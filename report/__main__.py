"""python3 -m report DIR [--output FILE]: the report of a run folder or of a `rimpact main` results folder."""
import argparse

from .errors import run_main


def main(arguments):
    parser = argparse.ArgumentParser(prog="rimpact report", description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE", help="DIR/report.html when not given")
    options = parser.parse_args(arguments)
    from .build import build  # after the command line: matplotlib takes a second to load
    path, _ = build(options.folder, options.output)
    print(path)


run_main(main)
