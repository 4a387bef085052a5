"""The chapters behind the first page, in order: one file each, one line here. make(context) gives a Section, or None where
there is nothing to say; a Section without blocks is left out too."""
from . import (
    building,
    building_on_bearings,
    comparison,
    conventions,
    critical,
    energy,
    fields,
    film,
    histories,
    inputs,
    laws,
    measured,
    other_fits,
    reproducibility,
    rim,
    speed,
    stack,
    windows,
)
from .head import head  # noqa: F401  (the page's title)

CATALOGUE = [
    inputs.make,
    histories.make,
    building.make,
    building_on_bearings.make,
    measured.make,
    stack.make,
    rim.make,
    film.make,
    windows.make,
    laws.make,
    comparison.make,
    critical.make,
    energy.make,
    speed.make,
    fields.make,
    reproducibility.make,
    conventions.make,
    other_fits.make,
]
