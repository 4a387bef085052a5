#include "studies/reliability/level_weights.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace rimpact::reliability {
namespace {

using Ends = LevelWeights::Step;

/// Of a straight fragility over [low, high], which one line of the hazard, rate(low) (x / low)^-slope, spans. With
/// u = ln(x / low), U its end and s the slope: the integral of s exp(-s u) (1 - u / U) and of s exp(-s u) u / U.
Ends on_line(double rate_at_low, double slope, double width) {
  const double s = slope * width;
  const double to_high = (-std::expm1(-s) - s * std::exp(-s)) / s;
  return {rate_at_low * (-std::expm1(-s) - to_high), rate_at_low * to_high};
}

/// The same over all lines of the hazard between two levels.
Ends between(const HazardCurve &hazard, double low, double high) {
  std::vector<double> cuts{low};
  for (const auto &point : hazard.points())
    if (point.intensity > low && point.intensity < high) cuts.push_back(point.intensity);
  cuts.push_back(high);
  Ends sum;
  const double whole = std::log(high / low);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double a = cuts[i], b = cuts[i + 1];
    const Ends part = on_line(hazard.rate(a), hazard.slope(std::sqrt(a * b)), std::log(b / a));
    const double from = std::log(a / low) / whole, to = std::log(b / low) / whole; // P along the step
    sum.at_low += (1 - from) * part.at_low + (1 - to) * part.at_high;
    sum.at_high += from * part.at_low + to * part.at_high;
  }
  return sum;
}

} // namespace

double LevelWeights::rate(const std::vector<double> &probabilities) const {
  return std::inner_product(weights.begin(), weights.end(), probabilities.begin(), 0.0);
}

double LevelWeights::most(const std::vector<double> &probabilities) const {
  return rate(probabilities) + above * (1 - probabilities.back());
}

LevelWeights level_weights(const HazardCurve &hazard, const std::vector<double> &intensities) {
  if (intensities.empty()) throw InputError("a failure rate needs at least one level of intensity");
  for (std::size_t i = 0; i + 1 < intensities.size(); ++i)
    if (!(intensities[i + 1] > intensities[i]))
      throw InputError(fmt::format("levels of intensity must grow: {} follows {}", intensities[i + 1], intensities[i]));
  LevelWeights result{.weights = std::vector<double>(intensities.size(), 0.0)};
  for (std::size_t i = 0; i + 1 < intensities.size(); ++i) {
    const Ends ends = between(hazard, intensities[i], intensities[i + 1]);
    result.weights[i] += ends.at_low, result.weights[i + 1] += ends.at_high;
    result.steps.push_back(ends);
  }
  if (intensities.size() > 1) {
    const double foot = intensities[0] * intensities[0] / intensities[1];
    result.below = between(hazard, foot, intensities[0]).at_high;
  }
  result.above = hazard.rate(intensities.back());
  result.weights.front() += result.below, result.weights.back() += result.above;
  return result;
}

} // namespace rimpact::reliability
