#include "reduced_models/bearings/riding_height.h"

#include "reduced_models/bearings/pad_on_dish.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

namespace rimpact::reduced {

namespace {
// The profile of the default ellipse has its singularity at 1.34 half-ranges: coefficients fall as 2.2^-n.
constexpr int n_nodes = 44;

double node(int i, int n) {
  return std::cos(std::numbers::pi * (i + 0.5) / n);
}

/// Chebyshev coefficients from values at the n nodes.
std::vector<double> chebyshev(const std::vector<double> &samples) {
  const auto n = static_cast<int>(samples.size());
  std::vector<double> c(n, 0.0);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) c[j] += samples[i] * std::cos(std::numbers::pi * j * (i + 0.5) / n);
    c[j] *= (j == 0 ? 1.0 : 2.0) / n;
  }
  return c;
}

/// Clenshaw's recurrence.
double series(const std::vector<double> &c, double x) {
  double b1 = 0, b2 = 0;
  for (std::size_t j = c.size() - 1; j >= 1; --j) {
    const double b = 2 * x * b1 - b2 + c[j];
    b2 = b1, b1 = b;
  }
  return c[0] + x * b1 - b2;
}
} // namespace

template <class Function> RadialInterpolant::RadialInterpolant(const Function &of_radius, double largest_radius) {
  half_ = largest_radius * largest_radius / 2;
  std::vector<double> samples(n_nodes);
  for (int i = 0; i < n_nodes; ++i) samples[i] = of_radius(std::sqrt(half_ * (1 + node(i, n_nodes))));
  fit(samples);
}

void RadialInterpolant::fit(const std::vector<double> &samples) {
  const std::vector<double> whole = chebyshev(samples);
  std::vector<double> values(degree + 1);
  for (int i = 0; i < n_pieces; ++i) {
    for (int k = 0; k <= degree; ++k) values[k] = series(whole, (2 * i + 1 + node(k, degree + 1)) / n_pieces - 1);
    const std::vector<double> own = chebyshev(values);
    Piece before{}, now{}; // T_{j-1} and T_j in powers of t
    now[0] = 1;
    for (int j = 0; j <= degree; ++j) {
      for (int k = 0; k <= degree; ++k) pieces_[i][k] += own[j] * now[k];
      Piece next{};
      for (int k = 0; k <= degree; ++k) next[k] = (k > 0 ? (j == 0 ? 1 : 2) * now[k - 1] : 0.0) - before[k];
      before = now, now = next;
    }
  }
}

RadialInterpolant::Values RadialInterpolant::at(double s) const {
  const double place = s / half_ * (n_pieces / 2.0);
  const int i = place > 0 ? static_cast<int>(std::min(place, n_pieces - 0.5)) : 0;
  const Piece &a = pieces_[i];
  const double t = 2 * (place - i) - 1, scale = n_pieces / half_;
  double value = a[degree], d1 = 0, d2 = 0; // Horner, d2 half of the second derivative
  for (int k = degree - 1; k >= 0; --k) {
    d2 = d2 * t + d1;
    d1 = d1 * t + value;
    value = value * t + a[k];
  }
  return {value, d1 * scale, 2 * d2 * scale * scale};
}

namespace {

/// Fits and fleets build thousands of models of one bearing, and a lift costs as much as ten of their runs: the last
/// one is kept.
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
    : surface_(scene::make_surface(bearing.ridden_surface())) {
  // The dish ends at its planar radius; a pad centre beyond it has nothing to ride on.
  limit_ = std::min(bearing.ridden_surface().planar_radius, surface_->limit_radius() * (1 - 1e-9));
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
  if (!lift_) return surface_->at(x, y);
  scene::SurfacePoint p = surface_->at(x, y);
  const auto l = lift_->at(x * x + y * y);
  const Eigen::Vector2d u(x, y);
  p.z += l.value;
  p.gradient += 2 * l.d1 * u;
  p.hessian += 4 * l.d2 * u * u.transpose();
  p.hessian.diagonal().array() += 2 * l.d1;
  return p;
}

scene::Curvatures RidingHeight::curvatures(double radius) const {
  return plane_ ? scene::Curvatures{0, 0} : surface_->curvatures(radius);
}

} // namespace rimpact::reduced
