/// A slave face and what it presses on: their forces and stiffness by their nodes.
#pragma once
#include "fe_contact/engine/point_traction.h"
#include "fe_contact/solver/tangent.h"

namespace rimpact::fe {

/// The points of a pair are summed up before any of them looks for its place in the matrix, which is what assembling
/// contact costs.
struct FacePair {
  int carrier_face = -1;
  std::vector<int> dofs{};              ///< first of each node's three; empty: nothing summed up
  int n_slave = 0;                      ///< of them are the slave's
  Eigen::Vector3d slave_signs{1, 1, 1}; ///< see PointCoupling
  Eigen::VectorXd forces{};
  Eigen::MatrixXd stiffness{};

  /// A point's traction [Pa] on its area [m^2]; nu: the distance's.
  void add(const PointCoupling &coupling, double area, const Eigen::Vector3d &traction, const TractionTangents &D,
           const Eigen::Vector3d &nu, bool with_stiffness);
  void add_to(const Equations &equations, Eigen::VectorXd &all_forces, Tangent *tangent) const;
};

} // namespace rimpact::fe
