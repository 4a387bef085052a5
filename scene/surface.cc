#include "scene/surface.h"
#include "scene/surface_of_revolution.h"
#include "scene/surface_table.h"
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace rimpact::scene {
namespace {

/// Ellipse of revolution (2-2): (x^2 + y^2)/a^2 + (z - b)^2/b^2 = 1; a sphere when a = b. R0 = a^2/b (2-24).
class Ellipsoid final : public SlidingSurface {
public:
  Ellipsoid(double a, double b) : a_(a), b_(b), inv_a2_(1 / (a * a)), inv_b2_(1 / (b * b)), inv_R0_(b / (a * a)) {}

  double F(const Eigen::Vector3d &x) const override {
    const double h = x.z() - b_;
    return (x.x() * x.x() + x.y() * x.y()) * inv_a2_ + h * h * inv_b2_ - 1;
  }
  Eigen::Vector3d gradient(const Eigen::Vector3d &x) const override {
    return {2 * x.x() * inv_a2_, 2 * x.y() * inv_a2_, 2 * (x.z() - b_) * inv_b2_};
  }
  Eigen::Matrix3d hessian(const Eigen::Vector3d &) const override {
    return Eigen::Vector3d(2 * inv_a2_, 2 * inv_a2_, 2 * inv_b2_).asDiagonal();
  }
  SurfacePoint at(double x, double y) const override {
    const double s = depth(x * x + y * y), inv_s = 1 / s;
    const double slope = inv_R0_ * inv_s;                  // (dz/dr) / r
    const double bend = slope * inv_a2_ * (inv_s * inv_s); // (d slope/dr) / r
    SurfacePoint p;
    p.z = b_ * (1 - s);
    p.gradient = {slope * x, slope * y};
    p.hessian(0, 0) = slope + bend * x * x;
    p.hessian(1, 1) = slope + bend * y * y;
    p.hessian(0, 1) = p.hessian(1, 0) = bend * x * y;
    return p;
  }
  Curvatures curvatures(double r) const override {
    const double s = depth(r * r);
    const double slope = inv_R0_ / s * r, stretch = std::sqrt(1 + slope * slope);
    return {inv_R0_ / (s * s * s) / (stretch * stretch * stretch), inv_R0_ / s / stretch};
  }
  double limit_radius() const override { return a_; }

private:
  /// sqrt(1 - r^2/a^2), the relative height below the ellipse's centre.
  double depth(double r2) const {
    const double s2 = 1 - r2 * inv_a2_;
    if (!(s2 > 1e-15)) // with fused multiply-add the edge itself rounds to 1e-17, not to zero
      throw std::domain_error(fmt::format(
          "planar radius {:.6g} m lies outside the sliding surface, which ends at {:.6g} m", std::sqrt(r2), a_));
    return std::sqrt(s2);
  }
  double a_, b_, inv_a2_, inv_b2_, inv_R0_;
};

} // namespace

std::unique_ptr<SlidingSurface> make_surface(const SurfaceSpec &s) {
  switch (s.kind) {
  case SurfaceKind::ellipse:
    return std::make_unique<Ellipsoid>(s.a, s.a * s.a / s.R0);
  case SurfaceKind::sphere:
    return std::make_unique<Ellipsoid>(s.R0, s.R0);
  case SurfaceKind::cone:
    return make_cone(s);
  case SurfaceKind::polynomial:
    return make_polynomial(s);
  case SurfaceKind::table:
    return make_table(s);
  }
  return nullptr;
}

} // namespace rimpact::scene
