#include "laws/friction/friction_law.h"
#include "io/files/error.h"
#include "laws/friction/factors.h"
#include <cmath>
#include <string>

namespace rimpact::friction {

void FrictionLaw::validate() const {
  const auto text = [](double v) { return std::to_string(v); };
  if (by_pressure() && !(area > 0))
    throw InputError("friction by pressure needs the area of the sliding face, which is " + text(area * 1e6) + " mm^2");
  if (!(face_share > 0 && faces > 0))
    throw InputError("friction of " + std::to_string(faces) + " faces with " + text(face_share) +
                     " of the way each: both must be above 0");
  if (table) return;
  if (!(mu_slow >= 0)) throw InputError("reduced.mu_slow " + text(mu_slow) + " is below 0");
  if (!(mu_fast >= mu_slow)) throw InputError("reduced.mu_slow " + text(mu_slow) + " exceeds mu_fast " + text(mu_fast));
  if (mu_slow != mu_fast && !(rate > 0))
    throw InputError("reduced.rate_s_per_m " + text(rate) + " must be above 0 when mu_slow differs from mu_fast");
}

namespace {

Coefficient by_speed_alone(const FrictionLaw &law, double speed) {
  if (law.mu_slow == law.mu_fast) return {law.mu_fast, 0.0};
  if (speed == 0) return {law.mu_slow, law.rate * (law.mu_fast - law.mu_slow)};
  const double transition = (law.mu_fast - law.mu_slow) * std::exp(-law.rate * speed);
  return {law.mu_fast - transition, law.rate * transition};
}

Coefficient scaled(Coefficient mu, double factor) {
  return {mu.value * factor, mu.d_speed * factor, mu.d_pressure * factor, mu.d_temperature * factor};
}

} // namespace

Coefficient FrictionLaw::at(const Sliding &s) const {
  const double speed = face_share * s.speed;
  Coefficient mu = table ? table->at(speed, s.pressure) : by_speed_alone(*this, speed);
  mu.d_speed *= face_share;
  if (scale != 1) mu = scaled(mu, scale);
  if (reference_pressure) {
    mu = scaled(mu, pressure_factor(s.pressure, *reference_pressure));
    mu.d_pressure = 0.02e-6 * std::log(0.7) * mu.value;
  }
  if (by_temperature) {
    const double d_factor = 0.79 * 0.02 * std::log(0.7) * std::exp(0.02 * std::log(0.7) * s.temperature);
    const double cold = mu.value;
    mu = scaled(mu, temperature_factor(s.temperature));
    mu.d_temperature = cold * d_factor;
  }
  return mu;
}

} // namespace rimpact::friction
