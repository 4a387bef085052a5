"""Ground-motion records, as the command understands them."""
from __future__ import annotations

import json
import os
import tempfile
from pathlib import Path

import pandas as pd

from rimpact import program


def motion(*names: str | os.PathLike) -> pd.DataFrame:
    """What is in records, files or folders of them, as `rimpact motion` says: a row each. `doubts` is a list of sentences, `pair` the
    other horizontal component, None where there is none; numbers of a record that cannot be read are NaN.

    >>> times = np.arange(0, 4, 0.01)
    >>> written = rimpact.write_record("one.csv", times, 2.0 * np.sin(9 * times) * np.exp(-times))
    >>> float(rimpact.motion("one.csv").npts[0])
    400.0
    """
    return pd.DataFrame(json.loads(program.run("motion", *map(os.fspath, names), "--json")))


def spectrum(*names: str | os.PathLike, target: str | None = None) -> pd.DataFrame:
    """Response spectra of records with 5 % damping, as `rimpact motion --spectrum` makes them: a row a component and period, with `sa_g`, of
    pairs `rotd50_g` and `rotd100_g`, and `target_g` where `target` ("asce7,S_DS=1.0,S_D1=0.6,T_L=8", "en1998,a_g=0.3,ground=B") is given.

    >>> times = np.arange(0, 8, 0.01)
    >>> written = rimpact.write_record("wave.csv", times, 2.0 * np.sin(6.2 * times))
    >>> found = rimpact.spectrum("wave.csv").set_index("period_s").sa_g
    >>> bool(0.9 < found.idxmax() < 1.1)                   # a sine of about one second
    True
    """
    with tempfile.TemporaryDirectory() as place:
        program.run("motion", *map(os.fspath, names), "--spectrum", place, "--quiet", *(["--target", target] if target else []))
        return pd.read_csv(Path(place) / "spectrum.csv", float_precision="round_trip")
