#include "responses/hit_limits.h"
#include "io/files/json_text.h"

#include "responses/steel_by_depth.h"
#include "scene/published_pair.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <cmath>

namespace rimpact {
namespace {

using nlohmann::json;

json count_outside(const SpeedRange &range, const Summary &summary) {
  if (!range.is_known()) return nullptr;
  return std::count_if(summary.impacts.begin(), summary.impacts.end(),
                       [&](const Impact &impact) { return !range.holds(impact.approach_speed); });
}

json count_through_rim(const scene::Scene &scene, const Summary &summary) {
  if (scene.rigid_bodies()) return nullptr;
  return std::count_if(summary.impacts.begin(), summary.impacts.end(),
                       [&](const Impact &impact) { return impact.peak_penetration > scene.bearing.rim.thickness; });
}

/// By the runs of the calibration that the element is from, where it is of this rim; one impact that they do not tell
/// leaves the number unknown.
json count_by_depth(const scene::Scene &scene, const Summary &summary, double limit) {
  const auto &r = scene.reduced;
  if (scene.rigid_bodies() || r.calibration.empty() || r.fitted_rim != scene::rim_identity(scene.bearing))
    return nullptr;
  const auto steel = SteelByDepth::of(r.calibration);
  if (!steel) return nullptr;
  int n = 0;
  for (const Impact &impact : summary.impacts) {
    const auto beyond = steel->is_beyond(impact.peak_penetration, limit);
    if (!beyond) return nullptr;
    n += *beyond;
  }
  return n;
}

/// Of a run that tells its strain: which of several impacts strained the steel most is not known.
json count_beyond_steel(const scene::Scene &scene, const Summary &summary) {
  const auto limit = scene::strain_limit(scene.bearing);
  if (!limit) return nullptr;
  const auto strain = judged_strain(summary.steel, summary.max_plastic_strain);
  if (!strain) return summary.rung == SolvedBy::reduced ? count_by_depth(scene, summary, *limit) : json(nullptr);
  const bool exceeded = strain->largest > strain->limit.value_or(*limit);
  if (exceeded && summary.impacts.size() > 1) return nullptr;
  return exceeded ? summary.impacts.size() : 0;
}

} // namespace

bool SpeedRange::holds(double speed) const {
  constexpr double slack = 1e-3;
  return speed >= from.value_or(0) * (1 - slack) && (!to || speed <= *to * (1 + slack));
}

double carried_mass(const scene::Scene &scene, const Summary &summary) {
  double weight = summary.extra.value("largest_static_normal_force_N", 0.0); // of a building's row in a table
  if (summary.extra.contains("building"))
    for (const auto &bearing : summary.extra["building"].at("bearings"))
      weight = std::max(weight, bearing.at("static_normal_force_N").get<double>());
  if (weight == 0) return scene.load.mass;
  return weight / scene.load.gravity;
}

/// A law of the rim reaches the same depths at speeds that move as 1/sqrt(m).
SpeedRange fitted_speeds(const scene::Scene &scene, double mass) {
  SpeedRange range{scene.reduced.fitted_from, scene.reduced.fitted_to};
  for (auto *bound : {&range.from, &range.to})
    if (*bound) **bound *= scene.reduced.fitted_speed_scale(mass);
  return range;
}

json hit_limits(const scene::Scene &scene, const Summary &summary) {
  const double mass = carried_mass(scene, summary);
  const SpeedRange fit = fitted_speeds(scene, mass);
  SpeedRange pair;
  if (!summary.impacts.empty() && summary.rung == SolvedBy::reduced) pair.to = scene::fastest_of_pair(scene, mass);
  std::optional<double> slowest, fastest;
  for (const auto &impact : summary.impacts) {
    slowest = std::min(slowest.value_or(impact.approach_speed), impact.approach_speed);
    fastest = std::max(fastest.value_or(0), impact.approach_speed);
  }
  const SpeedRange &known = fit.is_known() ? fit : pair;
  return {{"hits_beyond_fit", count_outside(fit, summary)},
          {"hits_beyond_pair", count_outside(pair, summary)},
          {"hits_beyond_rim", count_through_rim(scene, summary)},
          {"hits_beyond_steel", count_beyond_steel(scene, summary)},
          {"slowest_approach_speed_m_s", or_null(slowest)},
          {"fastest_approach_speed_m_s", or_null(fastest)},
          {"known_from_m_s", or_null(known.from)},
          {"known_to_m_s", or_null(known.to)}};
}

} // namespace rimpact
