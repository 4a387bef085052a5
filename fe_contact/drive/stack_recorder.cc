#include "fe_contact/drive/stack_recorder.h"

#include "fe_contact/drive/sample_row.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {

StackForces forces_of(const StackModel &model, const SystemState &state) {
  StackForces result;
  result.dish = model.share() * state.reports[StackSystem::dish].force;
  result.friction = model.share() * state.reports[StackSystem::dish].friction;
  if (state.reports.size() > StackSystem::rim) result.rim = model.share() * state.reports[StackSystem::rim].force;
  if (model.mesh.half) result.dish.y() = result.friction.y() = result.rim.y() = 0; // the mirrored half takes it away
  return result;
}

void StackRecorder::sample(double time, const Eigen::Vector3d &u, const Eigen::Vector3d &v, const SystemState &state,
                           int iterations, double step) {
  const StackForces forces = forces_of(model_, state);
  const double gap = scene_.bearing.lateral_capacity() - u.head<2>().norm();
  double pressure = 0, surface_gap = gap;
  for (const auto &report : state.reports) pressure = std::max(pressure, report.largest_pressure);
  if (state.reports.size() > StackSystem::rim && std::isfinite(state.reports[StackSystem::rim].smallest_gap))
    surface_gap = state.reports[StackSystem::rim].smallest_gap;
  append(record_, {time, u, v, forces.total(), forces.dish - forces.friction, forces.friction, forces.rim,
                   forces.dish.z(), gap, surface_gap, largest_plastic_strain(state.history), pressure, iterations, step,
                   state.reports[StackSystem::dish].largest_pressure});
}

} // namespace rimpact::fe
