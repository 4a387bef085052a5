#include "risk/disaggregation.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace rimpact::risk {
namespace {

/// Slope of ln(response) over ln(input) among runs that neither collapsed nor are 0, each record with a mean of its
/// own.
double slope_within_records(const ResponseLevel &level, std::size_t k, std::size_t input) {
  struct Sums {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  };
  std::map<int, Sums> records;
  for (const auto &run : level.runs) {
    if (run.beyond || !(run.values[k] > 0)) continue;
    if (!(run.inputs[input] > 0)) return 0;
    const double x = std::log(run.inputs[input]), y = std::log(run.values[k]);
    Sums &s = records[run.record];
    ++s.n, s.x += x, s.y += y, s.xx += x * x, s.xy += x * y;
  }
  double xx = 0, xy = 0;
  for (const auto &[record, s] : records) xx += s.xx - s.x * s.x / s.n, xy += s.xy - s.x * s.y / s.n;
  return xx > 1e-12 ? xy / xx : 0;
}

/// dP/d(mean_ln) of a level.
double density(const reliability::LevelDistribution &level, double limit) {
  if (!level.fit || level.fit->distribution.sigma_ln == 0) return 0;
  const auto &lognormal = level.fit->distribution;
  const double z = (std::log(limit) - lognormal.mean_ln) / lognormal.sigma_ln;
  const double n = level.n_collapsed + level.n_zero + level.n_positive;
  return level.n_positive / n * std::exp(-z * z / 2) / (lognormal.sigma_ln * std::sqrt(2 * std::numbers::pi));
}

} // namespace

Disaggregation disaggregate(const ResponseSet &responses, const SystemSample &sample, const LimitResult &limit) {
  Disaggregation result{std::vector<double>(sample.n_levels(), 0.0), std::vector<double>(responses.records.size(), 0.0),
                        0, std::vector<double>(responses.inputs.size(), 0.0)};
  const double rate = limit.rate.value;
  if (!(rate > 0)) return result;
  const auto &weights = sample.weights().weights;
  double counted = 0; // share of the rate from levels whose lognormal is refused
  for (std::size_t i = 0; i < sample.n_levels(); ++i) {
    const double share = weights[i] * limit.fragility[i].value / rate;
    result.levels[i] = share;
    const auto &level = responses.levels[i];
    const auto is_beyond = [&](const Response &run) { return run.beyond || run.values[limit.quantity] > limit.limit; };
    const auto n = std::count_if(level.runs.begin(), level.runs.end(), is_beyond) +
                   std::count_if(level.unfinished.begin(), level.unfinished.end(), is_beyond);
    if (n == 0) result.tail += share;
    for (const auto *runs : {&level.runs, &level.unfinished})
      for (const auto &run : *runs)
        if (is_beyond(run)) result.records[static_cast<std::size_t>(run.record)] += share / static_cast<double>(n);
    counted += limit.checks[i].refused ? share : 0;
    if (limit.checks[i].refused) continue;
    const double slope_of_rate =
        weights[i] / rate * density(sample.level(limit.quantity, i, sample.once()).finished, limit.limit);
    for (std::size_t input = 0; input < responses.inputs.size(); ++input)
      result.elasticities[input] += slope_of_rate * slope_within_records(level, limit.quantity, input);
  }
  if (counted > settled_share) result.elasticities.assign(responses.inputs.size(), std::nan(""));
  return result;
}

} // namespace rimpact::risk
