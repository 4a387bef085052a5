"""The compiled module `_core`, asked for first: where it is missing or would give wrong arrays, importing rimpact ends here and says what to do."""
import sys
from pathlib import Path

import numpy as np

try:
    import rimpact._core as _core
except ModuleNotFoundError as error:
    raise ImportError(f"{Path(__file__).parent} holds no compiled module _core for Python {sys.version_info.major}.{sys.version_info.minor}: `pip install .` "
                      "in the source tree builds one; so does ./run, after which PYTHONPATH=build/release/python finds it") from error

if int(np.__version__.split(".")[0]) > 1 and not _core.knows_numpy_2:
    raise ImportError(f"{_core.__file__} was compiled with a pybind11 before 2.12, whose arrays are wrong under NumPy {np.__version__}: take the system's NumPy, or "
                      "`pip install .` in the source tree")

version = _core.__version__
