"""python3 -m report.reliability DIR: DIR/report.html of a reliability study, pictures in DIR/figures."""
import argparse
import os

from ..errors import DataError, run_main
from ..page import write
from .page import Page


def build(folder: str, output: str | None = None) -> tuple[str, list[str]]:
    """Writes the report; gives its path and the sentences of what could not be drawn."""
    output = output or os.path.join(folder, "report.html")
    try:
        page = Page(folder)
        sections = page.sections()
    except (KeyError, TypeError, ValueError) as error:
        raise DataError(f"{folder}: the tables of the study are incomplete ({error!r})") from None
    write(output, "reliability.html.j2", title=f"Reliability: {page.summary['study']}", sections=sections, problems=page.problems)
    return output, page.problems


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="report.reliability", description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="FILE", help="DIR/report.html when not given")
    options = parser.parse_args(arguments)
    print(build(options.folder, options.output)[0])


if __name__ == "__main__":
    run_main(main)
