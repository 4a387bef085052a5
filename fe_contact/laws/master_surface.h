/// Exact surfaces a deformable body may touch: signed distance, unit normal and the normal's derivative.
/// Signs: gap > 0 on the free side, where the body lives; the normal is the gap's gradient, so it points from
/// the surface to the body; `curvature` is the gap's Hessian, dn/dx. SI units, in the surface's own frame.
#pragma once
#include "scene/surface.h"
#include <Eigen/Core>
#include <functional>

namespace rimpact::fe {

struct Distance {
  double gap;                ///< [m]
  Eigen::Vector3d normal;    ///< unit
  Eigen::Matrix3d curvature; ///< d normal / d x [1/m], symmetric
};

struct MasterSurface {
  std::function<Distance(const Eigen::Vector3d &)> distance;
  /// Whether the surface exists opposite a point; past its edge there is no contact. Empty: everywhere.
  std::function<bool(const Eigen::Vector3d &)> covers;
};

/// Which side of a closed surface the body is on.
enum class Side { outside, inside };

/// `normal` need not be a unit vector; it points to the free side.
MasterSurface plane(const Eigen::Vector3d &point, const Eigen::Vector3d &normal);
/// radius > 0 [m].
MasterSurface sphere(const Eigen::Vector3d &centre, double radius, Side side);
/// Circular, endless; `axis` need not be a unit vector.
MasterSurface cylinder(const Eigen::Vector3d &point, const Eigen::Vector3d &axis, double radius, Side side);
/// The dish of a bearing: signed distance to F = 0 by closest-point projection, free above; ends at
/// `planar_radius` [m].
MasterSurface dish(std::shared_ptr<const scene::SlidingSurface> surface, double planar_radius);

} // namespace rimpact::fe
