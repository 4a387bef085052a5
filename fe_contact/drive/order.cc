#include "fe_contact/drive/order.h"

#include "scene/stack_terms.h"

namespace rimpact::fe {

meshes::MeshOrder mesh_order(const scene::Scene &scene, const planning::Plan &plan) {
  meshes::MeshOrder order;
  order.level = scene.model.mesh;
  order.half = plan.half;
  order.rim = plan.moves_in_time || plan.rim_takes_part;
  order.sector_half_angle = plan.sector_half_angle;
  order.directions = plan.sectors;
  order.own = scene.model.own_mesh;
  return order;
}

ModelOptions model_options(const scene::Scene &scene) {
  ModelOptions options;
  options.friction = scene.excitation.kind != scene::ExcitationKind::window || scene.excitation.with_friction;
  options.penalty_scale = scene.model.penalty_scale;
  options.pad_retardation = scene::pad_retardation(scene);
  return options;
}

StepOptions step_options(const Rung &rung, const scene::Scene &scene) {
  StepOptions options = rung.steps;
  options.rho_inf = scene.model.rho_inf;
  return options;
}

StepOptions step_options(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan) {
  constexpr double shortest_whole_renewal = 1.0 / 32; // of the longest step in contact
  StepOptions options = step_options(rung, scene);
  options.renewal_time = shortest_whole_renewal * plan.step_in_contact;
  return options;
}

} // namespace rimpact::fe
