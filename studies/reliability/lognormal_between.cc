#include "studies/reliability/lognormal_between.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reliability {
namespace {

constexpr double endless = 1e6; // [1/year]: a rate above it is no bound

} // namespace

Fragility lognormal_between(double low, double p_low, double high, double p_high) {
  const double from = standard_score(p_low), to = standard_score(p_high), width = std::log(high / low);
  return [=](double x) {
    return normal_probability(std::lerp(from, to, std::clamp(std::log(x / low) / width, 0.0, 1.0)));
  };
}

std::optional<double> rate_below_first(const HazardCurve &hazard, double first, double p, double deviation) {
  if (p <= 0) return 0;
  const double z = std::min(standard_score(p), standard_score(1 - 1e-16));
  double steepest = 0;
  for (const auto &point : hazard.points())
    if (point.intensity < first) steepest = std::max(steepest, hazard.slope(point.intensity));
  steepest = std::max(steepest, hazard.slope(first * (1 - 1e-9)));
  // Of the product of the falling fragility and the growing hazard the peak lies at z + steepest at most.
  const double width = deviation * (std::max(0.0, z + deviation * steepest) + 8);
  if (width * steepest > 300) return std::nullopt;
  const auto falling = [&](double x) { return normal_probability(z - std::log(first / x) / deviation); };
  const double rate = failure_rate(hazard, falling, {first * std::exp(-width), first}).shares.front().rate;
  return rate < endless ? std::optional(rate) : std::nullopt;
}

} // namespace rimpact::reliability
