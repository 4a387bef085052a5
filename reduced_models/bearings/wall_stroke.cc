#include "reduced_models/bearings/wall_stroke.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reduced {

using Eigen::Vector2d;

namespace {

double cross(const Vector2d &a, const Vector2d &b) {
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace

double along_wall(const Vector2d &direction, const Vector2d &u, double wall) {
  return wall * std::atan2(cross(direction, u), direction.dot(u));
}

WallPoint wall_point(const Vector2d &u, const Vector2d &v, const Vector2d &a, double capacity, double wall) {
  const double r = u.norm();
  const Vector2d n = u / r;
  const double rate = n.dot(v), turning = cross(n, v) / r; // r', phi'
  return {n,
          r - capacity,
          rate,
          n.dot(a) + r * turning * turning,
          wall * turning,
          wall * (cross(n, a) - 2 * rate * turning) / r};
}

WallStroke::Quartic::Quartic(double p0, double m0, double k0, double p1, double m1) {
  const double rest = p1 - p0 - m0 - k0 / 2, rest_slope = m1 - m0 - k0;
  c = {p0, m0, k0 / 2, 4 * rest - rest_slope, rest_slope - 3 * rest};
}

double WallStroke::Quartic::bulge() const { // largest |x^2 - x|, |x^3 - x|, |x^4 - x| in [0, 1]
  return 0.25 * std::abs(c[2]) + 0.385 * std::abs(c[3]) + 0.473 * std::abs(c[4]);
}

WallStroke::WallStroke(const WallPoint &from, const WallPoint &to, double h, double wall)
    : direction_(from.direction), end_depth_(to.d), end_place_(along_wall(from.direction, to.direction, wall)) {
  depth_ = Quartic(from.d, h * from.rate, h * h * from.acceleration, to.d, h * to.rate);
  place_ = Quartic(0, h * from.along_rate, h * h * from.along_acceleration, end_place_, h * to.along_rate);
  deepest_ = std::max(from.d, to.d) + depth_.bulge();
  low_ = std::min(0.0, end_place_) - place_.bulge(), high_ = std::max(0.0, end_place_) + place_.bulge();
}

double WallStroke::seen(double from_start, double tau, double flank, double above) const {
  const double at = from_start + tau; // the looked-at spot of the wall, from the first place
  const double aside = std::max({0.0, low_ - at, at - high_});
  if (deepest_ + (tau * tau - aside * aside) / (2 * flank) <= above) return above;
  const auto value = [&](double depth, double place) {
    const double s = from_start - place;
    return depth - (s * s + 2 * tau * s) / (2 * flank);
  };
  const auto slope = [&](double x) { return depth_.slope(x) + (at - place_.at(x)) * place_.slope(x) / flank; };
  double largest = std::max({above, value(depth_.c[0], 0), value(end_depth_, end_place_)});
  double low = 0, high = 1, f_low = slope(0), f_high = slope(1);
  if (!(f_low > 0 && f_high < 0)) return largest;
  double x = f_low / (f_low - f_high);
  for (int i = 0; i < 50; ++i) { // Newton, kept between the ends; an error of 1e-8 is one of 1e-16 in the largest value
    const double f = slope(x);
    (f > 0 ? low : high) = x;
    const double ds = place_.slope(x), bend = depth_.bend(x) + ((at - place_.at(x)) * place_.bend(x) - ds * ds) / flank;
    double next = bend < 0 ? x - f / bend : (low + high) / 2;
    if (!(next > low && next < high)) next = (low + high) / 2;
    const double moved = std::abs(next - x);
    x = next;
    if (moved < 1e-8) break;
  }
  return std::max(largest, value(depth_.at(x), place_.at(x)));
}

} // namespace rimpact::reduced
