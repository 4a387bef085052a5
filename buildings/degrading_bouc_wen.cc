#include "buildings/degrading_bouc_wen.h"
#include <algorithm>
#include <cmath>

namespace rimpact::buildings {

namespace {
double power_of(double size, double exponent) {
  return exponent == 2 ? size * size : std::pow(size, exponent);
}
/// |z / g|.
double over_capacity(const DegradingBoucWen &law, double z) {
  return law.capacity ? std::abs(z) / law.capacity->value : std::abs(z);
}
} // namespace

DegradingBoucWen::Point DegradingBoucWen::rates(const Point &p, double d_rate) const {
  const double x = d_rate / yield_deformation, nu = 1 + strength_loss * p.e, eta = 1 + stiffness_loss * p.e;
  const double s = (p.z * x < 0 ? -beta : beta) + 1 - beta,
               flow = nu * power_of(over_capacity(*this, p.z), exponent) * s,
               degraded = capacity ? std::min(flow, 1.0) : flow;
  return {d_rate, x * (1 - degraded) / eta, degraded * p.z * x};
}

double DegradingBoucWen::force(const Point &p) const {
  return post_yield * stiffness() * p.d + (1 - post_yield) * yield_force * p.z;
}

namespace {
/// Imbalance h of a stage as a function of z alone, x = (d - d0) / d_y, with its derivatives. The stage's two equations
/// give e = e0 + z (x - eta (z - z0)), which eta = 1 + d_eta e makes explicit.
struct Imbalance {
  double e, h, by_z, by_x;
  Imbalance(const DegradingBoucWen &law, const DegradingBoucWen::Point &base, double z, double x) {
    const double gain = law.stiffness_loss, size = over_capacity(law, z), below = 1 + gain * z * (z - base.z);
    e = std::max((base.e + z * (x - z + base.z)) / below, 0.0);
    const double e_z = e > 0 ? (x - 2 * z + base.z - e * gain * (2 * z - base.z)) / below : 0.0,
                 e_x = e > 0 ? z / below : 0.0;
    const double nu = 1 + law.strength_loss * e, eta = 1 + gain * e, w = power_of(size, law.exponent),
                 w_z = size > 0 ? law.exponent * w / z : 0.0, s = (z * x < 0 ? -law.beta : law.beta) + 1 - law.beta;
    if (law.capacity && nu * w * s >= 1) { // a moving bound is passed: no flow, but down to the bound
      h = z - base.z, by_z = 1, by_x = 0;
    } else {
      const double share = (1 - nu * w * s) / eta;
      const double share_e = -(law.strength_loss * w * s + share * gain) / eta;
      h = z - base.z - x * share;
      by_z = 1 - x * (share_e * e_z - nu * w_z * s / eta), by_x = -share - x * share_e * e_x;
    }
    if (law.capacity) come_down(law, nu, z);
  }
  void come_down(const DegradingBoucWen &law, double nu, double z) {
    const double beyond = std::abs(z) - law.capacity->value * std::pow(nu, -1 / law.exponent),
                 pull = law.capacity->dt / DegradingBoucWen::relaxation;
    if (beyond > 0) h += std::copysign(pull * beyond, z), by_z += pull;
  }
};
} // namespace

DegradingBoucWen::Step DegradingBoucWen::implicit_step(const Point &base, double d, const Point &guess) const {
  constexpr double small = 1e-10; // of a correction after which Newton leaves an error of rounding
  const double x = (d - base.d) / yield_deformation, way = x < 0 ? -1 : 1;
  // In the direction of x the imbalance is below zero at `low` and not below it at `high`.
  double low = std::min(way * base.z, 0.0), high = std::max(way * base.z, capacity ? capacity->value : 1.0);
  double z = way * std::clamp(way * guess.z, low, high);
  Imbalance at(*this, base, z, x);
  for (int i = 0; i < 100; ++i) {
    (way * at.h < 0 ? low : high) = way * z;
    double next = z - at.h / at.by_z;
    const bool within = way * next >= low && way * next <= high;
    if (!within) next = way * (low + high) / 2;
    const double change = std::abs(next - z);
    z = next, at = Imbalance(*this, base, z, x);
    if (change <= (within ? small : 1e-15)) break;
  }
  const Point p{d, z, at.e};
  return {p, force(p), stiffness() * (post_yield - (1 - post_yield) * at.by_x / at.by_z)};
}

double DegradingBoucWen::stored(const Point &p) const {
  const double eta = 1 + stiffness_loss * p.e;
  return 0.5 *
         (post_yield * stiffness() * p.d * p.d + (1 - post_yield) * yield_force * yield_deformation * eta * p.z * p.z);
}

double DegradingBoucWen::loss(const Point &p, const Point &r) const {
  return (1 - post_yield) * yield_force * yield_deformation * r.e * (1 - 0.5 * stiffness_loss * p.z * p.z);
}

double DegradingBoucWen::strength_left(const Point &p) const {
  return std::pow(1 + strength_loss * p.e, -1 / exponent);
}
double DegradingBoucWen::stiffness_left(const Point &p) const {
  return 1 / (1 + stiffness_loss * p.e);
}

} // namespace rimpact::buildings
