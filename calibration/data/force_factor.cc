#include "calibration/data/force_factor.h"
#include <cmath>

namespace rimpact::calibration {

std::optional<ForceFactor> force_factor(const ImpactWindow &w, double mass) {
  const double u_0 = w.start.u.head<2>().dot(w.direction), v_0 = w.start.v.head<2>().dot(w.direction);
  double speed = 0, by_force = 0, square = 0, product = 0, by_speed = 0; // speed and travel that the force takes
  for (std::size_t i = 0; i < w.times.size() && w.times[i] <= w.impact.release_time; ++i) {
    if (i > 0) { // the force is straight between samples
      const double dt = w.times[i] - w.times[i - 1], a = w.force[i - 1] / mass, b = w.force[i] / mass;
      by_force += dt * speed + dt * dt * (2 * a + b) / 6;
      speed += dt * (a + b) / 2;
    }
    const double t = w.times[i] - w.start.t;
    square += by_force * by_force;
    product += by_force * (u_0 + v_0 * t - w.displacement[i]);
    by_speed += by_force * t;
  }
  if (!(square > 0)) return std::nullopt;
  const double unsure = w.measurement ? std::sqrt(w.measurement->start_factor.row(1).squaredNorm()) : 0;
  return ForceFactor{product / square, std::abs(by_speed / square) * unsure};
}

} // namespace rimpact::calibration
