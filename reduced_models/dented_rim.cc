#include "reduced_models/dented_rim.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {
namespace {

constexpr double same_place = 1e-9; ///< along the wall [m]

/// From the dent to where a slider at u touches, along the wall, counter-clockwise [m].
double beside(const Dent &dent, const Eigen::Vector2d &u, const DentShape &shape) {
  const auto &n = dent.direction;
  return shape.wall * std::atan2(n.x() * u.y() - n.y() * u.x(), n.dot(u));
}

/// Dented at `tau` from the touch, `s` beside the dent's own place [m]; < 0: not at all.
double seen(const Dent &dent, double s, double tau, double flank) {
  return dent.deepest - (s * s + 2 * tau * s) / (2 * flank);
}

/// Half the touch's length along the wall.
double half_touch(double depth, double flank) { return std::sqrt(2 * flank * depth); }

/// Places over the half touch and their weights: Gauss's for an ellipse (Chebyshev, second kind).
struct Places {
  static constexpr int n = 9;
  std::array<double, n> at, weight;
  Places() {
    for (int i = 0; i < n; ++i) {
      const double angle = (i + 1) * std::numbers::pi / (n + 1);
      at[i] = std::cos(angle);
      weight[i] = 2.0 / (n + 1) * std::pow(std::sin(angle), 2);
    }
  }
};

} // namespace

DentShape dent_shape(const scene::Scene &scene) {
  const scene::Bearing &b = scene.bearing;
  return {b.surface.planar_radius + b.rim.ledge, b.slider.diameter / 2, scene.reduced.dent_spread};
}

double DentedRim::deepest_at(const Eigen::Vector2d &u, const DentShape &shape) const {
  double deepest = 0;
  for (const Dent &dent : dents_) deepest = std::max(deepest, seen(dent, beside(dent, u, shape), 0, shape.flank()));
  return deepest;
}

void DentedRim::press(const Eigen::Vector2d &u, double d, const DentShape &shape) {
  if (d <= 0) return;
  const double flank = shape.flank(), half = half_touch(std::max(d, deepest_at(u, shape)), flank);
  double before = 0, behind = 0; // dented at the ends of the touch: what is dented at both is so between them
  for (const Dent &dent : dents_) {
    const double s = beside(dent, u, shape);
    before = std::max(before, seen(dent, s, half, flank));
    behind = std::max(behind, seen(dent, s, -half, flank));
  }
  if (std::min(before, behind) >= d) return;
  const auto covered = [&](const Dent &dent) {
    const double s = std::abs(beside(dent, u, shape));
    return seen(dent, s, -half, flank) <= d && s < half;
  };
  dents_.erase(std::remove_if(dents_.begin(), dents_.end(), covered), dents_.end());
  dents_.push_back({u.normalized(), d});
}

RimPush DentedRim::push(const RimElement &rim, const Eigen::Vector2d &u, const RimMotion &motion, const DentShape &shape) const {
  static const Places places;
  const double flank = shape.flank();
  RimMotion at = motion;
  at.deepest = deepest_at(u, shape);
  const double half = half_touch(std::max(at.deepest, motion.d), flank);
  const auto aside = [&](const Dent &dent) {
    const double s = std::abs(beside(dent, u, shape));
    return s > same_place && seen(dent, s, -half, flank) > 0;
  };
  if (!(half > 0) || std::none_of(dents_.begin(), dents_.end(), aside)) {
    const double force = rim.trial(at);
    return {std::max(0.0, force), 0, force};
  }
  std::array<double, Places::n> deepest{};
  for (const Dent &dent : dents_) {
    const double s = beside(dent, u, shape);
    for (int i = 0; i < Places::n; ++i) deepest[i] = std::max(deepest[i], seen(dent, s, half * places.at[i], flank));
  }
  RimPush result;
  double nearest = -INFINITY;
  for (int i = 0; i < Places::n; ++i) {
    at.deepest = deepest[i];
    const double force = rim.trial(at);
    nearest = std::max(nearest, force);
    if (force <= 0) continue;
    result.inwards += places.weight[i] * force;
    result.along -= places.weight[i] * force * half * places.at[i] / shape.slider;
  }
  result.trial = nearest > 0 ? result.inwards : nearest;
  return result;
}

} // namespace rimpact::reduced
