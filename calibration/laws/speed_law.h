/// k_i and e as functions of the approach speed, where one constant pair does not serve.
#pragma once
#include "calibration/laws/windows_table.h"

namespace rimpact::calibration {

/// value = coefficient (v / 1 m/s)^exponent, fitted to the logarithms; `largest_error` of it, relative.
struct SpeedLaw {
  std::string name, unit;
  double coefficient, exponent, largest_error;
  double from, to; ///< speeds it was fitted to [m/s]
};
/// One law for each fitted parameter; empty with fewer than three windows at different speeds, or where a
/// window does not identify the parameter.
std::vector<SpeedLaw> speed_laws(const WindowsTable &table);

} // namespace rimpact::calibration
