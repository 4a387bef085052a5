"""python3 -m report.thesis.document FILE: writes docs/thesis.md of the catalogue and its kept numbers."""
from ..errors import run_main
from ..files import write_whole
from . import catalogue, tables
from .results import Ours


def text() -> str:
    return tables.document(catalogue.load(), Ours("/nonexistent"))


def main(arguments: list[str]) -> None:
    write_whole(arguments[0], lambda file: file.write(text().encode()))


if __name__ == "__main__":
    run_main(main)
