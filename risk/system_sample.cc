#include "risk/system_sample.h"
#include <algorithm>
#include <numeric>

namespace rimpact::risk {
namespace {

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

SystemSample::SystemSample(const Study &study, const ResponseSet &responses)
    : n_records_(responses.records.size()), intensities_(intensities_of(responses)),
      weights_(reliability::level_weights(reliability::HazardCurve(study.hazard), intensities_)) {
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    auto &levels = sums_.emplace_back();
    auto &unfinished = unfinished_.emplace_back();
    for (const auto &level : responses.levels) {
      auto &reached = unfinished.emplace_back();
      for (const auto &run : level.unfinished) reached.emplace_back(run.record, run.values[k]);
      auto &records = levels.emplace_back(n_records_);
      for (const auto &run : level.runs) {
        auto &sums = records[static_cast<std::size_t>(run.record)];
        run.beyond ? void(++sums.n_collapsed) : sums.add(run.values[k]);
      }
    }
    auto &limits = limits_.emplace_back();
    for (const double limit : study.limits[k].values) limits.push_back(of_limit(responses, k, limit));
  }
}

SystemSample::OfLimit SystemSample::of_limit(const ResponseSet &responses, std::size_t k, double limit) const {
  OfLimit result{limit, {}, {}};
  std::vector<reliability::LevelEvidence> evidence;
  for (std::size_t i = 0; i < n_levels(); ++i) {
    const ResponseLevel &level = responses.levels[i];
    auto &n_beyond = result.n_beyond.emplace_back(n_records_, 0);
    for (const auto &run : level.runs) n_beyond[static_cast<std::size_t>(run.record)] += is_beyond(run, k, limit);
    const LevelModel model = this->level(k, i, once());
    const auto &finished = model.finished;
    const double n = finished.n_collapsed + finished.n_zero + finished.n_positive, n_records = level.n_records;
    evidence.push_back({model.exceedance(limit).value, counted_share(level, k, limit), n_records,
                        n_records * finished.n_positive / n});
  }
  result.checks = reliability::check_fits(evidence);
  return result;
}

/// `times`, or all of a level's own records where none of them was drawn.
std::vector<int> SystemSample::counted_times(std::size_t k, std::size_t level, const std::vector<int> &times) const {
  const auto &records = sums_[k][level];
  for (std::size_t i = 0; i < records.size(); ++i)
    if (times[i] > 0 && records[i].n_collapsed + records[i].n_zero + records[i].n_positive > 0) return times;
  return once();
}

LevelModel SystemSample::level(std::size_t k, std::size_t level, const std::vector<int> &times) const {
  const auto counted = counted_times(k, level, times);
  LevelModel model{reliability::pooled(sums_[k][level], counted), {}};
  for (const auto &[record, reached] : unfinished_[k][level])
    model.unfinished.emplace_back(reached, counted[static_cast<std::size_t>(record)]);
  return model;
}

LevelModel::Exceedance SystemSample::exceedance(std::size_t k, std::size_t j, std::size_t level,
                                                const LevelModel &model, const std::vector<int> &times) const {
  const OfLimit &of = limits_[k][j];
  if (!of.checks[level].refused) return model.exceedance(of.limit);
  const auto counted = counted_times(k, level, times);
  return model.exceedance(of.limit, std::inner_product(counted.begin(), counted.end(), of.n_beyond[level].begin(), 0));
}

std::vector<double> SystemSample::fragility(std::size_t k, std::size_t j, const std::vector<int> &times) const {
  std::vector<double> result;
  for (std::size_t level = 0; level < n_levels(); ++level)
    result.push_back(exceedance(k, j, level, this->level(k, level, times), times).value);
  return result;
}

} // namespace rimpact::risk
