#include "calibration/laws/law_errors.h"
#include "calibration/data/metrics.h"
#include "calibration/fit/parallel.h"
#include "calibration/fit/shooting.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace rimpact::calibration {

namespace {

using Runs = std::vector<const StoredRun *>;

/// Sets of runs to leave out: each by itself, and each pulse with all its scales where there are others.
std::vector<std::pair<std::string, Runs>> sets_of(const Runs &runs) {
  std::vector<std::pair<std::string, Runs>> sets;
  std::map<std::string, Runs> pulses;
  for (const StoredRun *run : runs) {
    sets.push_back({run->folder, {run}});
    const auto &x = run->scene.excitation;
    if (x.kind == scene::ExcitationKind::ricker)
      pulses[fmt::format("pulse {:g} g, {:g} s", x.amplitude_g, x.period)].push_back(run);
  }
  for (const auto &[name, pulse] : pulses)
    if (pulse.size() > 1 && pulse.size() < runs.size()) sets.push_back({name, pulse});
  return sets;
}

double deepest(const std::vector<double> &displacement, const ImpactWindow &w) {
  return *std::max_element(displacement.begin(), displacement.end()) - w.capacity;
}

} // namespace

bool only_grazing(const StoredRun &run) {
  return std::all_of(run.impacts.begin(), run.impacts.end(), [](const auto &w) { return w.grazing; });
}

LawError error_of(const StoredRun &run, const FitResult &result) {
  const auto scene = with_fitted(run.scene, result);
  LawError error{};
  error.folder = run.folder, error.speed = run.approach_speed(), error.grazing = true;
  error.peak_force = error.depth = error.rebound =
      std::numeric_limits<double>::quiet_NaN(); // of no impact nothing is known
  double missed = 0, whole = 0, hardest = 0;
  for (const auto &w : run.impacts) {
    error.grazing = error.grazing && w.grazing;
    const Shot shot = shoot(scene, w);
    for (std::size_t i = 1; i < w.times.size(); ++i) {
      const double dt = w.times[i] - w.times[i - 1];
      missed += dt * std::pow(shot.force[i] - w.force[i], 2);
      whole += dt * w.force[i] * w.force[i];
    }
    if (w.peak <= hardest) continue;
    hardest = w.peak;
    error.peak_force = shot.peak / w.peak - 1;
    error.depth = deepest(shot.displacement, w) / deepest(w.displacement, w) - 1;
    error.rebound = shot.rebound_speed / w.impact.rebound_speed - 1;
  }
  error.unexplained = std::sqrt(missed / whole); // NaN without a force
  error.nrmse_displacement = compare(run.response, history_of(run, scene), run.scene.bearing.lateral_capacity())
                                 .nrmse_displacement.value_or(std::numeric_limits<double>::quiet_NaN());
  return error;
}

namespace {

/// Fitted to the others and asked for the set; none when only grazing impacts are left to fit.
std::optional<LeftOut> without(const Runs &runs, const std::pair<std::string, Runs> &set, const FitOptions &options) {
  const auto &[what, out] = set;
  Runs kept;
  for (const StoredRun *run : runs)
    if (std::find(out.begin(), out.end(), run) == out.end()) kept.push_back(run);
  if (std::all_of(kept.begin(), kept.end(), [](const auto *run) { return only_grazing(*run); })) return std::nullopt;
  const FitResult result = fit(kept, options);
  LeftOut left{.what = what, .errors = {}, .converged = result.converged};
  for (const StoredRun *run : out) left.errors.push_back(error_of(*run, result));
  return left;
}

} // namespace

std::vector<LeftOut> leave_out(const Runs &runs, const FitOptions &options, const FitResult &all) {
  FitOptions again = options;
  again.n_starts = 0;     // from the fit of all runs alone
  again.tolerance = 1e-4; // errors are told in tenths of a per cent
  for (const auto &name : again.parameters) again.start[name] = all.parameters.at(name).value;
  std::vector<LeftOut> table;
  for (auto &left : parallel_map(sets_of(runs), [&](const auto &set) { return without(runs, set, again); }))
    if (left) table.push_back(std::move(*left));
  return table;
}

} // namespace rimpact::calibration
