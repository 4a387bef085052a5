#include "calibration/pair_range.h"
#include "calibration/law_errors.h"
#include "reduced_models/impact_law.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

using Runs = std::vector<const StoredRun *>;
constexpr std::size_t fewest = 3;
constexpr const char *pair_law = "signed"; // k_i and e are defined by it: it returns e exactly

struct Set {
  std::size_t first, last;
  double ratio;
};
/// Neighbours in `runs` (by speed), the widest first.
std::vector<Set> sets_of(const Runs &runs) {
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

PairRange range_of(const Runs &runs, const Set &set, const FitOptions &options) {
  const Runs inside(runs.begin() + set.first, runs.begin() + set.last + 1);
  PairRange range{.law = pair_law,
                  .tolerance = 0,
                  .result = fit(inside, options),
                  .from = inside.front()->approach_speed(),
                  .to = inside.back()->approach_speed(),
                  .inside = {},
                  .left_out = {},
                  .outside = {},
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

std::string miss(const LawError &e) {
  return fmt::format("at {:.2g} m/s it {} the peak force by {:.0f} % and {} the rebound by {:.0f} %", e.speed,
                     e.peak_force > 0 ? "overstates" : "understates", 100 * std::abs(e.peak_force),
                     e.rebound > 0 ? "overstates" : "understates", 100 * std::abs(e.rebound));
}

std::string sentence_of(const PairRange &range) {
  const auto &p = range.result.parameters;
  std::string text =
      fmt::format("A constant pair k_i = {:.3g} kN/m, e = {:.2f} is valid from {:.2g} to {:.2g} m/s (peak "
                  "force and rebound within {:.0f} %, runs left out too)",
                  p.at("k_i").value, p.at("e").value, range.from, range.to, 100 * range.tolerance);
  const auto below = std::find_if(range.outside.rbegin(), range.outside.rend(),
                                  [&](const auto &e) { return e.speed < range.from; });
  if (below != range.outside.rend()) text += "; below, " + miss(*below);
  if (!range.outside.empty() && range.outside.back().speed > range.to)
    text += "; beyond, " + miss(range.outside.back());
  return text + ".";
}

} // namespace

std::optional<PairRange> pair_range(const Runs &given, const FitOptions &options,
                                    const std::vector<double> &tolerances) {
  const Runs runs = by_speed(given);
  FitOptions own = options_for(pair_law, options);
  own.weights = {.force = 0, .displacement = 0}; // a pair is judged by peak force and rebound
  if (own.parameters.size() < 2) return {};      // held by the caller: not a pair to find
  std::vector<PairRange> ranges;
  for (const auto &set : sets_of(runs)) ranges.push_back(range_of(runs, set, own));
  for (const double tolerance : tolerances)
    for (auto &range : ranges) {
      if (!met(range.inside, tolerance)) continue;
      if (range.left_out.empty()) leave_out_of(range, runs, own);
      if (!met(range.left_out, tolerance)) continue;
      for (const StoredRun *run : runs)
        if (run->approach_speed() < range.from || run->approach_speed() > range.to)
          range.outside.push_back(error_of(*run, range.result));
      range.tolerance = tolerance;
      range.sentence = sentence_of(range);
      return range;
    }
  return {};
}

} // namespace rimpact::calibration
