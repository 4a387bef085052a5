/// Least of a function of one variable.
#pragma once
#include <cmath>

namespace rimpact::calibration {

/// Where `cost` is least between `low` and `high`; it must have one minimum there.
template <class Cost> double golden_section(double low, double high, Cost cost) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 80; ++i) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    if (cost(a) < cost(b))
      high = b;
    else
      low = a;
  }
  return (low + high) / 2;
}

} // namespace rimpact::calibration
