"""python3 -m report.thesis.keep DIR [CALIBRATION]: takes the numbers found in DIR (rimpact thesis ... -o DIR) into data/thesis/ours.json, those found
with --calibration CALIBRATION into data/thesis/refitted.json, and writes docs/thesis.md anew.

What the catalogue no longer has is dropped. For the source tree only."""
import glob
import json
import os
from typing import Any

from ..data_files import read_any_json
from ..errors import run_main
from ..files import write_whole
from . import catalogue as catalogues
from . import document, refitted
from .catalogue import Catalogue
from .results import KEPT, WITHOUT, Ours


def _numbers(catalogue: Catalogue, ours: Ours) -> dict[str, dict[str, float]]:
    kept = {entry.id: {what: value for number in entry.numbers
                       for what, value in ((number.what, ours.of(entry, number)), (number.what + WITHOUT, ours.without_cause(entry, number)))
                       if value is not None} for entry in catalogue.entries}
    return {name: numbers for name, numbers in kept.items() if numbers}


def _law(folder: str) -> str:
    """In words: the bearing, the law and one rim's stiffness."""
    answer = read_any_json(os.path.join(folder, "calibration.json"))["answer"]
    law, rims = answer["law"], answer.get("rims_in_series", 1)
    k_i = rims * law["element"]["k_i"]["value"]
    return (f"of `{answer['bearing']}`, law {law['name']}, {k_i:,.0f} kN/m of one rim at first touch, "
            f"fitted from {law['fitted_from_m_s']:.3g} to {law['fitted_to_m_s']:.3g} m/s")


def _write(path: str, values: dict[str, Any]) -> None:
    text = json.dumps(values, indent=1, sort_keys=True) + "\n"
    write_whole(path, lambda file: file.write(text.encode()))


def main(arguments: list[str]) -> None:
    folder, *calibration = arguments
    catalogue = catalogues.load()
    numbers = _numbers(catalogue, Ours(folder, refitted=bool(calibration)))
    if calibration:
        beyond = [read_any_json(path).get("beyond_fit") for path in glob.glob(os.path.join(folder, "runs", "*", "summary.json"))]
        _write(refitted.KEPT, {"law": _law(calibration[0]), "runs": len(beyond), "beyond_fit": sum(map(bool, beyond)), "numbers": numbers})
    else:
        _write(KEPT, numbers)
    document.main([os.path.join(os.path.dirname(catalogues.FOLDER), "docs", "thesis.md")])


if __name__ == "__main__":
    run_main(main)
