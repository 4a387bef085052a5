/// Friction that is smooth at rest, and Park and Wen's state with an elastic slip.
#pragma once
#include "laws/friction/friction_law.h"
#include <cmath>
#include <Eigen/Core>

namespace rimpact::friction {

/// A friction force and its derivatives: what an implicit time step needs.
struct FrictionForce {
  Eigen::Vector3d force;      ///< [N]
  Eigen::Matrix3d d_velocity; ///< [N s/m]
  Eigen::Vector3d d_normal;   ///< by the normal force [-]
};
/// -mu(s, N) N w / s, w = P v, s = sqrt(|w|^2 + v0^2): `tangent` the projection P on the face, `speed_scale` v0 > 0
/// [m/s].
inline FrictionForce regularised(const FrictionLaw &law, const Eigen::Matrix3d &tangent,
                                 const Eigen::Vector3d &velocity, double normal, double temperature,
                                 double speed_scale) {
  const Eigen::Vector3d w = tangent * velocity;
  const double s = std::sqrt(w.squaredNorm() + speed_scale * speed_scale);
  const Coefficient mu = law.under(normal, s, temperature);
  FrictionForce f;
  f.force = -normal * mu.value / s * w;
  f.d_velocity = -normal * (mu.value / s * tangent + (mu.d_speed - mu.value / s) / (s * s) * w * w.transpose());
  f.d_normal = -law.d_force(mu, normal) / s * w;
  return f;
}

/// Rate of the Park-Wen state (Park, Wen, Ang 1986, A = 1, beta = gamma = 0.5) in its rotation-invariant
/// form:
///   q eta' = v - eta max(0, eta . v),
/// equal to the original in unidirectional motion. |eta| <= 1 is invariant, eta -> v/|v| as q -> 0.
inline Eigen::Vector2d park_wen_rate(const Eigen::Vector2d &eta, const Eigen::Vector2d &v, double elastic_slip) {
  const double work = eta.dot(v);
  return (v - (work > 0 ? work : 0.0) * eta) / elastic_slip;
}

} // namespace rimpact::friction
