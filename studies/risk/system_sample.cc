#include "studies/risk/system_sample.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rimpact::risk {
namespace {

constexpr const char *travel = "peak_displacement_m"; // the quantity that a rim caps

std::vector<double> intensities_of(const ResponseSet &responses) {
  std::vector<double> result;
  for (const auto &level : responses.levels) result.push_back(level.intensity_g);
  return result;
}

bool is_beyond(const Response &run, std::size_t k, double limit) {
  return run.beyond || run.values[k] > limit;
}

} // namespace

double counted_share(const ResponseLevel &level, std::size_t k, double limit) {
  double n = 0, all = static_cast<double>(level.runs.size());
  for (const auto &run : level.runs) n += is_beyond(run, k, limit);
  for (const auto &run : level.unfinished)
    if (run.values[k] > limit) ++n, ++all;
  return n / all;
}

std::optional<double> stop_of(const Study &study, const ResponseSet &responses, std::size_t k) {
  if (study.limits[k].quantity != travel) return std::nullopt;
  std::vector<double> hits;
  double most_free = 0;
  for (const auto &level : responses.levels)
    for (const auto &run : level.runs)
      if (run.hit && !run.beyond)
        hits.push_back(run.values[k]);
      else if (!run.beyond)
        most_free = std::max(most_free, run.values[k]);
  return reliability::stop_between(most_free, std::move(hits));
}

SystemSample::LevelSums SystemSample::sums_of(const ResponseLevel &level, std::size_t k, std::size_t n_records,
                                              double stop) {
  LevelSums sums(n_records);
  for (const auto &run : level.unfinished) sums.unfinished.emplace_back(run.record, run.values[k]);
  for (const auto &run : level.runs) {
    const auto record = static_cast<std::size_t>(run.record);
    if (run.beyond) {
      ++sums.all[record].n_collapsed;
      continue;
    }
    sums.all[record].add(run.values[k]);
    run.hit ? sums.hit[record].add(run.values[k] - stop) : sums.free[record].add(run.values[k]);
  }
  return sums;
}

SystemSample::SystemSample(const Study &study, const ResponseSet &responses)
    : rule_(study.fragility), hazard_(study.hazard), n_records_(responses.records.size()),
      intensities_(intensities_of(responses)), weights_(reliability::level_weights(hazard_, intensities_)) {
  for (const auto &level : responses.levels) n_trials_.push_back(level.n_records);
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    stops_.push_back(stop_of(study, responses, k));
    auto &levels = sums_.emplace_back();
    for (const auto &level : responses.levels)
      levels.push_back(sums_of(level, k, n_records_, stops_.back().value_or(0)));
    auto &limits = limits_.emplace_back();
    const auto models = this->levels(k, once());
    for (const double limit : study.limits[k].values) limits.push_back(of_limit(responses, k, limit, models));
  }
}

SystemSample::OfLimit SystemSample::of_limit(const ResponseSet &responses, std::size_t k, double limit,
                                             const std::vector<LevelModel> &models) const {
  OfLimit result{limit, {}, {}};
  std::vector<reliability::LevelEvidence> evidence;
  for (std::size_t i = 0; i < n_levels(); ++i) {
    const ResponseLevel &level = responses.levels[i];
    auto &n_beyond = result.n_beyond.emplace_back(n_records_, 0);
    for (const auto &run : level.runs) n_beyond[static_cast<std::size_t>(run.record)] += is_beyond(run, k, limit);
    const auto &finished = models[i].finished;
    const double n = finished.n_collapsed + finished.n_zero + finished.n_positive;
    evidence.push_back({models[i].exceedance(limit).value, counted_share(level, k, limit), n_trials_[i],
                        n_trials_[i] * finished.n_positive / n});
  }
  result.checks = reliability::check_fits(evidence);
  return result;
}

/// `times`, or all of a level's own records where none of them was drawn.
std::vector<int> SystemSample::counted_times(const LevelSums &level, const std::vector<int> &times) const {
  for (std::size_t i = 0; i < level.all.size(); ++i)
    if (times[i] > 0 && level.all[i].n_collapsed + level.all[i].n_zero + level.all[i].n_positive > 0) return times;
  return once();
}

std::vector<LevelModel> SystemSample::levels(std::size_t k, const std::vector<int> &times) const {
  std::vector<LevelModel> models;
  for (const auto &level : sums_[k]) {
    const auto counted = counted_times(level, times);
    LevelModel model{reliability::pooled(level.all, counted), std::nullopt, {}};
    for (const auto &[record, reached] : level.unfinished)
      model.unfinished.emplace_back(reached, counted[static_cast<std::size_t>(record)]);
    models.push_back(std::move(model));
  }
  if (rule_ == FragilityRule::hits_apart) set_hits_apart(k, times, models);
  return models;
}

/// The probability of a hit is that of a logistic over all levels, or as counted where the shares give none.
void SystemSample::set_hits_apart(std::size_t k, const std::vector<int> &times, std::vector<LevelModel> &models) const {
  std::vector<reliability::ShareAt> hits;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const auto counted = counted_times(sums_[k][i], times);
    const auto apart =
        reliability::hit_level(models[i].finished.n_collapsed, reliability::pooled(sums_[k][i].hit, counted),
                               reliability::pooled(sums_[k][i].free, counted), stops_[k]);
    const double n = models[i].finished.n_zero + models[i].finished.n_positive;
    if (n > 0) hits.push_back({intensities_[i], apart.hit_share, n});
    models[i].apart = apart;
  }
  if (const auto logistic = reliability::fit_binomial(hits, reliability::Link::logit))
    for (std::size_t i = 0; i < models.size(); ++i) models[i].apart->hit_share = logistic->at(intensities_[i]);
}

LevelModel::Exceedance SystemSample::exceedance(std::size_t k, std::size_t j, std::size_t level,
                                                const LevelModel &model, const std::vector<int> &times) const {
  const OfLimit &of = limits_[k][j];
  if (!is_counted(k, j, level)) return model.exceedance(of.limit);
  const auto counted = counted_times(sums_[k][level], times);
  return model.exceedance(of.limit, std::inner_product(counted.begin(), counted.end(), of.n_beyond[level].begin(), 0));
}

std::vector<double> SystemSample::fragility(std::size_t k, std::size_t j, const std::vector<LevelModel> &models,
                                            const std::vector<int> &times) const {
  std::vector<double> result;
  for (std::size_t level = 0; level < n_levels(); ++level)
    result.push_back(exceedance(k, j, level, models[level], times).value);
  return result;
}

std::vector<reliability::ShareAt> SystemSample::shares(const std::vector<double> &probabilities) const {
  std::vector<reliability::ShareAt> result;
  for (std::size_t i = 0; i < n_levels(); ++i)
    result.push_back({intensities_[i], probabilities[i], std::max(1.0, n_trials_[i])});
  return result;
}

std::optional<reliability::BinomialFit> SystemSample::across(const std::vector<double> &probabilities) const {
  if (rule_ == FragilityRule::thesis) return std::nullopt;
  return reliability::fit_binomial(shares(probabilities), reliability::Link::probit);
}

double SystemSample::test_of(const reliability::BinomialFit &across, const std::vector<double> &probabilities) const {
  return reliability::test_of_fit(across, shares(probabilities));
}

reliability::LevelRate SystemSample::rate(const std::vector<double> &probabilities) const {
  if (rule_ == FragilityRule::thesis) return reliability::flat_rate(weights_, probabilities);
  return reliability::fitted_rate(hazard_, weights_, intensities_, probabilities, across(probabilities));
}

} // namespace rimpact::risk
