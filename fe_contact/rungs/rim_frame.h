/// Between the plate's frame and an arc's: +x' radially outwards at the arc's direction, origin of
/// displacements at the position of first touch (travel L_c, height of the surface there).
#pragma once
#include <cmath>
#include <Eigen/Core>

namespace rimpact::fe {

struct RimFrame {
  double direction;        ///< of the arc [rad]
  double lateral_capacity; ///< L_c [m]
  double touch_height;     ///< height of the surface at L_c [m]

  Eigen::Matrix3d rotation() const {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    R(0, 0) = R(1, 1) = std::cos(direction);
    R(1, 0) = std::sin(direction);
    R(0, 1) = -R(1, 0);
    return R;
  }
  Eigen::Vector3d to_local(const Eigen::Vector3d &vector) const { return rotation().transpose() * vector; }
  Eigen::Vector3d to_global(const Eigen::Vector3d &vector) const { return rotation() * vector; }
  /// Slider displacement (global) -> master displacement (local), and back.
  Eigen::Vector3d master(const Eigen::Vector3d &displacement) const {
    return to_local(displacement) - Eigen::Vector3d(lateral_capacity, 0, touch_height);
  }
  Eigen::Vector3d displacement(const Eigen::Vector3d &master) const {
    return to_global(master + Eigen::Vector3d(lateral_capacity, 0, touch_height));
  }
};

} // namespace rimpact::fe
