#include "calibration/opensees.h"
#include "reduced_models/impact_law.h"
#include <cmath>
#include <numbers>

namespace rimpact::calibration {

Bilinear bilinear_of(const RimSprings &r) {
  const reduced::RimElement rim{.stiffness = r.k_i, .yield_force = r.yield_force, .hardening = r.hardening, .hardening_exponent = r.hardening_exponent};
  const auto force = [&](double d) { return reduced::elastoplastic_backbone(rim, d).force; };
  const double energy = r.mass * r.reference_speed * r.reference_speed / 2;
  constexpr double step = 5e-6; // [m]
  double d = 0, work = 0;
  for (; work < energy; d += step) work += step * force(d + step / 2);
  const double top = force(d), elastic = top / r.k_i;
  if (d - elastic < 0.01 * d) return {.yield_force = r.yield_force, .hardening = r.hardening}; // not yielded
  // twice the area under a corner at (F / k, F) and the top (d, top): d F + (d - F / k) top
  const double corner = (2 * work - d * top) / (d - elastic);
  return {.yield_force = corner, .hardening = (top - corner) / (r.k_i * d - corner)};
}

PolygonError polygon_error(int n, double L_c, double penetration) {
  PolygonError error{.gap = L_c * (1 / std::cos(std::numbers::pi / n) - 1), .force = 0};
  const double u = L_c + penetration;
  constexpr int n_directions = 181; // from a spring's direction to half-way to the next; the rest repeats
  for (int i = 0; i < n_directions; ++i) {
    const double direction = std::numbers::pi / n * i / (n_directions - 1);
    double x = 0, y = 0;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n - direction;
      const double pressed = std::max(0.0, u * std::cos(angle) - L_c);
      x += pressed * std::cos(angle), y += pressed * std::sin(angle);
    }
    error.force = std::max(error.force, std::hypot(x - penetration, y) / penetration);
  }
  return error;
}

} // namespace rimpact::calibration
