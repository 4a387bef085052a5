#include "reduced_models/rigid_body/contact.h"
#include <cmath>

namespace rimpact::reduced::rigid {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

Touch on_dish(const Contact &c, const Pose &body, const Pose &master) {
  const Vector3d at = body.at(c.point), arm = at - master.at(c.centre);
  const double length = arm.norm();
  return {at, arm / length, length - c.radius, 1 / length};
}

Touch on_plane(const Contact &c, const Pose &body, const Pose &master) {
  const Vector3d at = body.at(c.point), up = master.rotation.col(2);
  return {at, -up, -up.dot(at - master.at(c.centre)), 0};
}

/// The point of the circle (centre `c`, axes `e1`, `e2`, master frame) farthest from the z axis: Newton on
/// d(x^2 + y^2)/dpsi, from the direction in which the centre lies.
Vector3d farthest(const Vector3d &c, const Vector3d &e1, const Vector3d &e2) {
  double psi = std::atan2(c.head<2>().dot(e2.head<2>()), c.head<2>().dot(e1.head<2>()));
  for (int i = 0; i < 8; ++i) {
    const Vector3d arm = std::cos(psi) * e1 + std::sin(psi) * e2, d = std::cos(psi) * e2 - std::sin(psi) * e1;
    const Vector2d x = (c + arm).head<2>(), dx = d.head<2>();
    const double slope = x.dot(dx), bend = dx.squaredNorm() - x.dot(arm.head<2>());
    if (!(bend < 0)) break;
    const double step = -slope / bend;
    psi += step;
    if (std::abs(step) < 1e-14) break;
  }
  return c + std::cos(psi) * e1 + std::sin(psi) * e2;
}

Touch on_rim(const Contact &c, const Pose &body, const Pose &master) {
  const auto local = master.rotation.transpose();
  Vector3d at = body.at(c.point), x = local * (at - master.position) - c.centre;
  if (c.reach > 0) x = farthest(x, c.reach * (local * body.rotation.col(0)), c.reach * (local * body.rotation.col(1)));
  if (c.reach > 0) at = master.at(c.centre + x);
  const double r = x.head<2>().norm();
  if (r < c.radius) return {at, Vector3d::Zero(), r - c.radius, 0};
  const Vector3d outward = r > 0 ? Vector3d(x[0] / r, x[1] / r, 0) : Vector3d::UnitX();
  Touch touch{at, master.rotation * outward, r - c.radius, r > 0 ? 1 / r : 0};
  touch.passed = touch.penetration > 0 && c.upward * x[2] > c.wall_height;
  return touch;
}

Touch on_stop(const Contact &c, const Pose &body, const Pose &master) {
  const Vector3d x = master.rotation.transpose() * (body.at(c.point) - master.position) - c.centre;
  const double s = x.head<2>().norm();
  const Vector3d outward = master.rotation * (s > 0 ? Vector3d(x[0] / s, x[1] / s, 0) : Vector3d::UnitX());
  Touch touch{body.at(c.point) + c.reach * outward, outward, s - c.radius, s > 0 ? 1 / s : 0};
  touch.passed = touch.penetration > 0 && x[2] > c.wall_height;
  return touch;
}

} // namespace

Touch locate(const Contact &contact, const Pose &body, const Pose &master) {
  switch (contact.surface) {
  case Surface::dish:
    return on_dish(contact, body, master);
  case Surface::interface:
    return on_plane(contact, body, master);
  case Surface::rim:
    return on_rim(contact, body, master);
  case Surface::stop:
    break;
  }
  return on_stop(contact, body, master);
}

} // namespace rimpact::reduced::rigid
