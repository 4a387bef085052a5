#include "reduced_models/impact_law.h"
#include "scene/error.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

namespace {

// Kelvin-Voigt with the radial rate; pulls while separating (tension) until the penetration ends: returns e
// exactly.
ImpactForce signed_law(double k, double c, double d, double rate, double) {
  return {k * d + c * rate, k, c};
}

// Never pulls: max(0, k d + c d').
ImpactForce no_tension_law(double k, double c, double d, double rate, double) {
  const double force = k * d + c * rate;
  return force > 0 ? ImpactForce{force, k, c} : ImpactForce{0, 0, 0};
}

// (2-21) to the letter: c times the planar speed whatever its direction, so that the dashpot gives back in
// separation what it took in approach (rebound 1.000 for every e).
ImpactForce printed_law(double k, double c, double d, double, double speed) {
  return {k * d + c * speed, k, 0, c};
}

} // namespace

const std::vector<ImpactLaw> &impact_laws() {
  static const std::vector<ImpactLaw> laws = {
      {"signed", "k d + c d' with the radial rate until the penetration ends; returns e exactly", signed_law,
       false},
      {"no-tension", "max(0, k d + c d'): never pulls; rebound 0.675 for e = 0.65", no_tension_law, true},
      {"printed", "(2-21) as printed, k d + c |v|: rebound 1.000 for every e", printed_law, false},
  };
  return laws;
}

const ImpactLaw &impact_law(const std::string &name) {
  std::string known;
  for (const auto &law : impact_laws()) {
    if (law.name == name) return law;
    known += (known.empty() ? "" : ", ") + law.name;
  }
  throw InputError("reduced.impact_law \"" + name + "\" is unknown; known: " + known);
}

double damping_ratio(double restitution) {
  if (!(restitution > 0 && restitution <= 1))
    throw InputError("reduced.restitution " + std::to_string(restitution) + " is outside (0, 1]");
  const double ln = std::log(restitution);
  return -ln / std::hypot(std::numbers::pi, ln);
}

double damping_coefficient(double stiffness, double restitution, double mass) {
  return 2 * damping_ratio(restitution) * std::sqrt(stiffness * mass);
}

} // namespace rimpact::reduced
