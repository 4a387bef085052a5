/// Laws of the rim element: force of the rim on the slider over penetration d and its rate (thesis eq. 2-19
/// to 2-22). Pure values; one function and one catalogue line a law. SI units, force > 0 pushes the slider
/// inwards.
#pragma once
#include <string>
#include <vector>

namespace rimpact::reduced {

/// Force and its partial derivatives; `d_speed` is zero except for laws that count the planar speed.
struct ImpactForce {
  double force;         ///< [N]
  double d_penetration; ///< [N/m]
  double d_rate;        ///< [N s/m]
  double d_speed = 0;   ///< [N s/m]
};

/// One law. `at` is meant for d >= 0 and returns the force while the element is pressed.
struct ImpactLaw {
  std::string name, description;
  ImpactForce (*at)(double k, double c, double d, double rate, double speed);
  /// True: the element lets go when k d + c d' falls to zero and presses again when it rises through zero
  /// with d > 0 (the force is then max(0, k d + c d')). False: it lets go when the penetration ends.
  bool unilateral;
};
const std::vector<ImpactLaw> &impact_laws();
/// Throws InputError naming the known laws.
const ImpactLaw &impact_law(const std::string &name);

/// xi of (2-20): -ln e / sqrt(pi^2 + ln^2 e) [-], 0 < e <= 1.
double damping_ratio(double restitution);
/// c_i of (2-20) with m1 = supported mass and m2 -> infinity (rim fixed): 2 xi sqrt(k m) [N s/m].
double damping_coefficient(double stiffness, double restitution, double mass);

/// The element of one rim.
struct RimElement {
  double stiffness = 0; ///< k_i [N/m]; 0: no element
  double damping = 0;   ///< c_i [N s/m]
  const ImpactLaw *law = nullptr;
  ImpactForce at(double d, double rate, double speed) const {
    return law->at(stiffness, damping, d, rate, speed);
  }
  /// k d + c d' [N]: its sign decides whether a unilateral element presses.
  double trial(double d, double rate) const { return stiffness * d + damping * rate; }
};

} // namespace rimpact::reduced
