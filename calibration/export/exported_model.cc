#include "calibration/export/exported_model.h"

#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "scene/stack_terms.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::calibration {

/// The reduced model's run; none: it stopped.
std::optional<Arrival> fly_model(const scene::Scene &scene) {
  const Summary run = reduced::simulate_summary(scene);
  if (run.status != RunStatus::done) return std::nullopt;
  Arrival all{.touch_speed = 0, .peak_force = 0, .largest_travel = run.peak_displacement};
  if (!run.impacts.empty()) all.touch_speed = run.impacts.front().approach_speed;
  for (const auto &impact : run.impacts) all.peak_force = std::max(all.peak_force, impact.peak_force);
  return all;
}

scene::Scene under_pulse(const scene::Scene &model, const char *pulse) {
  constexpr double after_pulse = 3; // [s]
  scene::Scene scene = model;
  scene.excitation = scene::load_scene(pulse).excitation;
  scene.excitation.duration = 2 * scene.excitation.period + after_pulse;
  return scene;
}

scene::Scene with_varying_load(scene::Scene scene) {
  constexpr double dt = 5e-3; // straight lines between are within 0.1 % of sine and pulse [s]
  const double g = scene.load.gravity;
  const scene::GroundMotion pulse(scene.excitation, g);
  scene::Excitation record;
  record.kind = scene::ExcitationKind::record, record.duration = scene.excitation.duration;
  record.x.dt = record.z.dt = dt;
  for (double t = 0; t < record.duration + dt; t += dt) {
    record.x.values.push_back(pulse.acceleration(t).x());
    record.z.values.push_back(check_vertical_g * g * std::sin(2 * std::numbers::pi * check_vertical_hz * t));
  }
  scene.excitation = std::move(record);
  return scene;
}

/// What the scales of the main job are multiplied with: one, where the largest of them brings the model to its rim.
std::optional<double> unit_scale(scene::Scene scene) {
  constexpr double above_first_touch = 1.05;
  scene.excitation.scale = check_scales.back();
  if (const auto run = fly_model(scene); run && run->touch_speed > 0) return 1.0;
  const auto first = reduced::critical_scale(scene, 0.1, 5.0, 1e-4);
  return first ? std::optional(above_first_touch * *first) : std::nullopt;
}

double fastest_touch(const scene::Scene &scene, const ExportedRim &rim) {
  double fastest = 0;
  for (const char *pulse : check_pulses) {
    scene::Scene flown = under_pulse(model_of(scene, rim), pulse);
    const auto unit = unit_scale(flown);
    if (!unit) continue;
    flown.excitation.scale = check_scales.back() * *unit;
    for (const auto &impact : reduced::simulate_summary(flown).impacts)
      fastest = std::max(fastest, impact.approach_speed);
  }
  return fastest;
}

std::string words_of(const Arrival &arrival) {
  if (!(arrival.touch_speed > 0)) return fmt::format("no touch, {:.1f} mm", 1e3 * arrival.largest_travel);
  return fmt::format("{:.3f} m/s, {:.0f} kN", arrival.touch_speed, arrival.peak_force / 1e3);
}

scene::Scene model_of(const scene::Scene &scene, const ExportedRim &rim) {
  scene::Scene model;
  model.bearing = scene.bearing, model.reduced = scene.reduced;
  model.load = {.vertical = rim.vertical, .mass = rim.mass, .gravity = rim.gravity};
  static_cast<laws::LawNumbers &>(model.reduced) = rim.settings;
  model.reduced.impact_law = rim.settings.impact_law;
  model.reduced.forget_foot(); // of the scene's own law
  model.reduced.model = scene::ModelKind::physical;
  if (model.reduced.normal_force != scene::NormalForce::pad) model.reduced.normal_force = scene::NormalForce::inertia;
  model.reduced.capacity_offset = rim.lateral_capacity - scene.bearing.lateral_capacity();
  return model;
}

void take_stack(scene::Scene &scene, const scene::StoredAnswer &answer) {
  if (!answer.stack) return;
  const scene::StoredStack &stack = *answer.stack;
  scene::ReducedSettings &r = scene.reduced;
  r.finite_pad = stack.finite_pad.value_or(false), r.socket_friction = stack.socket_friction.value_or(false);
  r.normal_force = stack.normal_force.value_or(scene::NormalForce::inertia);
  r.friction = stack.friction.value_or(r.friction);
  r.elastic_slip = stack.elastic_slip.value_or(r.elastic_slip);
  if (stack.slip_from == scene::SlipFrom::bearing) scene::resolve_elastic_slip(scene);
  scene::leave_out_what_does_not_fit(scene);
}

std::vector<std::string> stack_effect(const scene::Scene &scene, const ExportedRim &rim) {
  const auto &r = scene.reduced;
  if (!r.finite_pad && !r.socket_friction && r.friction == scene::Friction::coulomb) return {};
  scene::Scene bare = scene;
  bare.reduced.finite_pad = bare.reduced.socket_friction = false, bare.reduced.friction = scene::Friction::coulomb;
  bare.reduced.normal_force = scene::NormalForce::inertia;
  std::vector<std::string> all;
  for (const char *pulse : check_pulses) {
    scene::Scene with = under_pulse(model_of(scene, rim), pulse), without = under_pulse(model_of(bare, rim), pulse);
    const auto unit = unit_scale(with);
    if (!unit) continue;
    with.excitation.scale = without.excitation.scale = check_scales[1] * *unit;
    const auto a = fly_model(with), b = fly_model(without);
    if (a && b)
      all.push_back(
          fmt::format("Terms of pad and socket under {} x {:.4g}: without them the model has {}, with them {}.", pulse,
                      with.excitation.scale, words_of(*b), words_of(*a)));
  }
  return all;
}

} // namespace rimpact::calibration
