/// Where two rigid bodies of a friction-pendulum bearing may touch (thesis 3.3.2.1 and 3.3.2.2, with the true
/// gap rate). SI units.
#pragma once
#include <Eigen/Core>

namespace rimpact::reduced::rigid {

/// Where a body is: its frame's origin, and the rotation from its frame to space.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d at(const Eigen::Vector3d &point) const { return position + rotation * point; }
};

enum class Surface {
  dish,      ///< a point of the body inside the master's sphere
  interface, ///< a point of the body on the master's plane z = centre_z
  rim,       ///< a point, or the edge circle, of the body inside the master's cylinder about its z axis
  stop       ///< a circle of the body inside the cylinder of the master's interface
};
/// Rims and stops are met at a distance; the other surfaces carry the load.
inline bool is_wall(Surface surface) {
  return surface == Surface::rim || surface == Surface::stop;
}

inline constexpr int ground = -1; ///< master that never moves

struct Contact {
  Surface surface;
  int body, master;       ///< which bodies; master may be `ground`
  Eigen::Vector3d point;  ///< body frame: the point, or the circle's centre
  Eigen::Vector3d centre; ///< master frame: the sphere's centre; a point of the plane; the wall's foot on its axis
  double radius = 0;      ///< sphere's, wall's; stop: the gap [m]
  double reach = 0;       ///< radius of the body's circle, 0 for a point [m]
  double wall_height = 0; ///< rim, stop: above the foot, towards the body [m]
  double upward = 1;      ///< rim: +1 when the wall rises along the master's z, -1 when it hangs
  int set = 0;            ///< which joint of the bearing, from the ground up
};

/// A contact in one configuration.
struct Touch {
  Eigen::Vector3d at;     ///< where the force acts
  Eigen::Vector3d normal; ///< unit, from the body into the master; zero short of a rim
  double penetration;     ///< [m], > 0 when pressed
  double curvature;       ///< turning of the normal over sliding [1/m]
  bool passed = false;    ///< rim, stop: beyond the wall but above it
};

/// For a circle the point that is deepest in the wall: the derivative of its penetration is that of the
/// material point, so the gap rate is exact.
Touch locate(const Contact &contact, const Pose &body, const Pose &master);

} // namespace rimpact::reduced::rigid
