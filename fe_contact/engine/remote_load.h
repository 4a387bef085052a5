/// A remote displacement (three equations that a whole face follows) and what acts on it: forces that depend on where
/// it is and how fast it moves, and at most one constraint on its velocity, whose multiplier is an unknown of the step.
/// SI units.
#pragma once
#include <Eigen/Core>
#include <functional>

namespace rimpact::fe {

/// Of the whole bearing.
struct RemoteLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();          ///< [N]
  Eigen::Matrix3d d_displacement = Eigen::Matrix3d::Zero(); ///< of the force [N/m]
  Eigen::Matrix3d d_velocity = Eigen::Matrix3d::Zero();     ///< [N s/m]
  bool constrained = false;                                 ///< the dish carries the mass, or its height is held
  /// Speed off the dish, which must vanish [m/s]: held so, and not by the height itself, the multiplier stays of the
  /// size of the forces however short the step (index 2, not 3).
  double constraint = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();        ///< of it by the velocity
  Eigen::Vector3d by_displacement = Eigen::Vector3d::Zero(); ///< of it by the displacement [1/s]
  Eigen::Vector3d d_multiplier = Eigen::Vector3d::Zero();    ///< d force / d multiplier
};
using RemoteLaw = std::function<RemoteLoad(const Eigen::Vector3d &u, const Eigen::Vector3d &v, double multiplier)>;

struct RemoteFace {
  int equation[3] = {-1, -1, -1}; ///< -1: held

  Eigen::Vector3d of(const Eigen::VectorXd &by_equation) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      if (equation[i] >= 0) result[i] = by_equation[equation[i]];
    return result;
  }
};

/// What a step in time asks of a remote displacement.
struct RemoteTerms {
  RemoteFace face;
  RemoteLaw law;         ///< at the step's end
  double share = 1;      ///< whole bearing over model
  double multiplier = 0; ///< where the step begins
};

} // namespace rimpact::fe
