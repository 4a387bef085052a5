#include "calibration/laws/no_tension_pair.h"
#include "calibration/laws/windows_table.h"
#include "laws/impact/catalogue.h"
#include <cmath>
#include <numbers>

namespace rimpact::calibration {

namespace {
constexpr double smallest_e = 0.01; // below it a fit does not look either
} // namespace

double no_tension_rebound(double e) {
  const double b = std::asin(laws::damping_ratio(e));
  return std::exp(-(std::numbers::pi - 2 * b) * std::tan(b));
}

std::optional<Pair> no_tension_pair(double peak, double rebound, double speed, double mass) {
  if (!(peak > 0) || rebound > 1 || rebound < no_tension_rebound(smallest_e)) return {};
  double low = smallest_e, high = 1; // the rebound grows with e
  for (int n = 0; n < 60; ++n) {
    const double e = (low + high) / 2;
    (no_tension_rebound(e) < rebound ? low : high) = e;
  }
  const double e = (low + high) / 2, root = peak / (speed * laws::kelvin_voigt_peak(e));
  return Pair{root * root / mass, e};
}

} // namespace rimpact::calibration
