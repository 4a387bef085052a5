#include "fe_contact/runner/stack_recorder.h"

#include "fe_contact/runner/sample_row.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

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
  double strain = 0, pressure = 0, surface_gap = gap;
  for (const auto &point : state.history) strain = std::max(strain, point.alpha);
  for (const auto &report : state.reports) pressure = std::max(pressure, report.largest_pressure);
  if (state.reports.size() > StackSystem::rim && std::isfinite(state.reports[StackSystem::rim].smallest_gap))
    surface_gap = state.reports[StackSystem::rim].smallest_gap;
  append(record_, {time, u, v, forces.total(), forces.dish - forces.friction, forces.friction, forces.rim, forces.dish.z(),
                   gap, surface_gap, strain, pressure, iterations, step, state.reports[StackSystem::dish].largest_pressure});
}

void StackRecorder::write_fields(double time, const StackSystem &system, const SystemState &state,
                                 const Eigen::VectorXd &displacements) {
  if (!options_.keeps_fields()) return;
  const Discretisation &space = model_.space;
  SolidFields cells = model_.solid.fields(displacements, state.history);
  std::vector<double> pressure(space.n_nodes, 0.0), gap(space.n_nodes, 0.0);
  for (std::size_t i = 0; i < state.contacts.size(); ++i)
    system.contact(i).nodal_fields(state.contacts[i], pressure, gap);
  for (double &value : pressure) value *= 1e-6;
  for (double &value : gap) value = std::isfinite(value) ? 1e3 * value : 0;
  for (double &value : cells.von_mises) value *= 1e-6;
  const auto name = fmt::format("fields/stack_{:03d}.vtu", record_.fields.size());
  std::filesystem::create_directories(options_.folder + "/fields");
  space.write_vtu(options_.folder + "/" + name,
                  {{"displacement", 3, false, {displacements.data(), displacements.data() + displacements.size()}},
                   {"contact_pressure_MPa", 1, false, pressure},
                   {"gap_mm", 1, false, gap},
                   {"von_mises_MPa", 1, true, cells.von_mises},
                   {"equivalent_plastic_strain", 1, true, cells.plastic_strain}});
  record_.fields.emplace_back(time, name);
}

} // namespace rimpact::fe
