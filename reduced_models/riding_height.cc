#include "reduced_models/riding_height.h"

#include "reduced_models/pad_on_dish.h"
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

namespace rimpact::reduced {

namespace {
// The profile of the default ellipse has its singularity at 1.34 half-ranges: coefficients fall as 2.2^-n.
constexpr int n_nodes = 44;
} // namespace

template <class Function>
RadialInterpolant::RadialInterpolant(const Function &of_radius, double largest_radius) {
  half_ = largest_radius * largest_radius / 2;
  std::vector<double> samples(n_nodes);
  for (int i = 0; i < n_nodes; ++i)
    samples[i] = of_radius(std::sqrt(half_ * (1 + std::cos(std::numbers::pi * (i + 0.5) / n_nodes))));
  fit(samples);
}

void RadialInterpolant::fit(const std::vector<double> &samples) {
  coefficients_.assign(n_nodes, 0.0);
  for (int j = 0; j < n_nodes; ++j) {
    for (int i = 0; i < n_nodes; ++i)
      coefficients_[j] += samples[i] * std::cos(std::numbers::pi * j * (i + 0.5) / n_nodes);
    coefficients_[j] *= (j == 0 ? 1.0 : 2.0) / n_nodes;
  }
}

RadialInterpolant::Values RadialInterpolant::at(double s) const {
  // Clenshaw's recurrence and its derivatives by x in [-1, 1].
  const double x = s / half_ - 1;
  double b1 = 0, b2 = 0, p1 = 0, p2 = 0, q1 = 0, q2 = 0;
  for (int j = n_nodes - 1; j >= 1; --j) {
    const double q = 2 * x * q1 - q2 + 4 * p1, p = 2 * x * p1 - p2 + 2 * b1,
                 b = 2 * x * b1 - b2 + coefficients_[j];
    q2 = q1, q1 = q, p2 = p1, p1 = p, b2 = b1, b1 = b;
  }
  return {coefficients_[0] + x * b1 - b2, (b1 + x * p1 - p2) / half_,
          (2 * p1 + x * q1 - q2) / (half_ * half_)};
}

namespace {

/// Fits and fleets build thousands of models of one bearing, and a lift costs as much as ten of their runs: the last one is kept.
std::shared_ptr<const RadialInterpolant> lift_under(const scene::Bearing &bearing, const scene::SlidingSurface &surface,
                                                    double load, double limit) {
  static std::mutex guard;
  static scene::Bearing kept_bearing;
  static double kept_load = 0;
  static std::shared_ptr<const RadialInterpolant> kept;
  const std::scoped_lock lock(guard);
  if (kept && kept_load == load && kept_bearing == bearing) return kept;
  const PadOnDish pad(bearing, surface, load);
  const double at_rest = pad.lift(0);
  kept = std::make_shared<RadialInterpolant>([&](double r) { return pad.lift(r) - at_rest; }, limit);
  kept_bearing = bearing, kept_load = load;
  return kept;
}

} // namespace

RidingHeight::RidingHeight(const scene::Bearing &bearing, double pad_load)
    : surface_(scene::make_surface(bearing.surface)) {
  // The dish ends at its planar radius; a pad centre beyond it has nothing to ride on.
  limit_ = std::min(bearing.surface.planar_radius, surface_->limit_radius() * (1 - 1e-9));
  if (pad_load > 0) lift_ = lift_under(bearing, *surface_, pad_load, limit_);
}

RidingHeight RidingHeight::plane(const scene::Bearing &bearing, double radius) {
  RidingHeight height(bearing);
  height.plane_height_ = height.at(radius, 0).z;
  height.plane_ = true;
  height.limit_ = std::numeric_limits<double>::infinity();
  return height;
}

scene::SurfacePoint RidingHeight::at(double x, double y) const {
  if (plane_) return {plane_height_, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
  scene::SurfacePoint p = surface_->at(x, y);
  if (lift_) {
    const auto l = lift_->at(x * x + y * y);
    const Eigen::Vector2d u(x, y);
    p.z += l.value;
    p.gradient += 2 * l.d1 * u;
    p.hessian += 4 * l.d2 * u * u.transpose();
    p.hessian.diagonal().array() += 2 * l.d1;
  }
  return p;
}

scene::Curvatures RidingHeight::curvatures(double radius) const {
  return plane_ ? scene::Curvatures{0, 0} : surface_->curvatures(radius);
}

} // namespace rimpact::reduced
