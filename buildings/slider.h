/// Where a bearing's slider is among the building's dofs: three of its diaphragm and the node's own u_z. SI units.
#pragma once
#include "buildings/assembly.h"
#include <array>

namespace rimpact::buildings {

struct Slider {
  std::array<int, 4> dof; ///< u_x, u_y, r_z of the diaphragm; u_z of the node
  double arm_x, arm_y;    ///< of the node from the diaphragm's mass centre [m]

  Eigen::Vector3d of(const double *q) const {
    return {q[dof[0]] - arm_y * q[dof[2]], q[dof[1]] + arm_x * q[dof[2]], q[dof[3]]};
  }
  /// Adds the generalised forces of `force` at the slider.
  void add(const Eigen::Vector3d &force, Eigen::Ref<Eigen::VectorXd> f) const {
    f[dof[0]] += force[0], f[dof[1]] += force[1], f[dof[3]] += force[2];
    f[dof[2]] += arm_x * force[1] - arm_y * force[0];
  }
};
/// In the order of model.bearings.
std::vector<Slider> sliders(const BuildingModel &model);

} // namespace rimpact::buildings
