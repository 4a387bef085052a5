"""The report's sections, in order: one file each, one line here. make(context) gives a Section, or None when there
is nothing to say."""
from . import (answer, calibration, comparison, conventions, critical, energy, histories, inputs, laws, reproducibility,
               rim, speed, stack, windows)
from .answer import head  # noqa: F401  (the page's title)

CATALOGUE = [
    answer.make,
    inputs.make,
    histories.make,
    stack.make,
    rim.make,
    windows.make,
    calibration.make,
    laws.make,
    comparison.make,
    critical.make,
    energy.make,
    speed.make,
    reproducibility.make,
    conventions.make,
]
