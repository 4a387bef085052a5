// Plans of rungs R2 and R3.
#include "fe_contact/runner/plan_parts.h"
#include "fe_contact/runner/stack_run.h"

#include "reduced_models/pad_on_dish.h"
#include "reduced_models/physical_model.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

/// Measured (docs/measured.md), by mesh: the stack; what a meshed sector of the rim adds while it takes part.
constexpr MeshCost stack[4] = {{8000, 0.1, 0.4e9}, {18900, 0.25, 0.7e9}, {59000, 1.2, 2.0e9}, {167000, 6.0, 6.5e9}};
constexpr MeshCost sector[4] = {{2000, 0.05, 0.15e9}, {4800, 0.12, 0.3e9}, {24000, 0.6, 0.8e9}, {70000, 3.0, 2.5e9}};

/// The whole plate, solid all the time (rung R3).
constexpr MeshCost plate[4] = {{8000, 0.25, 0.4e9}, {20000, 0.6, 0.9e9}, {90000, 3.0, 3.5e9}, {270000, 15.0, 11e9}};

void add_cost(Plan &plan, double iterations, double iterations_with_rim, int sectors) {
  constexpr double whole_over_half = 3;
  if (plan.rung == "full") {
    const MeshCost &own = stack[plan.mesh], &all = plate[plan.mesh];
    plan.expected_dofs = (own.dofs + all.dofs) * (plan.half ? 1 : 2);
    plan.expected_memory_bytes = (own.memory + all.memory) * (plan.half ? 1 : 2.3);
    plan.expected_seconds = 10 + (iterations + iterations_with_rim) *
                                     (own.seconds_per_iteration + all.seconds_per_iteration) *
                                     (plan.half ? 1 : whole_over_half);
    return;
  }
  const MeshCost &own = stack[plan.mesh], &rim = sector[plan.mesh];
  plan.expected_dofs = (own.dofs + sectors * rim.dofs) * (plan.half ? 1 : 2);
  plan.expected_memory_bytes = (own.memory + sectors * rim.memory) * (plan.half ? 1 : 2.3);
  plan.expected_seconds = 5 + ((iterations + iterations_with_rim) * own.seconds_per_iteration +
                               iterations_with_rim * sectors * rim.seconds_per_iteration) *
                                  (plan.half ? 1 : whole_over_half);
}

/// Half a second after it was last farther than a millimetre from where it stays, which is more than its springs ring by [s].
double end_of_sliding(const scene::Response &response) {
  constexpr double time_to_settle = 0.5, ringing = 1e-3;
  const auto &t = response.series("time"), &x = response.series("displacement_x"), &y = response.series("displacement_y");
  std::size_t k = t.size() - 1;
  while (k > 0 && std::hypot(x[k] - x.back(), y[k] - y.back()) < ringing) --k;
  return t[k] + time_to_settle;
}

bool moves_along_x(const scene::Excitation &e) {
  if (e.kind == scene::ExcitationKind::record)
    return std::all_of(e.y.values.begin(), e.y.values.end(), [](double a) { return a == 0; });
  return std::abs(e.direction().y()) < 1e-12;
}

/// Where the rim is to be meshed, and what the scout saw of it.
void scout_stack(Plan &plan, scene::Scene scene) {
  reduced::add_stack_terms(scene);
  if (scene.reduced.k_i == 0) scene.reduced.k_i = scene::ReducedSettings{}.k_i; // a scout must feel the rim
  const auto run = reduced::simulate(scene);
  add_impacts(plan, run.summary, run.response);
  plan.rests_from = end_of_sliding(run.response);
  const auto &x = run.response.series("displacement_x"), &y = run.response.series("displacement_y");
  Eigen::Vector2d farthest = Eigen::Vector2d::UnitX() * 1e-12;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::hypot(x[k], y[k]) > farthest.norm()) farthest = {x[k], y[k]};
  const Eigen::Vector2d first =
      plan.impacts.empty() ? farthest
                           : Eigen::Vector2d(std::cos(plan.impacts[0].direction_deg * M_PI / 180),
                                             std::sin(plan.impacts[0].direction_deg * M_PI / 180));
  plan.sector_direction = plan.half ? (first.x() < 0 ? M_PI : 0.0) : std::atan2(first.y(), first.x());
  const double capacity = scene.bearing.lateral_capacity(), margin = 0.02; // a pass this near is meshed [m]
  const Eigen::Vector2d way(std::cos(plan.sector_direction), std::sin(plan.sector_direction));
  double opposite = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (way.dot(Eigen::Vector2d(x[k], y[k])) < 0) opposite = std::max(opposite, std::hypot(x[k], y[k]));
  plan.opposite_sector = opposite > capacity - margin;
  plan.closest_gap = capacity - farthest.norm();
  plan.rim_takes_part = plan.closest_gap < 0.005;
}

} // namespace

Plan stack_path_plan(const scene::Scene &scene) {
  constexpr double steps_a_cycle = 170, steps_a_push = 95, iterations_a_step = 5;
  Plan plan;
  plan.rung = scene.model.rung;
  plan.moves_in_time = false;
  const bool push = scene.excitation.kind == scene::ExcitationKind::push;
  plan.opposite_sector = plan.rung == "full" && !push; // a path goes both ways
  plan.mesh = scene.model.mesh;
  const auto &e = scene.excitation;
  const bool cyclic = e.kind == scene::ExcitationKind::cyclic;
  plan.half = (cyclic || push) && moves_along_x(e) && scene.model.symmetry != "whole";
  const double capacity = scene.bearing.lateral_capacity();
  double travel = 0;
  for (int k = 0; k <= 1000; ++k)
    travel = std::max(travel, scene::prescribed_displacement(e, capacity, 1e-3 * k).norm());
  plan.closest_gap = capacity - travel;
  plan.rim_takes_part = plan.closest_gap <= 0;
  if (push) plan.sector_direction = std::atan2(e.direction().y(), e.direction().x());
  plan.expected_steps = push ? steps_a_push : std::lround(steps_a_cycle * (cyclic ? e.cycles : 1.0));
  const double iterations = plan.expected_steps * iterations_a_step;
  add_cost(plan, push ? 0 : iterations, push ? iterations : 0, 1);
  add_pad_note(plan, scene);
  if (plan.rim_takes_part && !push)
    plan.notes.push_back(fmt::format("the path reaches the rim ({:.1f} mm past L_c), which this rung does not mesh in "
                                     "a quasi-static scene: `run` refuses; try --rung rim and a push",
                                     -1e3 * plan.closest_gap));
  return plan;
}

Plan stack_motion_plan(const scene::Scene &scene) {
  constexpr double step_in_flight = 0.008, iterations_in_flight = 4, contact_time = 0.06, iterations_in_contact = 5, steps_out = 30;
  Plan plan;
  plan.rung = scene.model.rung;
  plan.mesh = scene.model.mesh;
  if (scene.model.step > 0) plan.step_in_contact = scene.model.step;
  const auto &e = scene.excitation;
  plan.half = moves_along_x(e) && scene.model.symmetry != "whole";
  double flight = e.duration / step_in_flight, rest = 0;
  int impacts = 1;
  if (e.kind == scene::ExcitationKind::window) {
    plan.impacts.push_back({0.0, e.direction_deg, e.impact_speed(), 0.0});
    plan.sector_direction = std::atan2(e.direction().y(), e.direction().x());
    flight += steps_out;
  } else {
    scout_stack(plan, scene);
    impacts = plan.impacts.size();
    rest = std::max(0.0, e.duration - plan.rests_from);
    flight = (e.duration - rest) / step_in_flight + rest / longest_resting_step;
    if (rest > 0)
      plan.notes.push_back(fmt::format("the scout rests from {:.1f} s on: steps of up to {:.0f} ms there", plan.rests_from, 1e3 * longest_resting_step));
  }
  const double contact = 1.2 * impacts * contact_time / plan.step_in_contact;
  plan.expected_steps = std::lround(flight + contact);
  add_cost(plan, flight * iterations_in_flight, contact * iterations_in_contact, plan.opposite_sector ? 2 : 1);
  add_pad_note(plan, scene);
  return plan;
}

} // namespace rimpact::fe
