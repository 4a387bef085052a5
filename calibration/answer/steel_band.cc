#include "calibration/answer/steel_band.h"

#include "calibration/laws/percent.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// "12 to 27 %" or "27 %": the smallest and the largest change, without signs.
std::string span(const SteelBand &band, double (SteelTwin::*ratio)() const) {
  double low = 1e300, high = 0;
  for (const SteelTwin &twin : band.twins) {
    const double change = 100 * std::abs((twin.*ratio)() - 1);
    low = std::min(low, change), high = std::max(high, change);
  }
  const std::string from = fmt::format("{:.0f}", low), to = fmt::format("{:.0f}", high);
  return from == to ? to + " %" : from + " to " + to + " %";
}

/// Whose constants the law of the rate has.
const char *origin(const SteelBand &band) {
  if (!band.assumed) return ", from the bearing's file";
  scene::StrainRate mild;
  mild.model = band.rate.model;
  return band.rate == mild ? ", mild steel's constants, an assumption" : ", the grade's constants, an assumption";
}

} // namespace

double SteelBand::largest(double (SteelTwin::*ratio)() const) const {
  double result = 0;
  for (const SteelTwin &twin : twins) result = std::max(result, std::abs((twin.*ratio)() - 1));
  return result;
}

std::vector<std::string> sentences(const SteelBand &band) {
  const double low = band.twins.front().speed, high = band.twins.back().speed;
  return {fmt::format("Steel that knows its strain rate raises the peak force by {} and lowers the depth by {}, from "
                      "{:.3g} to {:.3g} m/s.",
                      span(band, &SteelTwin::force_ratio), span(band, &SteelTwin::depth_ratio), low, high),
          fmt::format("Its law: {}{}.", in_words(band.rate), origin(band)),
          "Take the static steel for the travel, the fast one for the force."};
}

} // namespace rimpact::calibration
