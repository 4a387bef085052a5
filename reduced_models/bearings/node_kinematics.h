/// A bearing as an element between two nodes of a structure, twelve degrees of freedom (thesis 2.2.2, 2.2.4):
/// I below, fixed to the plate, J above, fixed to the slider. SI units, global axes, z up.
///
///   u = [u_J (3), r_J (3), u_I (3), r_I (3)],   delta = S_bar(u) u,   delta' = S_hat(u) u',   F = S_hat^T f.
///
/// delta is the slider's displacement seen from the plate, to first order in the rotations and with their
/// products with displacements kept: these are what give the P-Delta moments at both nodes.
#pragma once
#include "responses/response.h"
#include <Eigen/Core>

namespace rimpact::reduced {

using NodalVector = Eigen::Matrix<double, 12, 1>;
using KinematicMatrix = Eigen::Matrix<double, 3, 12>;

/// Distances of the nodes from the dish's vertex at rest [m], >= 0.
struct NodeHeights {
  double below; ///< l_i
  double above; ///< l_j
};

/// S_bar of (2-10).
KinematicMatrix displacement_matrix(const NodeHeights &heights, const NodalVector &u);
/// S_hat = d delta / du, (2-11) with its misprints put right: entry (1,3) is -r_y of I, (3,2) is -r_x of I.
KinematicMatrix velocity_matrix(const NodeHeights &heights, const NodalVector &u);
/// Forces and moments at the nodes [N, N m], ordered as u, that do the work of `force` (2-23). The forces on J
/// are `force` itself while I has not turned.
NodalVector nodal_forces(const NodeHeights &heights, const NodalVector &u,
                         const Eigen::Vector3d &force); /// Adds moment_below and moment_above to a response: nodes that
                                                        /// do not turn, J moving with the slider.
void add_nodal_moments(Response &response, const NodeHeights &heights);

} // namespace rimpact::reduced
