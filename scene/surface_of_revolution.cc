#include "scene/surface_of_revolution.h"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace rimpact::scene {

MeridianPoint SurfaceOfRevolution::inside(double r) const {
  if (!(r < limit_radius()))
    throw std::domain_error(fmt::format(
        "planar radius {:.6g} m lies outside the sliding surface, which ends at {:.6g} m", r, limit_radius()));
  return meridian(r);
}

double SurfaceOfRevolution::F(const Eigen::Vector3d &x) const {
  return inside(std::hypot(x.x(), x.y())).height - x.z();
}

Eigen::Vector3d SurfaceOfRevolution::gradient(const Eigen::Vector3d &x) const {
  const Eigen::Vector2d g = at(x.x(), x.y()).gradient;
  return {g.x(), g.y(), -1};
}

Eigen::Matrix3d SurfaceOfRevolution::hessian(const Eigen::Vector3d &x) const {
  Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
  h.topLeftCorner<2, 2>() = at(x.x(), x.y()).hessian;
  return h;
}

SurfacePoint SurfaceOfRevolution::at(double x, double y) const {
  const double r = std::hypot(x, y);
  const MeridianPoint m = inside(r);
  const Eigen::Vector2d u(x, y);
  SurfacePoint p{m.height, m.slope_over_radius * u, Eigen::Matrix2d::Zero()};
  p.hessian.diagonal().setConstant(m.slope_over_radius);
  if (r > 0) p.hessian += (m.second - m.slope_over_radius) / (r * r) * u * u.transpose();
  return p;
}

Curvatures SurfaceOfRevolution::curvatures(double r) const {
  const MeridianPoint m = inside(r);
  const double slope = m.slope_over_radius * r, stretch = std::sqrt(1 + slope * slope);
  return {m.second / (stretch * stretch * stretch), m.slope_over_radius / stretch};
}

namespace {

class Cone final : public SurfaceOfRevolution {
public:
  Cone(double slope, double R0) : slope_(slope), c_(slope * R0) {}
  MeridianPoint meridian(double r) const override {
    const double root = std::hypot(r, c_);
    return {slope_ * r * r / (root + c_), slope_ / root, slope_ * c_ * c_ / (root * root * root)};
  }
  double limit_radius() const override { return std::numeric_limits<double>::infinity(); }

private:
  double slope_, c_;
};

class Polynomial final : public SurfaceOfRevolution {
public:
  explicit Polynomial(const std::array<double, 5> &c) : c_(c) {}
  MeridianPoint meridian(double r) const override {
    double h = 0, slope = 0, second = 0; // of h / r^2, h' / r, h''
    for (int k = 6; k >= 2; --k) {
      const double c = c_[static_cast<std::size_t>(k - 2)];
      h = h * r + c, slope = slope * r + k * c, second = second * r + k * (k - 1) * c;
    }
    return {h * r * r, slope, second};
  }
  double limit_radius() const override { return std::numeric_limits<double>::infinity(); }

private:
  std::array<double, 5> c_;
};

} // namespace

std::unique_ptr<SlidingSurface> make_cone(const SurfaceSpec &spec) {
  return std::make_unique<Cone>(spec.slope, spec.R0);
}

std::unique_ptr<SlidingSurface> make_polynomial(const SurfaceSpec &spec) {
  return std::make_unique<Polynomial>(spec.coefficients);
}

} // namespace rimpact::scene
