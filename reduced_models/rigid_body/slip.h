/// The friction state of a contact point: z, tangent to the surface, |z| <= 1; the friction force is -mu N z.
#pragma once
#include "reduced_models/bearings/wen_stage.h"
#include <cmath>
#include <Eigen/Core>

namespace rimpact::reduced::rigid {

struct SlipState {
  Eigen::Vector3d z;          ///< at the end of a step (or stage)
  Eigen::Matrix3d d_velocity; ///< its derivative by the sliding velocity [s/m]
};

/// Coulomb's limit with an elastic slip q: z = w / max(1, |w|), w = z0 + (h/q) v; backward Euler, so that
/// sliding has exactly the direction of v for q -> 0.
inline SlipState coulomb_step(const Eigen::Vector3d &z0, const Eigen::Vector3d &v, double h_over_q) {
  const Eigen::Vector3d w = z0 + h_over_q * v;
  const double length = w.norm();
  if (length <= 1) return {w, h_over_q * Eigen::Matrix3d::Identity()};
  const Eigen::Vector3d z = w / length;
  return {z, h_over_q / length * (Eigen::Matrix3d::Identity() - z * z.transpose())};
}

/// The elastic slip by which Coulomb's limit is approached [m]; the error goes with its square root.
inline constexpr double coulomb_slip = 1e-8;

/// Park-Wen, q z' = v - z max(0, z . v).
inline SlipState park_wen_step(const Eigen::Vector3d &z0, const Eigen::Vector3d &v, double h_over_q) {
  const auto stage = wen_stage<3>(z0, v, h_over_q, 1, 0);
  return {stage.z, stage.d_velocity};
}

} // namespace rimpact::reduced::rigid
