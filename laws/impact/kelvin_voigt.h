/// Spring and dashpot (thesis eq. 2-19 to 2-22): signed, no-tension, printed. The dashpot is scaled by the supported
/// mass, so that the pair k_i, e holds for that mass only.
#pragma once

namespace rimpact::laws {

/// The published pair; other laws read k_i, and hunt-crossley e.
struct PairNumbers {
  double k_i = 4.5e8;        ///< impact stiffness [N/m]; 0 switches the impact element off
  double restitution = 0.65; ///< e in (0, 1]
  bool operator==(const PairNumbers &) const = default;
};

/// xi of (2-20): -ln e / sqrt(pi^2 + ln^2 e) [-]. Throws InputError for e outside (0, 1].
double damping_ratio(double restitution);
/// c_i of (2-20) with m1 = supported mass and m2 -> infinity (rim fixed): 2 xi sqrt(k m) [N s/m].
double damping_coefficient(double stiffness, double restitution, double mass);
/// F_peak / (v sqrt(k m)) of a free mass on a linear Kelvin-Voigt rim of restitution e (law `signed`):
/// exp(-xi t*), 0.853 at e = 0.65. e in (0, 1].
double kelvin_voigt_peak(double restitution);

} // namespace rimpact::laws
