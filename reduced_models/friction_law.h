/// Sliding friction: coefficient over speed, and the biaxial hysteretic state that regularises Coulomb's law.
#pragma once
#include <Eigen/Core>

namespace rimpact::reduced {

struct ValueAndSlope {
  double value, slope;
};

/// Sliding friction coefficient with exponential transition in speed.
/// Source: thesis eq. (2-18), after Constantinou et al. (1990).
struct FrictionCoefficient {
  double mu_slow = 0.07; ///< [-], 0 <= mu_slow <= mu_fast
  double mu_fast = 0.07; ///< [-]
  double rate = 0;       ///< [s/m], > 0; not read when mu_slow == mu_fast
  void validate() const; ///< throws InputError naming value and bound
  bool constant() const { return mu_slow == mu_fast; }
  ValueAndSlope at(double speed) const; ///< speed [m/s] >= 0 -> mu [-], dmu/dspeed [s/m]
};

/// Rate of the Park-Wen state (Park, Wen, Ang 1986, A = 1, beta = gamma = 0.5) in its rotation-invariant
/// form:
///   q eta' = v - eta max(0, eta . v),
/// equal to the original in unidirectional motion. |eta| <= 1 is invariant, eta -> v/|v| as q -> 0.
inline Eigen::Vector2d park_wen_rate(const Eigen::Vector2d &eta, const Eigen::Vector2d &v, double elastic_slip) {
  const double work = eta.dot(v);
  return (v - (work > 0 ? work : 0.0) * eta) / elastic_slip;
}

} // namespace rimpact::reduced
