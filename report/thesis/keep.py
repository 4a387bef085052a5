"""python3 -m report.thesis.keep DIR: takes the numbers found in DIR (rimpact thesis ... -o DIR) into data/thesis/ours.json and writes docs/thesis.md anew.

What the catalogue no longer has is dropped. For the source tree only."""
import json
import os

from ..errors import run_main
from ..files import write_whole
from . import catalogue as catalogues
from . import document
from .results import KEPT, WITHOUT, Ours


def main(arguments: list[str]) -> None:
    catalogue, ours = catalogues.load(), Ours(arguments[0])
    kept = {entry.id: {what: value for number in entry.numbers
                       for what, value in ((number.what, ours.of(entry, number)), (number.what + WITHOUT, ours.without_cause(entry, number)))
                       if value is not None} for entry in catalogue.entries}
    text = json.dumps({name: numbers for name, numbers in kept.items() if numbers}, indent=1, sort_keys=True) + "\n"
    write_whole(KEPT, lambda file: file.write(text.encode()))
    document.main([os.path.join(os.path.dirname(catalogues.FOLDER), "docs", "thesis.md")])


if __name__ == "__main__":
    run_main(main)
