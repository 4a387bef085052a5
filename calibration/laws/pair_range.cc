#include "calibration/laws/pair_range.h"
#include "calibration/fit/parallel.h"
#include "calibration/laws/law_errors.h"
#include "calibration/laws/percent.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

using Runs = std::vector<const StoredRun *>;
constexpr std::size_t fewest = 3;

struct Set {
  std::size_t first, last;
  double ratio;
};
/// Neighbours in `runs` (by speed), the widest first.
std::vector<Set> neighbouring_sets(const Runs &runs) {
  std::vector<Set> sets;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = i + fewest - 1; j < runs.size(); ++j)
      sets.push_back({i, j, runs[j]->approach_speed() / runs[i]->approach_speed()});
  std::stable_sort(sets.begin(), sets.end(), [](const auto &a, const auto &b) { return a.ratio > b.ratio; });
  return sets;
}

bool met(const std::vector<LawError> &errors, double tolerance) {
  return std::all_of(errors.begin(), errors.end(), [&](const LawError &e) {
    return std::abs(e.peak_force) <= tolerance && std::abs(e.rebound) <= tolerance;
  });
}

/// Hit hard enough to tell, the slowest first.
Runs by_speed(const Runs &given) {
  Runs runs;
  for (const StoredRun *run : given)
    if (!run->impacts.empty() && !only_grazing(*run)) runs.push_back(run);
  std::sort(runs.begin(), runs.end(),
            [](const auto *a, const auto *b) { return a->approach_speed() < b->approach_speed(); });
  return runs;
}

/// One pair returns the same force over speed and the same restitution at every speed, but for what weight and friction
/// add: where the runs' own are farther apart than the tolerance lets them be, no fit is asked for.
bool conceivable(const Runs &runs, const Set &set, double tolerance) {
  constexpr double added = 1.2;
  const double allowed = added * (1 + tolerance) / (1 - tolerance);
  double stiffest = 0, softest = INFINITY, liveliest = 0, dullest = INFINITY;
  for (std::size_t i = set.first; i <= set.last; ++i) {
    const auto &impacts = runs[i]->impacts;
    const auto hardest =
        std::max_element(impacts.begin(), impacts.end(), [](const auto &a, const auto &b) { return a.peak < b.peak; });
    const double force = hardest->peak / hardest->impact.approach_speed, rebound = hardest->impact.restitution();
    stiffest = std::max(stiffest, force), softest = std::min(softest, force);
    liveliest = std::max(liveliest, rebound), dullest = std::min(dullest, rebound);
  }
  return stiffest <= allowed * softest && liveliest <= allowed * dullest;
}

PairRange range_of(const Runs &runs, const Set &set, const FitOptions &options) {
  const Runs inside(runs.begin() + set.first, runs.begin() + set.last + 1);
  PairRange range{.law = options.law,
                  .tolerance = 0,
                  .result = fit(inside, options),
                  .from = inside.front()->approach_speed(),
                  .to = inside.back()->approach_speed(),
                  .inside = {},
                  .left_out = {},
                  .outside = {},
                  .mass = inside.front()->scene.load.mass,
                  .worst_peak_force = 0,
                  .worst_rebound = 0,
                  .sentence = {}};
  for (const StoredRun *run : inside) range.inside.push_back(error_of(*run, range.result));
  return range;
}

void leave_out_of(PairRange &range, const Runs &runs, const FitOptions &options) {
  Runs inside;
  for (const StoredRun *run : runs)
    if (run->approach_speed() >= range.from && run->approach_speed() <= range.to) inside.push_back(run);
  for (const auto &left : leave_out(inside, options, range.result))
    if (left.errors.size() == 1) range.left_out.push_back(left.errors[0]);
}

void find_worst(PairRange &range) {
  for (const auto *errors : {&range.inside, &range.left_out})
    for (const auto &e : *errors) {
      range.worst_peak_force = std::max(range.worst_peak_force, std::abs(e.peak_force));
      range.worst_rebound = std::max(range.worst_rebound, std::abs(e.rebound));
    }
}

std::string miss(const LawError &e) {
  return fmt::format("at {:.3g} m/s it {} the peak force by {} and {} the rebound by {}", e.speed,
                     e.peak_force > 0 ? "overstates" : "understates", percent_up(std::abs(e.peak_force)),
                     e.rebound > 0 ? "overstates" : "understates", percent_up(std::abs(e.rebound)));
}

std::string sentence_of(const PairRange &range) {
  const auto &p = range.result.parameters;
  std::string text = fmt::format("For a supported mass of {:.6g} kg and impacts from {:.3g} to {:.3g} m/s the constant "
                                 "pair k_i = {:.5g} kN/m, e = {:.4f} of law {} serves. It meets the "
                                 "peak force within {} and the rebound within {}, runs left out too",
                                 range.mass, range.from, range.to, p.at("k_i").value, p.at("e").value, range.law,
                                 percent_up(range.worst_peak_force), percent_up(range.worst_rebound));
  const auto below =
      std::find_if(range.outside.rbegin(), range.outside.rend(), [&](const auto &e) { return e.speed < range.from; });
  if (below != range.outside.rend()) text += ". Below, " + miss(*below);
  if (!range.outside.empty() && range.outside.back().speed > range.to)
    text += ". Beyond, " + miss(range.outside.back());
  return text + ".";
}

} // namespace

std::optional<PairRange> pair_range(const Runs &given, const FitOptions &options, const std::string &law,
                                    const std::vector<double> &tolerances) {
  const Runs runs = by_speed(given);
  FitOptions own = options_for(law, options);
  own.weights = {.force = 0, .displacement = 0}; // a pair is judged by peak force and rebound
  own.n_starts = 1;                              // of two numbers, read off the hardest impact
  own.counting = SampleWeighting::curve;         // by sample these two are in the curves, which are left out
  if (own.parameters.size() < 2) return {};      // held by the caller: not a pair to find
  const std::vector<Set> sets = neighbouring_sets(runs);
  std::vector<std::optional<PairRange>> ranges(sets.size());
  for (const double tolerance : tolerances) {
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (!ranges[i] && conceivable(runs, sets[i], tolerance)) asked.push_back(i);
    auto fitted = parallel_map(asked, [&](std::size_t i) { return range_of(runs, sets[i], own); });
    for (std::size_t n = 0; n < asked.size(); ++n) ranges[asked[n]] = std::move(fitted[n]);
    for (auto &range : ranges) {
      if (!range || !met(range->inside, tolerance)) continue;
      if (range->left_out.empty()) leave_out_of(*range, runs, own);
      if (!met(range->left_out, tolerance)) continue;
      for (const StoredRun *run : runs)
        if (run->approach_speed() < range->from || run->approach_speed() > range->to)
          range->outside.push_back(error_of(*run, range->result));
      range->tolerance = tolerance;
      find_worst(*range);
      range->sentence = sentence_of(*range);
      return range;
    }
  }
  return {};
}

} // namespace rimpact::calibration
