/// The building's equations M q'' + C q' + K q = f on the dofs that carry mass; all others are condensed. Retained, in
/// this order: of each diaphragm (u_x, u_y, r_z) at its mass centre, then u_z of each node. Rotations of the nodes
/// about x and y carry no mass and follow.
#pragma once
#include "buildings/frame.h"

namespace rimpact::buildings {

struct BuildingModel {
  Eigen::MatrixXd stiffness, damping; ///< K [N/m ...], C
  Eigen::VectorXd mass;               ///< diagonal of M
  int n_diaphragms = 0, n_nodes = 0;
  std::vector<int> bearings; ///< supported nodes, in the nodes' order
  /// Displacement (x, y, z) of each supported node over q.
  std::vector<Eigen::MatrixXd> slider;
  /// All six displacements of every node over q, the rotations that follow included.
  Eigen::MatrixXd nodal;
  int n_dofs() const { return static_cast<int>(mass.size()); }
  int vertical(int node) const { return 3 * n_diaphragms + node; }
  /// Dofs of the base: its diaphragm's three and u_z of the supported nodes; the others.
  std::vector<int> base() const, above_base() const;
};
/// Throws InputError for what Frame::validate refuses and for a mechanism, naming the node that moves freely.
BuildingModel assemble(const Frame &frame);

/// Displacements at rest under weights `gravity` times the masses, sliders at height 0.
Eigen::VectorXd static_displacements(const BuildingModel &model, double gravity);
/// Vertical reactions of the bearings under weights `gravity` times the masses, sliders at the same height [N].
Eigen::VectorXd static_reactions(const BuildingModel &model, double gravity);

} // namespace rimpact::buildings
