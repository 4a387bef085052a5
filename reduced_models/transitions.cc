// The hybrid part of Dynamics: holding, events and the branch that follows each.
#include "reduced_models/dynamics.h"
#include <cmath>
#include <stdexcept>

namespace rimpact::reduced {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// A landing is the fall of the clearance below this: lift-off starts at exactly zero clearance and rate [m].
constexpr double landing_clearance = 1e-13;

/// Orthonormal tangent frame of the surface at u: along the meridian and along the circle.
struct TangentFrame {
  Vector3d meridian, circle, normal;
  TangentFrame(const scene::SurfacePoint &p, const Vector2d &u) {
    const double r = u.norm();
    const Vector2d er = r > 0 ? Vector2d(u / r) : Vector2d::UnitX();
    meridian = Vector3d(er[0], er[1], p.gradient.dot(er)).normalized();
    circle = Vector3d(-er[1], er[0], 0);
    normal = Vector3d(-p.gradient[0], -p.gradient[1], 1).normalized();
  }
};

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

Hold Dynamics::hold(const Mode &mode, double t, const State &y) const {
  const Vector2d u(y[iX], y[iY]);
  const auto p = height.at(u[0], u[1]);
  const TangentFrame frame(p, u);
  Evaluation e;
  rim_terms(mode, u, Vector2d::Zero(), e);
  Vector3d a_g;
  const Vector3d F = applied(e, t, a_g);
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
  const Onset o = onset(drive, N * socket, height.curvatures(u.norm()));
  h.excess = weight > 0 ? (o.beta - coulomb_limit() * N) / weight : o.beta;
  const Vector3d direction = o.direction[0] * frame.meridian + o.direction[1] * frame.circle;
  h.direction = direction.head<2>().normalized();
  h.drive = o.beta;
  h.friction = -(drive[0] * frame.meridian + drive[1] * frame.circle);
  return h;
}

EventList Dynamics::events(const Mode &mode) const {
  EventList list;
  list.add(Event::turning);
  if (mode.support == Support::airborne) {
    list.add(Event::landing);
  } else {
    if (!park_wen_) list.add(Event::stop);
    if (mode.slow) list.add(Event::underway);
    if (reading == NormalForce::inertia) list.add(Event::uplift);
  }
  if (mode.rim == RimContact::open) {
    if (has_rim()) list.add(Event::touch);
  } else if (mode.rim == RimContact::relaxed) {
    list.add(Event::release);
    list.add(Event::press_again);
  } else {
    list.add(rim.law->unilateral ? Event::let_go : Event::release);
  }
  return list;
}

Vector2d Dynamics::slow_direction(const Mode &mode, double t, const State &y) const {
  constexpr double dt = 1e-5; // to see the drive turn [s]
  State ahead = y;
  ahead[iX] += dt * y[iVX], ahead[iY] += dt * y[iVY];
  const Hold now = hold(mode, t, y), next = hold(mode, t + dt, ahead);
  const Vector2d &e = now.direction;
  const double turning = (e[0] * next.direction[1] - e[1] * next.direction[0]) / dt;
  const double lag = std::hypot(y[iVX], y[iVY]) * turning * mass / (now.drive + now.excess * weight);
  return e - lag * Vector2d(-e[1], e[0]);
}

/// Drive along the motion over the Coulomb limit.
double Dynamics::drive_share(const Mode &mode, double t, const State &y) const {
  const Hold h = hold(mode, t, y);
  return h.drive * h.direction.dot(mode.e0) / (coulomb_limit() * h.normal);
}

bool Dynamics::becomes_slow(Mode &mode, double t, const State &y) const {
  const Vector2d v(y[iVX], y[iVY]);
  if (mode.slow || mode.support != Support::sliding || park_wen_ || v.norm() > slow_speed / 2 ||
      coulomb_limit() == 0)
    return false;
  const Vector2d e = hold(mode, t, y).direction;
  mode.slow = std::abs(e[0] * mode.e0[1] - e[1] * mode.e0[0]) < 0.01 && drive_share(mode, t, y) > 0.8;
  return mode.slow;
}

double Dynamics::value(Event event, const Mode &mode, double t, const State &y) const {
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  const double r = u.norm(), d = r - lateral_capacity;
  const auto trial = [&] { return rim.trial(d, u.dot(v) / r) / rim.stiffness; };
  switch (event) {
  case Event::stop:
    return v.dot(mode.e0);
  case Event::underway:
    return std::min(1 - v.norm() / slow_speed, drive_share(mode, t, y) - 0.6);
  case Event::uplift:
    return evaluate(mode, t, y).normal / weight;
  case Event::landing:
    return y[iZ] - height.at(u[0], u[1]).z + landing_clearance;
  case Event::touch:
    return -d;
  case Event::release:
    return d;
  case Event::let_go:
    return trial();
  case Event::press_again:
    return -trial();
  case Event::turning:
    return u.dot(v);
  }
  throw std::logic_error("unknown event");
}

void Dynamics::project(Mode &mode, State &y) const {
  if (mode.support == Support::airborne) return;
  const auto p = height.at(y[iX], y[iY]);
  y[iZ] = p.z;
  y[iVZ] = p.gradient[0] * y[iVX] + p.gradient[1] * y[iVY];
  const double speed = std::hypot(y[iVX], y[iVY]);
  if (mode.support == Support::sliding && speed > 0) mode.e0 = Vector2d(y[iVX], y[iVY]) / speed;
}

void Dynamics::settle(Mode &mode, double t, State &y) const {
  if (mode.support == Support::airborne) return;
  mode.support = Support::sliding;
  project(mode, y);
  const bool at_rest = y[iVX] == 0 && y[iVY] == 0;
  if (at_rest && !park_wen_) {
    const Hold h = hold(mode, t, y);
    mode.e0 = h.direction;
    mode.slow = h.excess > 0 && coulomb_limit() > 0;
    if (h.excess <= 0) mode.support = Support::stuck;
  }
  if (reading == NormalForce::inertia && evaluate(mode, t, y).normal < 0) {
    mode.support = Support::airborne;
    mode.slow = false;
  }
}

void Dynamics::release_from_rest(Mode &mode, double t, State &y) const {
  settle(mode, t, y);
  if (mode.support == Support::stuck) {
    mode.e0 = hold(mode, t, y).direction;
    mode.support = Support::sliding;
    mode.slow = coulomb_limit() > 0;
  }
}

double Dynamics::land(Mode &mode, double t, State &y) const {
  const auto p = height.at(y[iX], y[iY]);
  const Vector3d n = Vector3d(-p.gradient[0], -p.gradient[1], 1).normalized();
  Vector3d v(y[iVX], y[iVY], y[iVZ]);
  const double vn = v.dot(n);
  double rebound = -vertical_restitution_ * vn;
  // Ever smaller bounces would follow one another without end: below this the mass stays on the dish.
  const bool bounces = rebound > 1e-6 * speed_scale;
  if (!bounces) rebound = 0;
  v += (rebound - vn) * n; // frictionless impulse along the normal
  y[iVX] = v[0], y[iVY] = v[1], y[iVZ] = v[2], y[iZ] = p.z;
  if (!bounces) {
    mode.support = Support::sliding;
    settle(mode, t, y);
  }
  return mass / 2 * (vn * vn - rebound * rebound);
}

double Dynamics::apply(Event event, Mode &mode, double t, State &y) const {
  switch (event) {
  case Event::stop:
    // A right angle turned within one step is no stop: the caller goes on with the new direction.
    if (std::hypot(y[iVX], y[iVY]) <= stop_speed) y[iVX] = y[iVY] = y[iVZ] = 0;
    break;
  case Event::uplift:
    project(mode, y);
    mode.support = Support::airborne;
    mode.slow = false;
    return 0;
  case Event::landing:
    return land(mode, t, y);
  case Event::touch:
  case Event::press_again:
    mode.rim = RimContact::pressed;
    break;
  case Event::release:
    mode.rim = RimContact::open;
    break;
  case Event::let_go:
    mode.rim = RimContact::relaxed;
    break;
  case Event::underway:
    mode.slow = false;
    return 0;
  case Event::turning:
    return 0;
  }
  settle(mode, t, y);
  return 0;
}

Mode Dynamics::starting_mode(const BearingState &start, State &y) const {
  y = {start.u[0],   start.u[1],   start.u[2], start.v[0], start.v[1], start.v[2],
       start.eta[0], start.eta[1], 0,          0,          0,          0};
  Mode mode;
  const double r = std::hypot(y[iX], y[iY]), d = r - lateral_capacity;
  const double rate = r > 0 ? (y[iX] * y[iVX] + y[iY] * y[iVY]) / r : 0;
  // A state located at touch lies within rounding of it and moves outwards.
  if (has_rim() && (d > 0 || (d > -1e-12 && rate > 0)))
    mode.rim = rim.law->unilateral && rim.trial(d, rate) <= 0 ? RimContact::relaxed : RimContact::pressed;
  mode.support = start.airborne && reading == NormalForce::inertia ? Support::airborne : Support::sliding;
  settle(mode, start.t, y);
  return mode;
}

} // namespace rimpact::reduced
