// What the reduced model sees before rungs rigid-dish and full are run: impacts, near passes, where sliding ends.
#include "fe_contact/planning/stack_scout.h"

#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace rimpact::planning {
namespace {

/// Half a second after it was last farther than a millimetre from where it stays, which is more than its springs ring
/// by [s].
double end_of_sliding(const Response &response) {
  constexpr double time_to_rest = 0.5, ringing = 1e-3;
  const auto &t = response.series("time"), &x = response.series("displacement_x"),
             &y = response.series("displacement_y");
  std::size_t k = t.size() - 1;
  while (k > 0 && std::hypot(x[k] - x.back(), y[k] - y.back()) < ringing) --k;
  return t[k] + time_to_rest;
}

/// Shortly before the slider first leaves where it is [s].
double begin_of_sliding(const Response &response) {
  constexpr double beforehand = 0.02, moved = 1e-5; // [s], [m]
  const auto &t = response.series("time"), &x = response.series("displacement_x"),
             &y = response.series("displacement_y");
  std::size_t k = 0;
  while (k + 1 < t.size() && std::hypot(x[k] - x.front(), y[k] - y.front()) < moved) ++k;
  return std::max(0.0, t[k] - beforehand);
}

/// Farthest points of the stretches on which the path is no nearer to the middle than `radius`; of the whole path when
/// there are none.
std::vector<Eigen::Vector2d> near_passes(const Response &response, double radius) {
  const auto &x = response.series("displacement_x"), &y = response.series("displacement_y");
  std::vector<Eigen::Vector2d> passes;
  Eigen::Vector2d farthest = Eigen::Vector2d::UnitX() * 1e-12;
  bool outside = false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Eigen::Vector2d u(x[k], y[k]);
    if (u.norm() > farthest.norm()) farthest = u;
    const bool was_outside = std::exchange(outside, u.norm() > radius);
    if (!outside) continue;
    if (!was_outside) passes.push_back(u);
    if (u.norm() > passes.back().norm()) passes.back() = u;
  }
  return passes.empty() ? std::vector{farthest} : passes;
}

/// Once each where one fine place of the mesh serves several.
void add_sector(std::vector<double> &sectors, double direction) {
  constexpr double same_place = 0.1; // [rad]
  if (std::none_of(sectors.begin(), sectors.end(),
                   [&](double s) { return std::abs(std::remainder(direction - s, 2 * M_PI)) < same_place; }))
    sectors.push_back(direction);
}

} // namespace

void scout_stack(Plan &plan, scene::Scene scene) {
  constexpr double margin = 0.02, may_touch = 0.005; // a pass this near is meshed [m]
  reduced::add_stack_terms(scene);
  if (scene.reduced.k_i == 0) scene.reduced.k_i = scene::ReducedSettings{}.k_i; // a scout must feel the rim
  scene = reduced::in_one_piece(std::move(scene)); // finite elements go on where its foot goes
  const auto run = reduced::simulate(scene);
  add_impacts(plan, run.summary, run.response);
  plan.moves_from = begin_of_sliding(run.response);
  plan.rests_from = end_of_sliding(run.response);
  const double capacity = scene.bearing.lateral_capacity(),
               slip = scene.bearing.has_interface() ? scene.bearing.slider.interface_gap : 0; // which the scout has not
  const auto meshed = [&](double direction) { return !plan.half ? direction : std::cos(direction) < 0 ? M_PI : 0.0; };
  plan.sectors.clear();
  for (const auto &impact : plan.impacts) add_sector(plan.sectors, meshed(impact.direction_deg * M_PI / 180));
  plan.closest_gap = capacity;
  for (const auto &pass : near_passes(run.response, capacity - margin - slip)) {
    add_sector(plan.sectors, meshed(std::atan2(pass.y(), pass.x())));
    plan.closest_gap = std::min(plan.closest_gap, capacity - pass.norm());
  }
  plan.rim_takes_part = plan.closest_gap < may_touch;
}

} // namespace rimpact::planning
