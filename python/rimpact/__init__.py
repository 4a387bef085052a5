"""Rim impacts of friction-pendulum bearings: read runs into pandas, fly reduced models in-process, calibrate, call a law.

>>> import rimpact
>>> run = rimpact.run_reduced(rimpact.Scene("ricker-0.78g-1.0s", {"excitation.scale": 1.05}))
>>> run.summary["peak_impact_force_N"]          # a dict, as summary.json
>>> run.response.displacement_x                 # a pandas column over time [s]
>>> rimpact.load("results/main/runs/window-0.50").impacts
>>> law = rimpact.law("results/main/calibration")
>>> law(2e-3)                                   # N at 2 mm of first loading

Units are SI throughout; names are those of response.h5. Signs and terms: docs/interface.md.
"""
from rimpact import compiled  # first: it says what to do where the compiled module is missing
from rimpact.arrays import with_record, write_record
from rimpact.calibration import Calibration, calibrate
from rimpact.comparison import Comparison, compare
from rimpact.errors import DataError, Error, GateError, InputError, OutputError, Stopped
from rimpact.laws import Law, law
from rimpact.measured import Measured
from rimpact.records import motion, spectrum
from rimpact.results import Fleet, Run, load, load_fleet
from rimpact.scene import Scene, bearing_names, run_reduced, scene_names, summarise
from rimpact.studies import Building, Reliability, building, reliability, thesis
from rimpact.work import export, geometry, run, sweep

__all__ = ["Building", "Calibration", "Comparison", "DataError", "Error", "Fleet", "GateError", "InputError", "Law", "Measured", "OutputError", "Reliability",
           "Run", "Scene", "Stopped", "bearing_names", "building", "calibrate", "compare", "export", "geometry", "law", "load", "load_fleet",
           "motion", "reliability", "run", "run_reduced", "scene_names", "spectrum", "summarise", "sweep", "thesis", "with_record", "write_record"]
__version__ = compiled.version
