#include "calibration/export/contact.h"
#include "io/files/error.h"
#include <numbers>

namespace rimpact::calibration {

double LawContact::force(double d, double rate) const {
  if (!(d > 0)) return 0;
  return rim_.at({.d = d, .rate = rate, .speed = std::abs(rate), .deepest = deepest_}).force;
}

Bounce fly(RimContact &contact, double mass, double speed, double stiffness) {
  constexpr int steps_per_half_period = 4000, most_steps = 2'000'000;
  const double h = std::numbers::pi * std::sqrt(mass / stiffness) / steps_per_half_period;
  const auto acceleration = [&](double d, double rate) { return -contact.force(d, rate) / mass; };
  Bounce impact{.peak_force = 0, .penetration = 0, .rebound = 0, .duration = 0};
  double d = 0, v = speed;
  for (int step = 1; step <= most_steps; ++step) {
    const double a1 = acceleration(d, v), v2 = v + h / 2 * a1;
    const double a2 = acceleration(d + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = acceleration(d + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = acceleration(d + h * v3, v4);
    d += h / 6 * (v + 2 * v2 + 2 * v3 + v4), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    contact.accept(d);
    const double force = contact.force(d, v);
    impact.peak_force = std::max(impact.peak_force, force), impact.penetration = std::max(impact.penetration, d);
    if (v < 0 && (d <= 0 || (!contact.pulls() && force <= 0))) {
      impact.rebound = -v / speed, impact.duration = step * h;
      return impact;
    }
  }
  throw DataError("a mass that meets this law's rim does not come back");
}

std::vector<double> speeds_between(double from, double to, int n) {
  if (!(to > from * (1 + 1e-9))) return {from};
  std::vector<double> speeds;
  for (int i = 0; i < n; ++i) speeds.push_back(from * std::pow(to / from, double(i) / (n - 1)));
  return speeds;
}

} // namespace rimpact::calibration
