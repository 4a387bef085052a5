/// Closed form of a slow loop of a double concave bearing with two contact points a set (derived in
/// docs/theory/double-concave.md): the independent oracle of the rigid-body models. Planar, weightless slider, rigid
/// contacts.
#pragma once
#include "scene/isolator.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reduced::testing {

/// mu_e: tangent of the angle between the slider's axis and the force through it while both dishes slide.
/// Moments about the spheres' centres: each dish gives mu R (N1 + N2); with T across and A along the axis,
/// T R_eff = 2 mu R S and A = S cos(phi) (1 + mu^2) - mu T, S = N1 + N2.
/// Plates of unequal radius and friction share T and A, each with its own S: T R_eff = sum mu_i R_i S_i,
/// A = S_i cos(phi_i) (1 + mu_i^2) - mu_i T.
inline double effective_friction(const scene::Isolator &b, double mu, double top_mu) {
  const auto arm = [](double m, double R, double phi) { return m * R / (std::cos(phi) * (1 + m * m)); };
  const double bottom = arm(mu, b.radius, b.edge_angle()), top = arm(top_mu, b.upper_radius(), b.top_edge_angle());
  return (bottom + top) / (b.effective_radius() - bottom * mu - top * top_mu);
}
inline double effective_friction(const scene::Isolator &b, double mu) {
  return effective_friction(b, mu, mu);
}

/// One slow LIR-DCFP (or DCFP: no interface) followed along a path u of the plate; the rims are rigid.
struct QuasiStaticLoop {
  scene::Isolator bearing;
  double mu;
  bool impact_resilient = true;
  double u = 0, theta = 0, slip = 0, sense = 1; ///< slip s > 0: the top slider ahead in +x

  double low(double at) const {
    return std::tan(at + sense * std::atan(effective_friction(bearing, mu, bearing.top_mu_fast.value_or(mu))));
  }
  double interface_force(double at) const { return std::tan(at + sense * std::atan(bearing.mu_interface)); }

  /// Moves to `next` and returns F/W there (force that the drive needs, > 0 along +x). u = R_eff sin(theta) +
  /// s cos(theta).
  double move(double next) {
    if (next == u) return low(theta);
    sense = next > u ? 1 : -1;
    u = next;
    const double R_eff = bearing.effective_radius(), limit = bearing.rim_tilt();
    // u = a sin(theta + delta), a = hypot(R_eff, s), tan(delta) = s / R_eff
    theta = std::asin(u / std::hypot(R_eff, slip)) - std::atan2(slip, R_eff);
    if (sense * theta <= limit) return low(theta);
    theta = sense * limit; // both rims hold the slider: the interface slides
    slip = (u - R_eff * std::sin(theta)) / std::cos(theta);
    return interface_force(theta);
  }
};

} // namespace rimpact::reduced::testing
