#include "fe_contact/drive/stack_drive.h"

#include "files/error.h"

namespace rimpact::fe {

meshes::StackMeshOptions stack_mesh_options(const scene::Scene &scene, const planning::Plan &plan) {
  meshes::StackMeshOptions mesh;
  mesh.level = scene.model.mesh;
  mesh.half = plan.half;
  mesh.whole_plate = plan.rung == "full";
  mesh.rim = plan.moves_in_time || plan.rim_takes_part || mesh.whole_plate;
  mesh.sector_half_angle = plan.sector_half_angle;
  mesh.directions = plan.sectors;
  mesh.own = scene.model.own_mesh;
  return mesh;
}

StepOptions stack_step_options() {
  StepOptions options;
  options.newton.tolerance = 1e-6;
  options.newton.finest_forcing = 1e-3;
  options.tolerance_between = 1e-3;
  options.gap_tolerance = 1e-5;
  options.slip_tolerance = 1e-5;
  options.max_augmentations = 4;
  return options;
}

void preload_stack(StackSystem &system, SystemState &state, const Eigen::VectorXd &load, const StepOptions &options) {
  constexpr double springs = 1e8; // first round of stabilisation [N/m an equation]
  const PreloadReport report = preload(system, state, load, springs, options);
  if (!report.converged) throw SolverStopped("the bearing did not come to rest under its load: " + report.reason);
}

ContactStepReport TopDrive::move_to(StackSystem &system, SystemState &state, const Eigen::Vector2d &target,
                                    const Eigen::VectorXd &load, const StepOptions &options) {
  StepTerms terms{load};
  for (int i = 0; i < 2; ++i)
    if (system.top(i) >= 0) terms.driven.push_back({system.top(i), target[i]});
  const Eigen::VectorXd before = state.u;
  const Eigen::Vector2d way = target - system.top_of(state.u).head<2>();
  ContactStepReport step = static_step(system, state, terms, options, guess(system, state, way));
  if (!step.converged) return step;
  last_change = state.u - before;
  last_way = way;
  return step;
}

/// At first the whole stack goes along in translation.
Eigen::VectorXd TopDrive::guess(const StackSystem &system, const SystemState &state, const Eigen::Vector2d &way) const {
  if (last_way.squaredNorm() > 0) return state.u + way.dot(last_way) / last_way.squaredNorm() * last_change;
  const auto &equations = system.equations();
  Eigen::VectorXd u = state.u;
  for (std::size_t dof = 0; dof < equations.of_dof.size(); ++dof)
    if (const int equation = equations.of_dof[dof]; equation >= 0 && dof % 3 < 2)
      u[equation] = state.u[equation] + way[dof % 3];
  return u;
}

} // namespace rimpact::fe
