/// What goes through the rim's foot, the section between the rim's volume and the plate's: forces and moments per
/// length and in total, from the internal forces of the rim's cells.
///
/// Per length at an angle theta: forces of the section's nodes over the areas they stand for, times the wall's
/// thickness, both summed with the weight (1 - s^2 / R^2)^2 over the arc s of the wall's middle, R the reach of the
/// joint (foot_reach). Moments are about the middle of what is weighted, in the displaced state. The tangential force
/// of nodes on a cut of the mesh is the cut's own and left out.
#pragma once
#include "fe_contact/engine/solid.h"
#include "responses/foot_strength.h"

namespace rimpact::fe {

/// Of the whole bearing, what the wall does to the plate; signs as in FootLine.
struct FootForces {
  double normal = 0, shear = 0, moment = 0; ///< summed over the foot [N], size of the horizontal sum [N], [N m]
  FootLine worst;                           ///< where the joint, or two fillet welds, is used most
  double weld = 0;                          ///< there, of one of two fillet welds [N/m]
  std::optional<double> use;                ///< of the joint [-]; none: one piece
  /// Of a foot that carries nothing.
  static FootForces none(const scene::Bearing &bearing) {
    FootForces zero;
    zero.use = foot_use(bearing, {});
    return zero;
  }
};

class RimFoot {
public:
  /// `half`: the mesh is the half y >= 0. A mesh without a rim on a plate has no foot.
  RimFoot(const Discretisation &space, const Solid &solid, const scene::Bearing &bearing, bool half);

  bool exists() const { return !nodes_.empty(); }
  /// Forces of the rim on the plate's nodes of the section, by `nodes()` [N]; u: displacements by dof [m].
  Eigen::Matrix3Xd nodal_forces(const Eigen::VectorXd &u, const SolidHistory &history) const;
  const std::vector<unsigned> &nodes() const { return nodes_; }
  FootForces of(const Eigen::VectorXd &u, const SolidHistory &history) const;

private:
  /// A node's share, turned to its own radial direction.
  struct Share {
    double angle, area;             ///< [rad], [m^2]
    double radial, along, vertical; ///< [N]
    double r, z;                    ///< displaced place [m]
  };
  std::vector<Share> shares(const Eigen::VectorXd &u, const SolidHistory &history) const;
  FootLine line_at(double angle, const std::vector<Share> &shares) const;
  void find_section();
  void add_area(std::size_t cell, int axis, int end);

  const Discretisation &space_;
  const Solid &solid_;
  const scene::Bearing bearing_;
  const bool half_;
  std::vector<unsigned> nodes_;    ///< of the section, rising
  std::vector<std::size_t> cells_; ///< of the rim, with a node of the section
  std::vector<double> areas_;      ///< that the nodes stand for [m^2]
  std::vector<bool> on_cut_;       ///< of the mesh: symmetry or a sector's end
  std::vector<double> angles_;     ///< at which lines are looked at [rad]
};

} // namespace rimpact::fe
