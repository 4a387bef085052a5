#include "reliability/rate_range.h"
#include "reliability/failure_rate.h"
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace rimpact::reliability {
namespace {

constexpr double slowest_fall = 1; // deviation of ln intensity of a fragility below the first level
constexpr double endless = 1e6;    // [1/year]: a rate above it is no bound

double normal(double z) {
  return std::erfc(-z / std::sqrt(2.0)) / 2;
}

/// Standard score of a probability; 0 and 1 lie beyond every other.
double score(double p) {
  constexpr double farthest = 37;
  if (p <= 0) return -farthest;
  if (p >= 1) return farthest;
  return std::max(-farthest, boost::math::quantile(boost::math::normal(), p));
}

/// Of the two lines through the levels the one that `choose` takes, at every intensity.
template <class Choose>
Fragility through(const std::vector<double> &levels, const std::vector<double> &probabilities, Choose choose) {
  std::vector<double> scores;
  for (const double p : probabilities) scores.push_back(score(p));
  return [levels, probabilities, scores, choose](double x) {
    const auto above = std::upper_bound(levels.begin(), levels.end(), x);
    if (above == levels.begin()) return probabilities.front();
    if (above == levels.end()) return probabilities.back();
    const auto i = static_cast<std::size_t>(above - levels.begin()) - 1;
    const double along = std::log(x / levels[i]) / std::log(levels[i + 1] / levels[i]);
    return choose(std::lerp(probabilities[i], probabilities[i + 1], along),
                  normal(std::lerp(scores[i], scores[i + 1], along)));
  };
}

/// Of a straight fall to 0 over the first step of the levels, as level_weights has it.
double by_straight_fall(const HazardCurve &hazard, const std::vector<double> &levels, double p) {
  if (levels.size() < 2) return 0;
  const double first = levels.front(), foot = first * first / levels[1];
  const auto falling = [&](double x) { return p * std::log(x / foot) / std::log(first / foot); };
  return failure_rate(hazard, falling, {foot, first}).shares.front().rate;
}

/// Of a lognormal fragility of deviation `slowest_fall` below the first level, of probability p there.
std::optional<double> by_slowest_fall(const HazardCurve &hazard, double first, double p) {
  if (p <= 0) return 0;
  const double z = std::min(score(p), score(1 - 1e-16));
  double steepest = 0;
  for (const auto &point : hazard.points())
    if (point.intensity < first) steepest = std::max(steepest, hazard.slope(point.intensity));
  steepest = std::max(steepest, hazard.slope(first * (1 - 1e-9)));
  // Of the product of the falling fragility and the growing hazard the peak lies at z + steepest at most.
  const double width = slowest_fall * (std::max(0.0, z + slowest_fall * steepest) + 8);
  if (width * steepest > 300) return std::nullopt;
  const auto falling = [&](double x) { return normal(z - std::log(first / x) / slowest_fall); };
  const double rate = failure_rate(hazard, falling, {first * std::exp(-width), first}).shares.front().rate;
  return rate < endless ? std::optional(rate) : std::nullopt;
}

double between(const HazardCurve &hazard, const std::vector<double> &levels, const Fragility &fragility) {
  double sum = 0;
  if (levels.size() > 1)
    for (const auto &share : failure_rate(hazard, fragility, levels).shares) sum += share.rate;
  return sum;
}

} // namespace

RateRange rate_range(const HazardCurve &hazard, const std::vector<double> &levels, const LevelBounds &bounds) {
  const double at_last = hazard.rate(levels.back());
  const double low =
      between(hazard, levels, through(levels, bounds.least, [](double a, double b) { return std::min(a, b); }));
  const double high =
      between(hazard, levels, through(levels, bounds.most, [](double a, double b) { return std::max(a, b); }));
  RateRange range;
  range.least = low + bounds.least.back() * at_last;
  range.above = (1 - bounds.least.back()) * at_last;
  range.between = high - low;
  range.below = by_slowest_fall(hazard, levels.front(), bounds.most.front());
  if (range.below) range.below = std::max(*range.below, by_straight_fall(hazard, levels, bounds.most.front()));
  if (range.below) range.most = high + at_last + *range.below;
  return range;
}

} // namespace rimpact::reliability
