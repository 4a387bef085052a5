#include "fe_contact/planning/machine_times.h"
#include "fe_contact/planning/plan_parts.h"
#include "fe_contact/planning/stack_plan.h"

#include "io/files/error.h"
#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "scene/assumptions.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::planning {
namespace {

/// Measured on two cores, half models of the default bearing (docs/results/refinement.md, studies.md), by mesh.
constexpr MeshCost costs[4] = {{5200, 0.08, 0.25e9}, {11000, 0.17, 0.35e9}, {34000, 1.0, 0.8e9}, {89000, 4.0, 2.0e9}};
constexpr double usual_step = 4e-4; // mean of what the error control takes in contact [s]: a shorter bound adds steps

} // namespace

double depth_of_impact(const scene::Scene &scene, double speed) {
  constexpr double measured = 2.58e-3, at_energy = 1739; // shfps-225 at 0.2 m/s [m], [J]
  const int dishes = scene.bearing.dishes();             // each rim takes its share
  const double energy = 0.5 * scene.load.mass * speed * speed / dishes, thickness = scene.bearing.rim.thickness / 0.040;
  const double yield = scene.bearing.rim_steel().yield.value_or(1e9) / 360e6; // elastic: beyond any steel
  const double hardness = std::pow(yield, 0.6) * std::pow(thickness, thickness < 1 ? 0.8 : 0.3);
  return dishes * measured * std::pow(energy / at_energy, 0.68) / hardness;
}

double iterations_of_impact(double depth) {
  return 50 + 130 * std::sqrt(1e3 * depth);
}

void add_impacts(Plan &plan, const Summary &scout, const Response &response) {
  const auto &t = response.series("time");
  for (const auto &impact : scout.impacts) {
    std::size_t k = std::lower_bound(t.begin(), t.end(), impact.touch_time) - t.begin();
    k = std::min(k, t.size() - 1);
    const Eigen::Vector2d u(response.series("displacement_x")[k], response.series("displacement_y")[k]);
    const Eigen::Vector2d v(response.series("velocity_x")[k], response.series("velocity_y")[k]);
    const double tangential = std::abs(u.x() * v.y() - u.y() * v.x()) / std::max(1e-9, u.norm());
    plan.impacts.push_back({impact.touch_time, impact.direction_deg, impact.approach_speed, tangential});
  }
}

namespace {

/// Why pad and foot cannot be built, a sentence; rung `rim` does without them.
std::optional<std::string> unfit_stack(const scene::Bearing &bearing) {
  try {
    bearing.validate();
  } catch (const InputError &error) {
    return error.what();
  }
  return std::nullopt;
}

/// Travel beyond which the dish is too curved for the pad to bear on its whole face; none within L_c. An
/// estimate: on the default dish that is about 0.30 m, where the meridional curvature is 1.6 times the
/// vertex's.
std::optional<double> full_face_travel(const scene::Bearing &bearing) {
  constexpr double curvature_ratio = 1.6;
  const auto surface = scene::make_surface(bearing.surface);
  const double vertex = surface->curvatures(0).meridional, capacity = bearing.lateral_capacity();
  for (double r = 0; r < capacity; r += 0.01 * capacity)
    if (surface->curvatures(r).meridional > curvature_ratio * vertex) return r;
  return std::nullopt;
}

} // namespace

void add_pad_note(Plan &plan, const scene::Scene &scene) {
  if (!scene.bearing.has_pad()) return;
  if (const auto reason = unfit_stack(scene.bearing)) {
    plan.notes.push_back("pad and foot are left out of these notes, rung `rim` needs neither: " + *reason);
    return;
  }
  const double at_rest = scene.load.vertical / scene.bearing.pad_area();
  plan.notes.push_back(fmt::format("pad pressure at rest {:.1f} MPa over its whole face{}", 1e-6 * at_rest,
                                   scene::has_default_pad(scene.bearing)
                                       ? ", of the built-in bearing's pad: the bearing gives none, an assumption"
                                       : ""));
  constexpr double ertalyte_strength = 90e6;
  if (const auto travel = full_face_travel(scene.bearing))
    plan.notes.push_back(
        fmt::format("beyond {:.2f} m of travel the pad bears fore and aft only and its peak pressure passes Ertalyte's "
                    "{:.0f} MPa: 'elastic' is then a modelling convention",
                    *travel, 1e-6 * ertalyte_strength));
  if (at_rest > ertalyte_strength)
    plan.notes.push_back(fmt::format("the pad pressure at rest, {:.1f} MPa, exceeds Ertalyte's {:.0f} MPa",
                                     1e-6 * at_rest, 1e-6 * ertalyte_strength));
}

namespace {

/// The scout once more, with the terms that pad and socket add; `stack` has them afterwards.
void add_stack_note(Plan &plan, scene::Scene &stack) {
  reduced::add_stack_terms(stack);
  const auto stack_run = reduced::simulate_summary(stack);
  plan.notes.push_back(fmt::format("with the pad's size and elasticity and the socket's friction the scout sees {} "
                                   "impact(s), closest gap {:.2f} mm",
                                   stack_run.impacts.size(),
                                   1e3 * (stack.bearing.lateral_capacity() - stack_run.peak_displacement)));
}

/// The scout: the reduced model, as the scene has it and with the extra terms that a real stack adds.
void scout(Plan &plan, scene::Scene scene) {
  if (scene.reduced.k_i == 0) scene.reduced.k_i = scene::ReducedSettings{}.k_i; // a scout must feel the rim
  scene = reduced::in_one_piece(std::move(scene)); // finite elements go on where its foot goes
  const auto run = reduced::simulate(scene);
  add_impacts(plan, run.summary, run.response);
  plan.closest_gap = scene.bearing.lateral_capacity() - run.summary.peak_displacement;
  constexpr double margin = 0.005; // of travel [m]: a pass this near may touch in the finite-element run
  plan.rim_takes_part = !plan.impacts.empty() || plan.closest_gap < margin;
  for (const auto &impact : plan.impacts) plan.half = plan.half && impact.tangential_speed < 1e-9;

  const bool has_stack = scene.bearing.has_pad() && !unfit_stack(scene.bearing);
  scene::Scene stack = scene;
  if (has_stack) add_stack_note(plan, stack);
  if (scene.excitation.kind != scene::ExcitationKind::ricker) return;
  for (const auto &[label, variant] :
       {std::pair{"as the scene has it", &scene}, {"with the terms of pad and socket", &stack}}) {
    if (variant == &stack && !has_stack) continue;
    scene::Scene unit = *variant;
    if (const auto critical = reduced::critical_scale(unit))
      plan.notes.push_back(fmt::format("the rim is first touched at {:.5f} of scale 1, {:.4f} g ({})", *critical,
                                       *critical * scene.excitation.amplitude_g, label));
  }
}

} // namespace

namespace {

double iterations_of_rim(const Plan &plan, const scene::Scene &scene) {
  if (!plan.rim_takes_part) return 0;
  const double finer = std::max(1.0, usual_step / plan.step_in_contact);
  if (scene.excitation.kind == scene::ExcitationKind::push)
    return 0.6 * iterations_of_impact(scene.excitation.travel);           // 8 mm in and out: 211 to 300
  double iterations = plan.impacts.empty() ? iterations_of_impact(0) : 0; // a pass that may touch
  for (const auto &impact : plan.impacts)
    iterations += iterations_of_impact(depth_of_impact(scene, impact.approach_speed));
  return finer * iterations;
}

Plan rim_plan(const scene::Scene &scene) {
  using Kind = scene::ExcitationKind;
  Plan plan;
  plan.mesh = scene.model.mesh;
  if (scene.model.step > 0) plan.step_in_contact = scene.model.step;
  const Kind kind = scene.excitation.kind;
  if (kind == Kind::window)
    plan.impacts.push_back({0.0, scene.excitation.direction_deg, scene.excitation.speed * scene.excitation.scale, 0.0});
  else if (scene.excitation.stays_on_dish()) {
    plan.closest_gap = scene.bearing.lateral_capacity() - reduced::simulate_summary(scene).peak_displacement;
    plan.rim_takes_part = plan.closest_gap < 0;
  } else if (kind != Kind::push) {
    scout(plan, scene);
  }
  add_pad_note(plan, scene);
  if (scene.model.symmetry != scene::Symmetry::by_plan) plan.half = scene.model.symmetry == scene::Symmetry::half;

  const MeshCost &cost = costs[plan.mesh];
  constexpr double whole_over_half = 3, edge_of_default = 0.52;                           // [m]
  const double size = std::pow(scene.bearing.surface.planar_radius / edge_of_default, 2); // of the meshed sector
  plan.expected_dofs = std::lround(cost.dofs * size * (plan.half ? 1 : 2));
  plan.expected_memory_bytes = cost.memory * size * (plan.half ? 1 : 2.3);
  plan.expected_iterations = iterations_of_rim(plan, scene);
  plan.expected_seconds =
      3 + plan.expected_iterations * size * cost.seconds_per_iteration * (plan.half ? 1 : whole_over_half);
  return plan;
}

} // namespace

Plan make_plan(const scene::Scene &scene) {
  Plan plan = flies_reduced(scene.model.rung) ? rim_plan(scene)
              : scene.excitation.is_dynamic() ? stack_motion_plan(scene)
                                              : stack_path_plan(scene);
  time_by_this_machine(plan);
  if (scene.model.own_mesh.any())
    plan.notes.insert(plan.notes.begin(), "own mesh " + scene.model.own_mesh.file +
                                              ": unknowns, time and memory above are the built-in mesh's");
  return plan;
}

std::string describe(const Plan &plan) {
  const std::string steps =
      plan.expected_steps == 0
          ? fmt::format("steps of {:.2f} ms in contact", 1e3 * plan.step_in_contact)
          : fmt::format("about {} steps{}", plan.expected_steps,
                        plan.moves_in_time ? fmt::format(", of {:.2f} ms in contact", 1e3 * plan.step_in_contact)
                                           : " along the path");
  std::string text = fmt::format("plan: rung {}, {} model, mesh {}, about {} unknowns; {}; {} and {:.1f} GB\n",
                                 word(plan.rung), plan.half ? "symmetric half" : "whole", plan.mesh, plan.expected_dofs,
                                 steps, expected_time(plan), 1e-9 * plan.expected_memory_bytes);
  if (!plan.rim_takes_part)
    text += fmt::format("  the rim takes no part: the scout stays {:.2f} mm away\n", 1e3 * plan.closest_gap);
  for (const auto &impact : plan.impacts)
    text += fmt::format("  impact expected at {:.4f} s, {:.1f} deg, {:.3f} m/s\n", impact.touch_time,
                        impact.direction_deg, impact.approach_speed);
  for (const auto &note : plan.notes) text += "  " + note + "\n";
  return text;
}

nlohmann::json to_json(const Plan &plan) {
  nlohmann::json impacts = nlohmann::json::array();
  for (const auto &impact : plan.impacts)
    impacts.push_back({{"touch_time_s", impact.touch_time},
                       {"direction_deg", impact.direction_deg},
                       {"approach_speed_m_s", impact.approach_speed},
                       {"tangential_speed_m_s", impact.tangential_speed}});
  nlohmann::json sectors = nlohmann::json::array();
  for (const double direction : plan.sectors) sectors.push_back(direction * 180 / M_PI);
  return {{"rung", word(plan.rung)},
          {"expected_steps", plan.expected_steps},
          {"symmetry", plan.half ? "half" : "whole"},
          {"moves_from_s", plan.moves_from},
          {"rests_from_s", plan.rests_from},
          {"rim_takes_part", plan.rim_takes_part},
          {"closest_gap_m", plan.closest_gap},
          {"impacts", impacts},
          {"sector_directions_deg", sectors},
          {"sector_half_angle_deg", plan.sector_half_angle * 180 / M_PI},
          {"step_in_contact_s", plan.step_in_contact},
          {"mesh", plan.mesh},
          {"expected_dofs", plan.expected_dofs},
          {"expected_seconds", plan.expected_seconds},
          {"expected_seconds_range", {plan.fastest, plan.slowest}},
          {"expected_iterations", plan.expected_iterations},
          {"timed_here", plan.timed_here},
          {"expected_memory_bytes", plan.expected_memory_bytes},
          {"notes", plan.notes}};
}

} // namespace rimpact::planning
