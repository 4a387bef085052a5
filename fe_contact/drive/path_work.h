/// Work of a force along a path that is known at its steps' ends.
#pragma once
#include <algorithm>
#include <cmath>
#include <Eigen/Core>

namespace rimpact::fe {

/// A parabola through the last three points where the path goes on, a chord at its start and where it turns. Its error
/// is a third power of the step, times the force's change of curvature; a chord's is of the curvature itself.
struct PathWork {
  Eigen::Vector3d way = Eigen::Vector3d::Zero();    ///< of the last step [m]
  Eigen::Vector3d change = Eigen::Vector3d::Zero(); ///< of the force over it [N]

  /// Work of the force over one step [J]; the step is remembered.
  double add(const Eigen::Vector3d &before, const Eigen::Vector3d &after, const Eigen::Vector3d &step) {
    const double chord = 0.5 * (before + after).dot(step), length = step.norm(), last = way.norm();
    const double rise = (after - before).dot(step);
    double bend = 0;
    if (last > 0 && length > 0 && way.dot(step) > 0) {
      const Eigen::Vector3d second = ((after - before) / length - change / last) / (length + last);
      // At a kink (touch, a turn of friction) no parabola fits: a monotone one lies within a sixth of the rise.
      bend = std::clamp(second.dot(step) * length * length / 6, -std::abs(rise) / 6, std::abs(rise) / 6);
    }
    way = step, change = after - before;
    return chord - bend;
  }
};

} // namespace rimpact::fe
