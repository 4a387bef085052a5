/// Hunt and Crossley (1975): damping grows with the penetration, so that the force starts and ends at zero and the
/// restitution falls with speed.
#pragma once

namespace rimpact::laws {

struct HuntCrossleyNumbers {
  double impact_exponent = 1.5; ///< n [-], > 0
  double reference_speed = 0.5; ///< at which the restitution holds [m/s], > 0
  bool operator==(const HuntCrossleyNumbers &) const = default;
};

/// chi [s/m] of F = K d^n (1 + chi d') that gives restitution e at the approach speed v: with a = chi v,
/// a - ln(1 + a) = -e a - ln(1 - e a), whatever K, n and the mass (work of both phases over the same d).
/// Throws InputError for e outside (0, 1] and v <= 0.
double hunt_crossley_dissipation(double restitution, double speed);
/// Penetration at which k_i is the secant stiffness [m]: K = k_i d_1 / d_1^n.
inline constexpr double hunt_crossley_penetration = 1e-3;

} // namespace rimpact::laws
