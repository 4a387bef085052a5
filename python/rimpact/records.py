"""Ground-motion records, as the command understands them."""
from __future__ import annotations

import json
import os

import pandas as pd

from rimpact import program


def motion(*names: str | os.PathLike) -> pd.DataFrame:
    """What is in records, files or folders of them, as `rimpact motion` says: a row each. `doubts` is a list of sentences, `pair` the
    other horizontal component, None where there is none; numbers of a record that cannot be read are NaN."""
    return pd.DataFrame(json.loads(program.run("motion", *map(os.fspath, names), "--json")))
