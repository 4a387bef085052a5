#include "studies/reliability/rate_range.h"
#include "studies/reliability/failure_rate.h"
#include "studies/reliability/lognormal_between.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reliability {
namespace {

/// Of the two lines through the levels the one that `choose` takes, at every intensity.
template <class Choose>
Fragility through(const std::vector<double> &levels, const std::vector<double> &probabilities, Choose choose) {
  std::vector<double> scores;
  for (const double p : probabilities) scores.push_back(standard_score(p));
  return [levels, probabilities, scores, choose](double x) {
    const auto above = std::upper_bound(levels.begin(), levels.end(), x);
    if (above == levels.begin()) return probabilities.front();
    if (above == levels.end()) return probabilities.back();
    const auto i = static_cast<std::size_t>(above - levels.begin()) - 1;
    const double along = std::log(x / levels[i]) / std::log(levels[i + 1] / levels[i]);
    return choose(std::lerp(probabilities[i], probabilities[i + 1], along),
                  normal_probability(std::lerp(scores[i], scores[i + 1], along)));
  };
}

/// Of a straight fall to 0 over the first step of the levels, as level_weights has it.
double by_straight_fall(const HazardCurve &hazard, const std::vector<double> &levels, double p) {
  if (levels.size() < 2) return 0;
  const double first = levels.front(), foot = first * first / levels[1];
  const auto falling = [&](double x) { return p * std::log(x / foot) / std::log(first / foot); };
  return failure_rate(hazard, falling, {foot, first}).shares.front().rate;
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
  range.below = rate_below_first(hazard, levels.front(), bounds.most.front(), slowest_fall);
  if (range.below) range.below = std::max(*range.below, by_straight_fall(hazard, levels, bounds.most.front()));
  if (range.below) range.most = high + at_last + *range.below;
  return range;
}

} // namespace rimpact::reliability
