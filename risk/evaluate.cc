#include "risk/evaluate.h"
#include "reliability/failure_rate.h"
#include <numeric>

namespace rimpact::risk {
namespace {

std::vector<double> intensities_of(const ResponseSet &responses) {
  std::vector<double> result;
  for (const auto &level : responses.levels) result.push_back(level.intensity_g);
  return result;
}

std::vector<int> times_drawn(const std::vector<int> &drawn) {
  std::vector<int> times(drawn.size(), 0);
  for (const int record : drawn) ++times[static_cast<std::size_t>(record)];
  return times;
}

/// Of every limit of the study, in order: visit(quantity, limit).
template <class Visit> void each_limit(const Study &study, const Visit &visit) {
  for (std::size_t k = 0; k < study.limits.size(); ++k)
    for (const double limit : study.limits[k].values) visit(k, limit);
}

std::vector<double> probabilities(const Study &study, const SystemSample &sample, const std::vector<int> &times) {
  std::vector<double> result;
  each_limit(study, [&](std::size_t k, double limit) {
    const double rate = sample.weights().rate(sample.fragility(k, limit, times));
    result.push_back(reliability::probability_in(study.years, rate));
  });
  return result;
}

/// Share of a level's runs beyond the limit, collapses among them; those that stopped short of it are left out.
double counted(const ResponseLevel &level, std::size_t k, double limit) {
  double n = 0, all = static_cast<double>(level.runs.size());
  for (const auto &run : level.runs) n += run.beyond || run.values[k] > limit;
  for (const auto &run : level.unfinished)
    if (run.values[k] > limit) ++n, ++all;
  return n / all;
}

/// What runs that stopped short of the limit leave open.
void add_bounds(const Study &study, const SystemSample &sample, LimitResult &result) {
  std::vector<double> least, most;
  for (std::size_t level = 0; level < sample.n_levels(); ++level) {
    const auto bounds = sample.level(result.quantity, level, sample.once()).exceedance(result.limit);
    result.bounds.push_back(bounds), result.n_unknown += bounds.n_unknown;
    least.push_back(bounds.least), most.push_back(bounds.most);
  }
  result.if_none = reliability::probability_in(study.years, sample.weights().rate(least));
  result.if_all = reliability::probability_in(study.years, sample.weights().rate(most));
}

} // namespace

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
  }
}

LevelModel SystemSample::level(std::size_t k, std::size_t level, const std::vector<int> &times) const {
  const auto &records = sums_[k][level];
  const auto of = [&](const std::vector<int> &counted) {
    LevelModel model{reliability::pooled(records, counted), {}};
    for (const auto &[record, reached] : unfinished_[k][level])
      model.unfinished.emplace_back(reached, counted[static_cast<std::size_t>(record)]);
    return model;
  };
  for (std::size_t i = 0; i < records.size(); ++i)
    if (times[i] > 0 && records[i].n_collapsed + records[i].n_zero + records[i].n_positive > 0) return of(times);
  return of(once());
}

std::vector<double> SystemSample::fragility(std::size_t k, double limit, const std::vector<int> &times) const {
  std::vector<double> result;
  for (std::size_t level = 0; level < n_levels(); ++level)
    result.push_back(this->level(k, level, times).exceedance(limit).value);
  return result;
}

std::vector<LimitResult> evaluate(const Study &study, const ResponseSet &responses, const SystemSample &sample) {
  std::vector<LimitResult> results;
  // A flat list for the bootstrap: of each limit the fragility at every level, the rate, the probability.
  const auto statistic = [&](const std::vector<int> &times) {
    std::vector<double> flat;
    for (std::size_t k = 0; k < study.limits.size(); ++k) {
      std::vector<LevelModel> levels;
      for (std::size_t level = 0; level < sample.n_levels(); ++level) levels.push_back(sample.level(k, level, times));
      for (const double limit : study.limits[k].values) {
        std::vector<double> fragility;
        for (const auto &level : levels) fragility.push_back(level.exceedance(limit).value);
        flat.insert(flat.end(), fragility.begin(), fragility.end());
        flat.push_back(sample.weights().rate(fragility));
        flat.push_back(reliability::probability_in(study.years, flat.back()));
      }
    }
    return flat;
  };
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
  each_limit(study, [&](std::size_t k, double limit) {
    LimitResult result;
    result.quantity = k, result.limit = limit;
    std::vector<double> fragility;
    for (const auto &level : responses.levels) {
      result.fragility.push_back(next());
      fragility.push_back(result.fragility.back().value);
      result.counted.push_back(counted(level, k, limit));
    }
    result.rate = next(), result.probability = next();
    result.below = sample.weights().below * fragility.front();
    result.above = sample.weights().above * fragility.back();
    result.probability_most = reliability::probability_in(study.years, sample.weights().most(fragility));
    add_bounds(study, sample, result);
    results.push_back(std::move(result));
  });
  return results;
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
