#include "reduced_models/structures/bouc_wen.h"
#include "reduced_models/bearings/wen_stage.h"
#include <cmath>
#include <Eigen/LU>
#include <limits>

namespace rimpact::reduced {

using Eigen::Matrix2d, Eigen::Vector2d;

namespace {

/// |z|^(n-2), 0 at z = 0: it only ever multiplies terms of second order in z.
double sharpness(double size, double exponent) {
  if (exponent == 2) return 1;
  return size > 0 ? std::pow(size, exponent - 2) : 0.0;
}

} // namespace

Vector2d BoucWen::rate(const Vector2d &z, const Vector2d &v) const {
  const double w = z.dot(v);
  return (v - sharpness(z.norm(), exponent) * (beta * std::abs(w) + (1 - beta) * w) * z) / yield;
}

BoucWen::Rate BoucWen::rate_and_slopes(const Vector2d &z, const Vector2d &v) const {
  const double w = z.dot(v), size = z.norm(), p = sharpness(size, exponent);
  const double g = beta * std::abs(w) + (1 - beta) * w, slope = (w < 0 ? -beta : beta) + 1 - beta;
  const double curving = size > 0 ? (exponent - 2) * p * g / (size * size) : 0.0;
  Rate r;
  r.rate = (v - p * g * z) / yield;
  r.d_rate = (Matrix2d::Identity() - p * slope * z * z.transpose()) / yield;
  r.d_z = -(p * g * Matrix2d::Identity() + curving * z * z.transpose() + p * slope * z * v.transpose()) / yield;
  return r;
}

BoucWen::Step BoucWen::implicit_step(const Vector2d &z0, const Vector2d &v, double h) const {
  if (exponent == 2) {
    const auto stage = wen_stage<2>(z0, v, h / yield, 1, 1 - 2 * beta);
    return {stage.z, stage.d_velocity};
  }
  Vector2d z = z0;
  for (int i = 0; i < 50; ++i) {
    const Rate r = rate_and_slopes(z, v);
    const Vector2d change = (Matrix2d::Identity() - h * r.d_z).partialPivLu().solve(z0 + h * r.rate - z).eval();
    z += change;
    if (z.norm() > 2) z *= 2 / z.norm(); // a long step's first guess may lie far outside
    if (change.norm() < 1e-14) break;
  }
  const Rate r = rate_and_slopes(z, v);
  return {z, (Matrix2d::Identity() - h * r.d_z).partialPivLu().solve(h * r.d_rate)};
}

double BoucWen::collapse_drift() const {
  return post_yield < 0 ? (1 - post_yield) * yield / -post_yield : std::numeric_limits<double>::infinity();
}

} // namespace rimpact::reduced
