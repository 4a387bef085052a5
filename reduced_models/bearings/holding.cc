// Whether friction can hold the mass, and the slow sliding just above that limit.
#include "reduced_models/bearings/dynamics.h"
#include <cmath>

namespace rimpact::reduced {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// What remains of a drive on a body at rest after the socket's share, for the direction in which it would
/// slide: e fulfils drive = socket(e) + beta e, beta being what the sliding face must hold.
struct Onset {
  Vector2d direction;
  double beta;
};
Onset onset(const Vector2d &drive, double socket_force, const scene::Curvatures &k) {
  const double size = drive.norm();
  if (size == 0) return {Vector2d::UnitX(), 0};
  Onset o{drive / size, size};
  if (socket_force == 0) return o;
  const Vector2d K(k.meridional, k.circumferential);
  for (int i = 0; i < 30; ++i) {
    const Vector2d turned = K.cwiseProduct(o.direction);
    const Vector2d rest = drive - socket_force / turned.norm() * K.cwiseProduct(turned);
    o.beta = rest.dot(o.direction);
    if (o.beta <= 0) return o; // the socket alone holds it
    const Vector2d next = rest.normalized();
    const double change = (next - o.direction).norm();
    o.direction = next;
    if (change < 1e-14) break;
  }
  return o;
}

} // namespace

TangentFrame::TangentFrame(const scene::SurfacePoint &p, const Vector2d &u) {
  const double r = u.norm();
  const Vector2d er = r > 0 ? Vector2d(u / r) : Vector2d::UnitX();
  meridian = Vector3d(er[0], er[1], p.gradient.dot(er)).normalized();
  circle = Vector3d(-er[1], er[0], 0);
  normal = Vector3d(-p.gradient[0], -p.gradient[1], 1).normalized();
}

Hold Dynamics::hold(const Mode &mode, double t, const State &y) const {
  return hold(mode, t, y, on_dish(t, y));
}

Hold Dynamics::hold(const Mode &mode, double t, const State &y, const Site &site) const {
  const Vector2d u(y[iX], y[iY]);
  const auto &p = site.dish;
  TangentFrame own;
  if (!site.frame) own = TangentFrame(p, u);
  const TangentFrame &frame = site.frame ? *site.frame : own;
  Evaluation e;
  rim_terms(mode, t, u, Vector2d::Zero(), e);
  const Vector3d F = applied(e, y, {site.base.position, Vector3d::Zero()}, site.ground);
  Hold h;
  Vector2d drive; // tangential, in the frame (meridian, circle)
  if (reading == NormalForce::constant) {
    h.normal = weight;
    const Vector2d planar = F.head<2>() + weight * frame.normal.head<2>();
    const Vector3d tangent(planar[0], planar[1], p.gradient.dot(planar));
    drive = {tangent.dot(frame.meridian), tangent.dot(frame.circle)};
  } else {
    h.normal = -frame.normal.dot(F);
    drive = {F.dot(frame.meridian), F.dot(frame.circle)};
  }
  const double N = std::max(0.0, h.normal);
  const Onset o = onset(drive, N * socket, socket > 0 ? height.curvatures(u.norm()) : scene::Curvatures{});
  h.excess = weight > 0 ? (o.beta - mu(0, N, y).value * N) / weight : o.beta;
  const Vector3d direction = o.direction[0] * frame.meridian + o.direction[1] * frame.circle;
  h.direction = direction.head<2>().normalized();
  h.drive = o.beta;
  h.friction = -(drive[0] * frame.meridian + drive[1] * frame.circle);
  return h;
}

Vector2d Dynamics::slow_direction(const Mode &mode, double t, const State &y, const Site &site) const {
  constexpr double dt = 1e-5; // to see the drive turn [s]
  const Hold now = hold(mode, t, y, site);
  const auto direction_at = [&](double later) {
    State moved = y;
    moved[iX] += later * y[iVX], moved[iY] += later * y[iVY];
    for (int i = 0; i < building.n_floors(); ++i)
      for (int c = fX; c <= fZ; ++c) moved[iFloors + i * n_floor + c] += later * y[iFloors + i * n_floor + fVX + c];
    return inside(moved) ? hold(mode, t + later, moved).direction : now.direction;
  };
  const Vector2d &e = now.direction, change = (direction_at(dt) - direction_at(-dt)) / (2 * dt);
  const double turning = e[0] * change[1] - e[1] * change[0];
  const double lag = std::hypot(y[iVX], y[iVY]) * turning * mass / (now.drive + now.excess * weight);
  return e - lag * Vector2d(-e[1], e[0]);
}

/// Drive along the motion over the Coulomb limit.
double Dynamics::drive_share(const Mode &mode, double t, const State &y) const {
  const Hold h = hold(mode, t, y);
  return h.drive * h.direction.dot(mode.e0) / (mu(0, h.normal, y).value * h.normal);
}

bool Dynamics::slow_down(Mode &mode, double t, State &y) const {
  const Vector2d v(y[iVX], y[iVY]);
  const double speed = v.norm();
  if (mode.support != Support::sliding || park_wen_ || speed > slow_speed / 2) return false;
  if (speed <= stop_speed && v.dot(evaluate(mode, t, y).acceleration.head<2>()) < 0) {
    apply(Event::stop, mode, t, y);
    return true;
  }
  if (mode.slow) { // begun outside its range
    mode.slow = value(Event::underway, mode, t, y) > 0;
    return !mode.slow;
  }
  if (!friction_law.holds()) return false;
  const Vector2d e = hold(mode, t, y).direction;
  mode.slow = std::abs(e[0] * mode.e0[1] - e[1] * mode.e0[0]) < 0.01 && drive_share(mode, t, y) > 0.8;
  if (mode.slow) { // begins on the direction it would reach within |v| / (mu g)
    const Vector2d along = speed * slow_direction(mode, t, y, on_dish(t, y)).normalized();
    y[iVX] = along[0], y[iVY] = along[1];
    project(mode, y);
  }
  return mode.slow;
}

} // namespace rimpact::reduced
