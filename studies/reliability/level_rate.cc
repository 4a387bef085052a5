#include "studies/reliability/level_rate.h"
#include "studies/reliability/failure_rate.h"
#include "studies/reliability/lognormal_between.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rimpact::reliability {
namespace {

bool is_inner(double p) {
  return p > 0 && p < 1;
}

/// Above the last level: P stays, or goes on along the curve where that is larger.
double rate_above(const HazardCurve &hazard, double last, double p, const BinomialFit &across) {
  const auto larger = [&](double x) { return std::max(p, across.at(x)); };
  constexpr double nearly_sure = 8, negligible = 1e-13;
  std::vector<double> edges{last};
  const double meets = p > 0 && p < 1 ? std::exp((standard_score(p) - across.a) / across.b) : 0;
  if (meets > last * (1 + 1e-12)) edges.push_back(meets);
  const double sure = std::exp((nearly_sure - across.a) / across.b);
  while (edges.back() < sure && hazard.rate(edges.back()) > negligible * hazard.rate(last))
    edges.push_back(2 * edges.back());
  if (edges.size() < 2) return p * hazard.rate(last);
  return failure_rate(hazard, larger, edges).rate;
}

} // namespace

LevelRate flat_rate(const LevelWeights &weights, const std::vector<double> &probabilities) {
  LevelRate result;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    result.of_levels.push_back(weights.weights[i] * probabilities[i]);
  result.below = weights.below * probabilities.front(), result.above = weights.above * probabilities.back();
  result.rate = weights.rate(probabilities);
  return result;
}

LevelRate fitted_rate(const HazardCurve &hazard, const LevelWeights &weights, const std::vector<double> &levels,
                      const std::vector<double> &p, const std::optional<BinomialFit> &across) {
  LevelRate result{.of_levels = std::vector<double>(levels.size(), 0.0)};
  result.below = weights.below * p.front(), result.above = weights.above * p.back();
  if (across) {
    result.below = rate_below_first(hazard, levels.front(), p.front(), std::min(across->deviation(), slowest_fall))
                       .value_or(result.below);
    result.above = rate_above(hazard, levels.back(), p.back(), *across);
  }
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const double at_low = weights.steps[i].at_low * p[i], at_high = weights.steps[i].at_high * p[i + 1];
    const double straight = at_low + at_high;
    if (straight <= 0) continue;
    const double rate = is_inner(p[i]) && is_inner(p[i + 1])
                            ? failure_rate(hazard, lognormal_between(levels[i], p[i], levels[i + 1], p[i + 1]),
                                           {levels[i], levels[i + 1]})
                                  .shares.front()
                                  .rate
                            : straight;
    result.of_levels[i] += rate * at_low / straight, result.of_levels[i + 1] += rate * at_high / straight;
  }
  result.of_levels.front() += result.below, result.of_levels.back() += result.above;
  result.rate = std::accumulate(result.of_levels.begin(), result.of_levels.end(), 0.0);
  return result;
}

} // namespace rimpact::reliability
