#include "studies/risk/disaggregation.h"
#include <algorithm>
#include <cmath>
#include <map>

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

/// dP/d(mean_ln) of a level's finished runs: every response larger by a factor is every limit smaller by it.
double density(const LevelModel &model, double limit) {
  constexpr double h = 1e-4;
  const double more = model.finished_exceedance(limit * std::exp(-h)),
               less = model.finished_exceedance(limit * std::exp(h));
  return (more - less) / (2 * h);
}

/// d ln(rate) / d ln(input) where the probabilities change by `slopes` with the input's logarithm.
double elasticity(const SystemSample &sample, const std::vector<double> &probabilities,
                  const std::vector<double> &slopes) {
  constexpr double h = 1e-4;
  const auto moved = [&](double step) {
    auto p = probabilities;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = std::clamp(p[i] + step * slopes[i], 0.0, 1.0);
    return sample.rate(p).rate;
  };
  return (moved(h) - moved(-h)) / (2 * h * moved(0));
}

} // namespace

Disaggregation disaggregate(const ResponseSet &responses, const SystemSample &sample, const LimitResult &limit) {
  Disaggregation result{std::vector<double>(sample.n_levels(), 0.0), std::vector<double>(responses.records.size(), 0.0),
                        0, std::vector<double>(responses.inputs.size(), 0.0)};
  const double rate = limit.rate.value;
  if (!(rate > 0)) return result;
  const auto models = sample.levels(limit.quantity, sample.once());
  std::vector<double> probabilities;
  std::vector<std::vector<double>> slopes(responses.inputs.size(), std::vector<double>(sample.n_levels(), 0.0));
  double counted = 0; // share of the rate from levels whose fit is refused
  for (std::size_t i = 0; i < sample.n_levels(); ++i) {
    const double share = limit.of_levels[i] / rate;
    probabilities.push_back(limit.fragility[i].value);
    result.levels[i] = share;
    const auto &level = responses.levels[i];
    const auto is_beyond = [&](const Response &run) { return run.beyond || run.values[limit.quantity] > limit.limit; };
    const auto n = std::count_if(level.runs.begin(), level.runs.end(), is_beyond) +
                   std::count_if(level.unfinished.begin(), level.unfinished.end(), is_beyond);
    if (n == 0) result.tail += share;
    for (const auto *runs : {&level.runs, &level.unfinished})
      for (const auto &run : *runs)
        if (is_beyond(run)) result.records[static_cast<std::size_t>(run.record)] += share / static_cast<double>(n);
    counted += limit.is_counted[i] ? share : 0;
    if (limit.is_counted[i]) continue;
    const double slope = density(models[i], limit.limit);
    for (std::size_t input = 0; input < responses.inputs.size(); ++input)
      slopes[input][i] = slope * slope_within_records(level, limit.quantity, input);
  }
  for (std::size_t input = 0; input < slopes.size(); ++input)
    result.elasticities[input] =
        counted > settled_share ? std::nan("") : elasticity(sample, probabilities, slopes[input]);
  return result;
}

} // namespace rimpact::risk
