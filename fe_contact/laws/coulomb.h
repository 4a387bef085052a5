/// Contact of one point with a surface: unilateral pressure and Coulomb friction with elastic slip, both by
/// augmented Lagrangian. Signs: gap > 0 open; pressure >= 0; the normal points from the surface to the point;
/// the traction is what the surface does to the point.
///   p   = max(0, lambda_N - eps_N g)                      (Alart and Curnier 1991; Wriggers, Computational Contact
///   Mechanics) t*  = P lambda_T - eps_T P s,   P = 1 - n n^T         (trial: s is the slip since the step began) t   =
///   t* if |t*| <= mu p, else mu p t*/|t*|           (Simo and Laursen 1992, return map)
/// lambda_T is the friction traction of the last step, or of the last augmentation: with it s tends to zero
/// where the point sticks. Frictionless is mu = 0. Written over the scalar type, so that the consistent,
/// unsymmetric tangent follows by automatic differentiation. SI units.
#pragma once
#include "laws/friction/factors.h"
#include <cmath>
#include <Eigen/Core>
#include <optional>

namespace rimpact::fe {

/// mu(v, p) = (fast - (fast - slow) exp(-rate v)) k_p(p) (thesis eq. 2-18; laws/friction/factors.h), p the pressure at
/// the point; fast = slow and no reference pressure: Coulomb.
struct FrictionCoefficient {
  double fast = 0, slow = 0;                     ///< [-], >= 0
  double rate = 0;                               ///< [s/m], >= 0
  std::optional<double> reference_pressure = {}; ///< of k_p [Pa]; none: not by pressure
  static FrictionCoefficient constant(double mu) { return {mu, mu, 0, {}}; }
  bool depends_on_speed() const { return fast != slow; }
  template <typename T> T at(const T &speed) const { return friction::coefficient_at_speed(speed, slow, fast, rate); }
};

enum class ContactStatus : char { open, stick, slip };

struct CoulombContact {
  double normal_penalty;     ///< eps_N [Pa/m], > 0
  double tangential_penalty; ///< eps_T [Pa/m], > 0
  FrictionCoefficient friction{};

  template <typename T> struct Result {
    Eigen::Matrix<T, 3, 1> traction; ///< on the point [Pa]
    Eigen::Matrix<T, 3, 1> friction; ///< its tangential part [Pa]
    T pressure;                      ///< [Pa]
    ContactStatus status;
  };

  /// gap [m], normal, slip [m] (any vector: projected here) at the end of a step of length dt [s] (0: static);
  /// multipliers [Pa].
  template <typename T>
  Result<T> at(const T &gap, const Eigen::Matrix<T, 3, 1> &normal, const Eigen::Matrix<T, 3, 1> &slip,
               double normal_multiplier, const Eigen::Vector3d &tangential_multiplier, double dt) const;
};

template <typename T>
CoulombContact::Result<T> CoulombContact::at(const T &gap, const Eigen::Matrix<T, 3, 1> &normal,
                                             const Eigen::Matrix<T, 3, 1> &slip, double normal_multiplier,
                                             const Eigen::Vector3d &tangential_multiplier, double dt) const {
  using std::sqrt;
  Result<T> result;
  const T zero(0.0);
  result.pressure = zero;
  for (int i = 0; i < 3; ++i) result.traction[i] = result.friction[i] = zero;
  result.status = ContactStatus::open;
  const T pressure = normal_multiplier - normal_penalty * gap;
  if (!(pressure > 0.0)) return result;
  result.pressure = pressure;
  result.status = ContactStatus::slip;
  for (int i = 0; i < 3; ++i) result.traction[i] = pressure * normal[i];
  if (!(friction.fast > 0 || friction.slow > 0)) return result;

  T slip_along(0.0), multiplier_along(0.0);
  for (int i = 0; i < 3; ++i) {
    slip_along += slip[i] * normal[i];
    multiplier_along += tangential_multiplier[i] * normal[i];
  }
  T squared(0.0), slip_squared(1e-30); // the tiny term keeps the root's derivative finite at rest
  for (int i = 0; i < 3; ++i) {
    const T tangential_slip = slip[i] - slip_along * normal[i];
    result.friction[i] = tangential_multiplier[i] - multiplier_along * normal[i] - tangential_penalty * tangential_slip;
    squared += result.friction[i] * result.friction[i];
    slip_squared += tangential_slip * tangential_slip;
  }
  const T coefficient = friction.depends_on_speed() && dt > 0 ? friction.at(T(sqrt(slip_squared) / dt))
                                                              : T(dt > 0 ? friction.fast : friction.slow);
  T limit = coefficient * pressure;
  if (friction.reference_pressure) limit *= friction::pressure_factor(pressure, *friction.reference_pressure);
  if (squared <= limit * limit) {
    result.status = ContactStatus::stick;
  } else {
    const T factor = limit / sqrt(squared);
    for (int i = 0; i < 3; ++i) result.friction[i] *= factor;
  }
  for (int i = 0; i < 3; ++i) result.traction[i] += result.friction[i];
  return result;
}

} // namespace rimpact::fe
