/// The pair (k_i, e) of law `no-tension` that returns a given peak force and rebound, for a free mass at one speed.
#pragma once
#include <optional>

namespace rimpact::calibration {

/// Rebound over approach of a free mass on `no-tension` [-]: with xi = sin b of restitution e, it lets go at
/// w_d t = pi - 2 b and rebounds by exp(-(pi - 2 b) tan b), which falls to exp(-2) = 0.135 as e goes to 0. 0 < e <= 1.
double no_tension_rebound(double restitution);

struct Pair {
  double k_i; ///< [N/m]
  double e;   ///< [-]
};
/// The peak force is v sqrt(k m) kelvin_voigt_peak(e). Empty where no pair rebounds so little (below 0.173, where e
/// would be less than 0.01) or so much (above 1).
std::optional<Pair> no_tension_pair(double peak_force, double rebound_over_approach, double speed, double mass);

} // namespace rimpact::calibration
