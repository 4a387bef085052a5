/// End forces of a frame's members, local axes of Element: axial, shears, torsion and bending moments that the nodes
/// exert on the member's ends. Loads along a member are left out: weights stand at the nodes. SI units.
#pragma once
#include "buildings/assembly.h"
#include <array>

namespace rimpact::buildings {

class MemberForces {
public:
  static constexpr int n_components = 12; ///< (N_x, V_y, V_z, T, M_y, M_z) of end i, then of end j
  MemberForces(const Frame &frame, const BuildingModel &model);
  /// Twelve a member, in the members' order, at displacements q [N], [N m].
  Eigen::VectorXd at(const Eigen::VectorXd &q) const { return over_q_ * q; }

private:
  Eigen::MatrixXd over_q_;
};

/// Least and largest of every end force over a run.
struct MemberEnvelope {
  Eigen::VectorXd least, largest, at_rest;
  void widen(const Eigen::VectorXd &forces);
};

/// members.csv: one row a member's end: least and largest of the six forces, and what acts at rest.
void write_members(const Frame &frame, const MemberEnvelope &envelope, const std::string &path);

} // namespace rimpact::buildings
