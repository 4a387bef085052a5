#include "reduced_models/bearings/pad_on_dish.h"

#include "scene/stack_terms.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Dense>
#include <numbers>

namespace rimpact::reduced {
namespace {

constexpr std::array<double, 5> gauss_points{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                             0.9061798459386640};
constexpr std::array<double, 5> gauss_weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                              0.4786286704993665, 0.2369268850561891};
constexpr int n_angles = 12; // over half of the face, the other half being its image

} // namespace

PadOnDish::PadOnDish(const scene::Bearing &bearing, const scene::SlidingSurface &surface, double load)
    : bearing_(bearing), surface_(surface), load_(load),
      edge_(std::min(bearing.surface.planar_radius, surface.limit_radius() * (1 - 1e-9))) {
  const double nu = bearing.ertalyte.nu;
  stiffness_ = bearing.ertalyte.E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / bearing.pad.thickness;
}

PadOnDish::Profile PadOnDish::profile(double r) const {
  const double inside = std::min(r, edge_);
  const auto p = surface_.at(inside, 0);
  return {p.z + (r - inside) * p.gradient[0], p.gradient[0]};
}

PadOnDish::Potential PadOnDish::potential(double r, const Eigen::Vector2d &at) const {
  const auto &pad = bearing_.pad;
  const double middle = (pad.outer_radius + pad.inner_radius) / 2, half = (pad.outer_radius - pad.inner_radius) / 2;
  const double c = std::cos(at[1]), s = std::sin(at[1]);
  Potential result;
  result.value = load_ * at[0], result.slope[0] = load_;
  for (std::size_t i = 0; i < gauss_points.size(); ++i) {
    const double rho = middle + half * gauss_points[i], depth = rho * rho / (2 * pad.shape_radius);
    const double weight = 2 * gauss_weights[i] * half * rho * std::numbers::pi / n_angles * stiffness_;
    for (int j = 0; j < n_angles; ++j) {
      const double angle = std::numbers::pi * (j + 0.5) / n_angles, along = rho * std::cos(angle);
      const double x = r + c * along - s * depth, rise = s * along + c * depth;
      const double from_axis = std::hypot(x, rho * std::sin(angle));
      const Profile dish = profile(from_axis);
      const double cosine = 1 / std::sqrt(1 + dish.slope * dish.slope);
      const double overlap = (dish.z - at[0] - rise) * cosine;
      if (overlap <= 0) continue;
      const Eigen::Vector2d change(-cosine, (-dish.slope * x / from_axis * rise - c * along + s * depth) * cosine);
      result.value += weight * overlap * overlap / 2;
      result.slope += weight * overlap * change;
      result.hessian += weight * change * change.transpose();
    }
  }
  return result;
}

double PadOnDish::lift(double r) const {
  const Profile here = profile(r);
  Eigen::Vector2d at(here.z - load_ / (stiffness_ * bearing_.pad_area()), std::atan(here.slope));
  Potential now = potential(r, at);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Matrix2d H = now.hessian + 1e-9 * load_ * Eigen::Matrix2d::Identity();
    Eigen::Vector2d change = -H.ldlt().solve(now.slope);
    Potential next = potential(r, at + change);
    for (int cut = 0; cut < 20 && next.value > now.value; ++cut) next = potential(r, at + (change /= 2));
    if (next.value > now.value) break; // at the least value, to rounding
    at += change, now = next;
    if (std::abs(change[0]) < 1e-12) break;
  }
  return now.value / load_ - here.z;
}

double socket_arm(const scene::Bearing &bearing) {
  const double edge = std::acos(std::min(1.0, bearing.slider.bottom / bearing.foot.cap_radius)), c = std::cos(edge);
  const int n = 60;
  double moment = 0; // of the pressure cos(theta) times the distance from the axis, over 2 pi R^3
  for (int i = 0; i < n; ++i) {
    const double theta = edge * (i + 0.5) / n;
    moment += edge / n * std::cos(theta) * std::sin(theta) * 2 / std::numbers::pi * std::comp_ellint_2(std::sin(theta));
  }
  return bearing.foot.cap_radius * moment / ((1 - c * c * c) / 3);
}

void add_stack_terms(scene::Scene &scene) {
  if (!scene.bearing.has_pad()) return;
  auto &r = scene.reduced;
  r.finite_pad = r.socket_friction = true;
  const double slip = scene::pad_elastic_slip(scene.bearing, scene.load.vertical, r.mu_fast);
  if (r.friction == scene::Friction::park_wen || !(slip > 0)) return;
  r.friction = scene::Friction::park_wen, r.elastic_slip = slip;
}

} // namespace rimpact::reduced
