#include "studies/risk/evaluate.h"
#include "studies/reliability/failure_rate.h"
#include <algorithm>
#include <functional>

namespace rimpact::risk {
namespace {

std::vector<int> times_drawn(const std::vector<int> &drawn) {
  std::vector<int> times(drawn.size(), 0);
  for (const int record : drawn) ++times[static_cast<std::size_t>(record)];
  return times;
}

std::vector<double> probabilities(const Study &study, const SystemSample &sample, const std::vector<int> &times) {
  std::vector<double> result;
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const auto models = sample.levels(k, times);
    for (std::size_t j = 0; j < study.limits[k].values.size(); ++j) {
      const double rate = sample.rate(sample.fragility(k, j, models, times)).rate;
      result.push_back(reliability::probability_in(study.years, rate));
    }
  }
  return result;
}

/// What runs that stopped short of the limit leave open.
void add_bounds(const Study &study, const SystemSample &sample, std::size_t j, const std::vector<LevelModel> &models,
                LimitResult &result) {
  std::vector<double> least, most;
  for (std::size_t level = 0; level < sample.n_levels(); ++level) {
    const auto bounds = sample.exceedance(result.quantity, j, level, models[level], sample.once());
    result.bounds.push_back(bounds), result.n_unknown += bounds.n_unknown;
    least.push_back(bounds.least), most.push_back(bounds.most);
  }
  result.if_none = reliability::probability_in(study.years, sample.rate(least).rate);
  result.if_all = reliability::probability_in(study.years, sample.rate(most).rate);
}

/// What the levels leave open: what is between and beyond them, and the counts where no lognormal holds.
void add_range(const Study &study, const SystemSample &sample, LimitResult &result) {
  reliability::LevelBounds bounds;
  for (std::size_t level = 0; level < sample.n_levels(); ++level) {
    const auto &check = result.checks[level];
    const double p = result.fragility[level].value;
    bounds.least.push_back(check.refused ? std::min(check.low, p) : p);
    bounds.most.push_back(check.refused ? std::max(check.high, p) : p);
  }
  result.range = reliability::rate_range(reliability::HazardCurve(study.hazard), sample.intensities(), bounds);
  result.probability_least = reliability::probability_in(study.years, result.range.least);
  result.probability_range_most = result.range.most ? reliability::probability_in(study.years, *result.range.most) : 1;
}

/// What the rate is made of, and what other readings of the same probabilities give.
void add_rate(const Study &study, const SystemSample &sample, LimitResult &result) {
  std::vector<double> fragility;
  for (const auto &level : result.fragility) fragility.push_back(level.value);
  const auto rate = sample.rate(fragility);
  const double at_last = sample.weights().above; // the hazard there
  result.below = rate.below, result.above = rate.above, result.of_levels = rate.of_levels;
  result.probability_most = reliability::probability_in(study.years, rate.rate - rate.above + at_last);
  result.rate_fitted = sample.rate(result.fitted).rate;
  std::vector<double> checked = result.fitted;
  for (std::size_t i = 0; i < checked.size(); ++i)
    if (result.checks[i].refused) checked[i] = result.counted[i];
  result.rate_checked = sample.rate(checked).rate;
  result.rate_flat = reliability::flat_rate(sample.weights(), fragility).rate;
  result.across = sample.across(fragility);
  if (result.across) result.test_across = sample.test_of(*result.across, fragility);
}

/// A fragility that is counted has the scatter of its counts, which drawing anew does not show where none exceeds.
Banded widened(Banded value, bool is_counted, const reliability::LevelCheck &check) {
  if (is_counted) value.low = std::min(value.low, check.low), value.high = std::max(value.high, check.high);
  return value;
}

/// A flat list for the bootstrap: of each limit the fragility at every level, the rate, the probability.
std::vector<double> flat_statistic(const Study &study, const SystemSample &sample, const std::vector<int> &times) {
  std::vector<double> flat;
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const auto models = sample.levels(k, times);
    for (std::size_t j = 0; j < study.limits[k].values.size(); ++j) {
      const auto fragility = sample.fragility(k, j, models, times);
      flat.insert(flat.end(), fragility.begin(), fragility.end());
      flat.push_back(sample.rate(fragility).rate);
      flat.push_back(reliability::probability_in(study.years, flat.back()));
    }
  }
  return flat;
}

/// Of limit j of quantity k; `next`: the next number of flat_statistic with its band.
LimitResult result_of(const Study &study, const ResponseSet &responses, const SystemSample &sample, std::size_t k,
                      std::size_t j, const std::vector<LevelModel> &models, const std::function<Banded()> &next) {
  LimitResult result;
  result.quantity = k, result.limit = study.limits[k].values[j];
  for (std::size_t level = 0; level < sample.n_levels(); ++level) {
    result.checks.push_back(sample.check(k, j, level));
    result.is_counted.push_back(sample.is_counted(k, j, level));
    result.fragility.push_back(widened(next(), result.is_counted.back(), result.checks.back()));
    result.counted.push_back(counted_share(responses.levels[level], k, result.limit));
    result.fitted.push_back(models[level].exceedance(result.limit).value);
  }
  result.rate = next(), result.probability = next();
  return result;
}

} // namespace

std::vector<LimitResult> evaluate(const Study &study, const ResponseSet &responses, const SystemSample &sample) {
  const auto statistic = [&](const std::vector<int> &times) { return flat_statistic(study, sample, times); };
  const auto values = statistic(sample.once());
  const auto band = reliability::bootstrap_band(
      static_cast<int>(responses.records.size()),
      [&](const std::vector<int> &drawn) { return statistic(times_drawn(drawn)); }, study.bootstrap);
  std::size_t at = 0;
  const auto next = [&] {
    const Banded result{values[at], band.low[at], band.high[at]};
    ++at;
    return result;
  };
  std::vector<LimitResult> results;
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const auto models = sample.levels(k, sample.once());
    for (std::size_t j = 0; j < study.limits[k].values.size(); ++j) {
      LimitResult result = result_of(study, responses, sample, k, j, models, next);
      add_rate(study, sample, result);
      add_bounds(study, sample, j, models, result);
      add_range(study, sample, result);
      results.push_back(std::move(result));
    }
  }
  return results;
}

bool is_settled(const LimitResult &limit) {
  const double rate = limit.rate.value, slack = settled_share * rate;
  return rate - limit.range.least <= slack && limit.range.most && *limit.range.most - rate <= slack;
}

double reduction(double probability, double reference) {
  return reference > 0 ? 1 - probability / reference : 0;
}

std::vector<Banded> reductions(const Study &study, const SystemSample &sample, const SystemSample &reference) {
  const auto statistic = [&](const std::vector<int> &times) {
    auto p = probabilities(study, sample, times);
    const auto p_reference = probabilities(study, reference, times);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = reduction(p[i], p_reference[i]);
    return p;
  };
  const auto values = statistic(sample.once());
  const auto band = reliability::bootstrap_band(
      static_cast<int>(sample.once().size()),
      [&](const std::vector<int> &drawn) { return statistic(times_drawn(drawn)); }, study.bootstrap);
  std::vector<Banded> result;
  for (std::size_t i = 0; i < values.size(); ++i) result.push_back({values[i], band.low[i], band.high[i]});
  return result;
}

} // namespace rimpact::risk
