// Plans of rungs rigid-dish and full.
#include "fe_contact/planning/stack_plan.h"
#include "fe_contact/planning/stack_scout.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::planning {
namespace {

/// Unknowns counted, seconds and memory measured (docs/results/refinement.md), by mesh: the stack; what a meshed sector
/// of the rim adds while it takes part.
constexpr MeshCost stack[4] = {{6800, 0.1, 0.4e9}, {12500, 0.25, 0.7e9}, {36300, 1.2, 2.0e9}, {93400, 6.0, 6.5e9}};
constexpr MeshCost sector[4] = {{1900, 0.05, 0.15e9}, {5000, 0.12, 0.3e9}, {16500, 0.6, 0.8e9}, {55000, 3.0, 2.5e9}};

/// What each further sector adds all the time, mostly the slider's own fine cells on that side.
constexpr MeshCost further[4] = {{5400, 0.07, 0.2e9}, {11400, 0.15, 0.5e9}, {34000, 0.8, 1.5e9}, {100000, 4.0, 4.5e9}};

/// Between two dishes (dcfp-155; meshes 2 and 3 by their unknowns): half the slider; a sector, which the slider is fine
/// for on both sides.
constexpr MeshCost slider[4] = {{5800, 0.06, 0.3e9}, {11200, 0.2, 1.2e9}, {16800, 0.4, 2.0e9}, {40300, 1.5, 6.0e9}};
constexpr MeshCost beside[4] = {{900, 0.04, 0.2e9}, {2200, 0.07, 0.4e9}, {4700, 0.2, 0.7e9}, {17000, 0.6, 2.0e9}};

/// The whole plate, solid all the time (rung full).
constexpr MeshCost plate[4] = {{5500, 0.25, 0.4e9}, {15500, 0.6, 0.9e9}, {45000, 3.0, 3.5e9}, {145000, 15.0, 11e9}};

void add_cost(Plan &plan, const scene::Bearing &bearing, double iterations, double iterations_with_rim, int sectors) {
  constexpr double whole_over_half = 3;
  plan.expected_iterations = iterations + iterations_with_rim;
  if (plan.rung == scene::Rung::full) {
    const MeshCost &own = (bearing.has_pad() ? stack : slider)[plan.mesh], &all = plate[plan.mesh];
    plan.expected_dofs = (own.dofs + all.dofs) * (plan.half ? 1 : 2);
    plan.expected_memory_bytes = (own.memory + all.memory) * (plan.half ? 1 : 2.3);
    plan.expected_seconds = 10 + (iterations + iterations_with_rim) *
                                     (own.seconds_per_iteration + all.seconds_per_iteration) *
                                     (plan.half ? 1 : whole_over_half);
    return;
  }
  const MeshCost &own = (bearing.has_pad() ? stack : slider)[plan.mesh],
                 &rim = (bearing.has_pad() ? sector : beside)[plan.mesh],
                 &side = (bearing.has_pad() ? further : beside)[plan.mesh];
  const int more = std::max(0, sectors - 1);
  plan.expected_dofs = (own.dofs + (sectors > 0) * rim.dofs + more * side.dofs) * (plan.half ? 1 : 2);
  plan.expected_memory_bytes = (own.memory + (sectors > 0) * rim.memory + more * side.memory) * (plan.half ? 1 : 2.3);
  plan.expected_seconds =
      5 + ((iterations + iterations_with_rim) * (own.seconds_per_iteration + more * side.seconds_per_iteration) +
           iterations_with_rim * rim.seconds_per_iteration) *
              (plan.half ? 1 : whole_over_half);
}

bool moves_along_x(const scene::Excitation &e) {
  if (e.kind == scene::ExcitationKind::record)
    return std::all_of(e.y.values.begin(), e.y.values.end(), [](double a) { return a == 0; });
  if (e.kind == scene::ExcitationKind::path) return e.path.stays_on_x();
  return std::abs(e.direction().y()) < 1e-12;
}

} // namespace

bool goes_into_the_rim(const Plan &plan, const scene::Bearing &bearing) {
  return plan.half && bearing.has_interface() && -plan.closest_gap < bearing.slider.interface_gap;
}

Plan stack_path_plan(const scene::Scene &scene) {
  constexpr double steps_a_cycle = 170, steps_a_push = 95, iterations_a_step = 5;
  Plan plan;
  plan.rung = scene.model.rung;
  plan.moves_in_time = false;
  const bool push = scene.excitation.kind == scene::ExcitationKind::push;
  plan.mesh = scene.model.mesh;
  const auto &e = scene.excitation;
  const bool to_and_fro = e.stays_on_dish() && e.kind != scene::ExcitationKind::figure_eight;
  plan.half = (to_and_fro || push) && moves_along_x(e) && scene.model.symmetry != scene::Symmetry::whole;
  const double capacity = scene.bearing.lateral_capacity();
  double travel = 0;
  for (int k = 0; k <= 1000; ++k)
    travel = std::max(travel, scene::prescribed_displacement(e, capacity, 1e-3 * k).norm());
  plan.closest_gap = capacity - travel;
  plan.rim_takes_part = plan.closest_gap <= 0;
  const bool into_the_rim = !push && plan.rim_takes_part && goes_into_the_rim(plan, scene.bearing);
  if (into_the_rim || (!push && plan.rung == scene::Rung::full)) plan.sectors = {0, M_PI}; // a path goes both ways
  if (push) plan.sectors = {std::atan2(e.direction().y(), e.direction().x())};
  plan.expected_steps = push ? steps_a_push : std::lround(steps_a_cycle * (to_and_fro ? e.rounds() : 1.0));
  const double iterations = plan.expected_steps * iterations_a_step;
  const bool solid_rim = push || into_the_rim;
  add_cost(plan, scene.bearing, solid_rim ? 0 : iterations, solid_rim ? iterations : 0, plan.sectors.size());
  add_pad_note(plan, scene);
  if (plan.rim_takes_part && !solid_rim)
    plan.notes.push_back(fmt::format("the path reaches the rim ({:.1f} mm past L_c), which this rung does not mesh in "
                                     "this scene: `run` refuses{}",
                                     -1e3 * plan.closest_gap,
                                     scene.bearing.has_interface() ? "" : "; try --rung rim and a push"));
  return plan;
}

Plan stack_motion_plan(const scene::Scene &scene) {
  constexpr double step_in_flight = 0.015, iterations_in_flight = 4, contact_time = 0.06, steps_out = 30;
  Plan plan;
  plan.rung = scene.model.rung;
  plan.mesh = scene.model.mesh;
  if (scene.model.step > 0) plan.step_in_contact = scene.model.step;
  const auto &e = scene.excitation;
  plan.half = moves_along_x(e) && scene.model.symmetry != scene::Symmetry::whole;
  double flight = e.duration / step_in_flight, rest = 0;
  int impacts = 1;
  if (e.kind == scene::ExcitationKind::window) {
    plan.impacts.push_back({0.0, e.direction_deg, e.impact_speed(), 0.0});
    plan.sectors = {std::atan2(e.direction().y(), e.direction().x())};
    flight += steps_out;
  } else {
    scout_stack(plan, scene);
    impacts = plan.impacts.size();
    rest = plan.moves_from + std::max(0.0, e.duration - plan.rests_from);
    flight = (e.duration - rest) / step_in_flight + rest / longest_resting_step;
    if (plan.rests_from < e.duration)
      plan.notes.push_back(
          fmt::format("the scout rests from {:.1f} s on: steps of up to {:.0f} ms there, and until it first moves",
                      plan.rests_from, 1e3 * longest_resting_step));
  }
  const double contact = 1.2 * impacts * contact_time / plan.step_in_contact;
  plan.expected_steps = std::lround(flight + contact);
  double iterations = 0;
  for (const auto &impact : plan.impacts)
    iterations += std::max(1.0, 1e-3 / plan.step_in_contact) *
                  (90 + 0.8 * iterations_of_impact(depth_of_impact(scene, impact.approach_speed)));
  add_cost(plan, scene.bearing, flight * iterations_in_flight, iterations,
           std::min<int>(plan.sectors.size(), 4)); // more overlap
  add_pad_note(plan, scene);
  return plan;
}

} // namespace rimpact::planning
