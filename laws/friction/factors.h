/// How the coefficient of a sliding face follows speed, pressure and temperature: factors of its value at the reference
/// pressure, at speed and at 20 degrees Celsius. Written over the scalar type, so that tangents follow by automatic
/// differentiation. SI units, temperatures in degrees Celsius.
/// Source: Kumar, Whittaker and Constantinou (2015), Characterizing friction in sliding isolation bearings, Earthquake
/// Engineering & Structural Dynamics 44(9), 1409-1425; OpenSees' element FPBearingPTV has the same formulas.
#pragma once
#include <cmath>

namespace rimpact::friction {

/// k_p = 0.7^(0.02 (p - p0)), p in MPa: pressures >= 0 [Pa], 1 at p0.
template <class T> T pressure_factor(const T &pressure, double reference) {
  using std::exp, std::log;
  const double per_pascal = 0.02e-6 * log(0.7);
  return exp(per_pascal * (pressure - reference));
}

/// k_T = 0.79 (0.7^(0.02 T) + 0.4), T >= -50 [degrees Celsius]; the printed constant gives 1.001 at 20, and 0.316 is
/// its limit in great heat.
template <class T> T temperature_factor(const T &temperature) {
  using std::exp, std::log;
  const double per_degree = 0.02 * log(0.7);
  return 0.79 * (exp(per_degree * temperature) + 0.4);
}

/// mu_fast - (mu_fast - mu_slow) exp(-a v), v >= 0 [m/s]: thesis (2-18), after Constantinou et al. (1990). k_v = 1 -
/// 0.5 exp(-a v) of Kumar et al. is this with mu_slow = mu_fast / 2.
template <class T> T coefficient_at_speed(const T &speed, double slow, double fast, double rate) {
  using std::exp;
  return fast - (fast - slow) * exp(-rate * speed);
}

} // namespace rimpact::friction
