/// Carries displacements and material memory from one mesh to another of the same bodies, each body for itself: nodal
/// values by the old cells' shape functions, which is exact where the meshes agree; a material point takes the memory
/// of the old cell's nearest one. What the old mesh did not have (a rim meshed only now) is as made. Q2 only.
#pragma once
#include "fe_contact/engine/solid.h"

namespace rimpact::fe {

class MeshTransfer {
public:
  MeshTransfer(const Discretisation &from, const Discretisation &to);

  /// Values of the new dofs; zero where the old mesh had nothing.
  Eigen::VectorXd nodal(const Eigen::VectorXd &by_dof) const;
  SolidHistory history(const SolidHistory &old) const;

private:
  struct Place {
    int cell = -1;                                ///< of the old mesh, -1: none
    Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< in the unit cell
  };
  const Discretisation &from_, &to_;
  std::vector<Place> nodes_, points_; ///< of the new mesh: [node]; [cell][full point]
};

} // namespace rimpact::fe
