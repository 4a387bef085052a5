#include "fe_contact/laws/master_surface.h"

#include <cmath>
#include <Eigen/LU>
#include <utility>

namespace rimpact::fe {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Distance to a round surface, `radial` being the vector from its centre or axis and `across` the projector
/// on the directions it is round in.
Distance round(const Vector3d &radial, const Matrix3d &across, double radius, Side side) {
  const double r = radial.norm(), sign = side == Side::outside ? 1.0 : -1.0;
  // On the centre itself every direction is as near as any other.
  const Vector3d outward =
      r > 0 ? Vector3d(radial / r) : Vector3d(across.col(across.col(0).norm() > 0.5 ? 0 : 1).normalized());
  const Matrix3d bend = r > 0 ? Matrix3d((across - outward * outward.transpose()) / r) : Matrix3d::Zero();
  return {sign * (r - radius), sign * outward, sign * bend};
}

/// Nearest point of F = 0 to x by Newton on (y - x + l grad F, F); starts straight below or above.
Vector3d nearest_point(const scene::SlidingSurface &surface, const Vector3d &x) {
  Vector3d y = x;
  const double r = x.head<2>().norm(), most = 0.999 * surface.limit_radius();
  if (r > most) y.head<2>() *= most / r;
  y.z() = surface.at(y.x(), y.y()).z;
  double l = (x - y).dot(surface.gradient(y)) / surface.gradient(y).squaredNorm();
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Vector3d gradient = surface.gradient(y);
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
    A.topLeftCorner<3, 3>() = Matrix3d::Identity() + l * surface.hessian(y);
    A.topRightCorner<3, 1>() = gradient;
    A.bottomLeftCorner<1, 3>() = gradient.transpose();
    Eigen::Vector4d b;
    b << y - x + l * gradient, surface.F(y);
    const Eigen::Vector4d change = A.partialPivLu().solve(b);
    y -= change.head<3>();
    l -= change[3];
    if (change.head<3>().norm() < 1e-14) break;
  }
  return y;
}

} // namespace

MasterSurface plane(const Vector3d &point, const Vector3d &normal) {
  const Vector3d n = normal.normalized();
  return {[=](const Vector3d &x) { return Distance{n.dot(x - point), n, Matrix3d::Zero()}; }, {}};
}

MasterSurface sphere(const Vector3d &centre, double radius, Side side) {
  return {[=](const Vector3d &x) { return round(x - centre, Matrix3d::Identity(), radius, side); }, {}};
}

MasterSurface cylinder(const Vector3d &point, const Vector3d &axis, double radius, Side side) {
  const Vector3d e = axis.normalized();
  const Matrix3d across = Matrix3d::Identity() - e * e.transpose();
  return {[=](const Vector3d &x) { return round(across * (x - point), across, radius, side); }, {}};
}

MasterSurface dish(std::shared_ptr<const scene::SlidingSurface> surface, double planar_radius) {
  const auto distance = [surface = std::move(surface)](const Vector3d &x) {
    const Vector3d y = nearest_point(*surface, x), gradient = surface->gradient(y);
    const Vector3d n = -gradient.normalized(); // F < 0 above the dish
    const double gap = n.dot(x - y);
    const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
    const Matrix3d shape = -P * surface->hessian(y) * P / gradient.norm(); // dn/dy on the surface
    return Distance{gap, n, shape * (Matrix3d::Identity() + gap * shape).inverse()};
  };
  return {distance, [=](const Vector3d &x) { return x.head<2>().norm() <= planar_radius; }};
}

} // namespace rimpact::fe
