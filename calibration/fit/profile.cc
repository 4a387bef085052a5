#include "calibration/fit/profile.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

namespace {

constexpr double normal_95 = 1.959964;

/// Rise of the cost at which the 95 % interval ends. The cost weighs groups and counts curves as one
/// observation, so it is no likelihood by itself; it is scaled to one (Chandler and Bate 2007) by asking of
/// its curvature at the best that a parabola end at the stated interval.
double rise_95(const Profile &p, std::size_t best, double stated_error) {
  double curvature = 0;
  int n = 0;
  for (const std::size_t i : {best - 1, best + 1})
    if (i < p.values.size()) curvature += p.costs[i] / std::pow(p.values[i] - p.values[best], 2), ++n;
  return n > 0 ? curvature / n * std::pow(normal_95 * stated_error, 2) : 0;
}

/// First crossing of the rise, from the best (index `best`) outwards; the cost grows as a parabola between
/// neighbours, so its root is interpolated.
std::optional<double> crossing(const Profile &p, std::size_t best, double rise, int direction) {
  for (std::size_t i = best;; i += direction) {
    if (direction < 0 ? i == 0 : i + 1 == p.values.size()) return {};
    const std::size_t j = i + direction;
    if (p.costs[j] < rise) continue;
    const double a = std::sqrt(std::max(0.0, p.costs[i])), b = std::sqrt(p.costs[j]);
    return p.values[i] + (std::sqrt(rise) - a) / (b - a) * (p.values[j] - p.values[i]);
  }
}

} // namespace

Profile profile_of(const std::vector<const StoredRun *> &runs, const FitOptions &options, const FitResult &best,
                   const std::string &name, int n) {
  const auto &estimate = best.parameters.at(name);
  const Parameter &p = parameter(name);
  const auto given = options.bounds.find(name);
  const Bounds bounds = given == options.bounds.end() ? Bounds{p.lower, p.upper} : given->second;
  // the stated interval where there is one, a tenth of the value otherwise
  const double width = std::isfinite(estimate.stated_error) && estimate.stated_error > 0
                           ? 2 * normal_95 * estimate.stated_error
                           : 0.1 * std::abs(estimate.value);
  Profile profile;
  for (int i = -n; i <= n; ++i) {
    const double value = estimate.value + width * i / n;
    if (value > bounds.lower && value < bounds.upper) profile.values.push_back(value);
  }
  profile.costs = calibration::profile(runs, options, best, name, profile.values);
  for (double &cost : profile.costs) cost -= best.cost;
  std::size_t middle = 0;
  for (std::size_t i = 0; i < profile.values.size(); ++i)
    if (std::abs(profile.values[i] - estimate.value) < std::abs(profile.values[middle] - estimate.value)) middle = i;
  if (profile.values.empty()) return profile;
  const double rise = rise_95(profile, middle, estimate.stated_error);
  if (!(rise > 0)) return profile;
  profile.low = crossing(profile, middle, rise, -1);
  profile.high = crossing(profile, middle, rise, 1);
  return profile;
}

} // namespace rimpact::calibration
