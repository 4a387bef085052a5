// The hybrid part of Dynamics: the events and the branch that follows each.
#include "reduced_models/bearings/dynamics.h"

#include "io/files/error.h"
#include "reduced_models/bearings/curve_limits.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace rimpact::reduced {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// A landing is the fall of the clearance below this: lift-off starts at exactly zero clearance and rate [m].
constexpr double landing_clearance = 1e-14;

} // namespace

EventList Dynamics::events(const Mode &mode) const {
  EventList list;
  list.add(Event::turning);
  if (mode.support == Support::airborne) {
    list.add(Event::landing);
  } else if (mode.support == Support::stuck) {
    list.add(Event::slip);
  } else {
    if (!park_wen_) list.add(Event::stop);
    if (mode.slow) list.add(Event::underway);
    if (reading == NormalForce::inertia) list.add(Event::uplift);
  }
  if (std::isfinite(building.collapse_drift)) list.add(Event::collapse);
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

double Dynamics::value(Event event, const Mode &mode, double t, const State &y) const {
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  const double r = u.norm(), d = r - lateral_capacity;
  const auto trial = [&] { return rim_push(mode, t, u, v).trial / rim.stiffness; };
  switch (event) {
  case Event::stop:
    return v.dot(mode.e0);
  case Event::slip:
    return -hold(mode, t, y).excess;
  case Event::collapse:
    return building.collapse_drift - building.largest_drift(y, base(mode, y).position);
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
  case Event::target:
    break;
  }
  throw std::logic_error("the run itself knows its target");
}

RimPush Dynamics::rim_push(const Mode &mode, double t, const Vector2d &u, const Vector2d &v) const {
  const double r = u.norm();
  const laws::RimMotion motion{r - lateral_capacity, r > 0 ? u.dot(v) / r : 0, v.norm()};
  if (rim.law->yields) {
    if (!mode.dented.setting_out()) return mode.dented.push(rim, u, motion, dents);
    const auto present =
        mode.dented.under_way(t, wall_point(u, v, Vector2d::Zero(), lateral_capacity, dents.wall), dents);
    return mode.dented.push(rim, u, motion, dents, present ? &*present : nullptr);
  }
  const double force = rim.trial(motion);
  return {rim.law->unilateral ? std::max(0.0, force) : force, 0, force};
}

void Dynamics::begin_step(Mode &mode, double t, const State &y, const State &dy) const {
  if (!denting(mode)) return;
  mode.dented.begin_step(
      t, wall_point({y[iX], y[iY]}, {y[iVX], y[iVY]}, {dy[iVX], dy[iVY]}, lateral_capacity, dents.wall));
}

void Dynamics::arrive(Mode &mode, double t, const State &y) const {
  if (denting(mode))
    mode.dented.arrive(t, wall_point({y[iX], y[iY]}, {y[iVX], y[iVY]}, Vector2d::Zero(), lateral_capacity, dents.wall),
                       dents);
  keep_to_rim(mode, t, y);
}

void Dynamics::keep_to_rim(const Mode &mode, double t, const State &y) const {
  const auto lifted = [&] { // the slider, which a pad's spring holds to the dish while it bears
    return reading == NormalForce::pad ? pad_compression(height.at(y[iX], y[iY]), y) < 0
                                       : mode.support == Support::airborne;
  };
  if (mode.rim != RimContact::open && y[iZ] > lift_over_rim && lifted())
    throw SolverStopped(
        fmt::format("the slider is thrown over the rim at t = {:.5g} s: lifted by {:.1f} mm beyond L_c, "
                    "where its bottom passes the rim's top at {:.1f} mm",
                    t, 1e3 * y[iZ], 1e3 * lift_over_rim));
  if (mode.rim != RimContact::pressed) return;
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  if (foot.is_known() && foot.gone(rim_push(mode, t, u, v).inwards))
    throw SolverStopped(fmt::format("at t = {:.5g} s {}", t, foot.sentence()));
  if (!rim.curve) return;
  const PressedRim press{u.norm() - lateral_capacity, u.dot(v) / u.norm(), supported_mass,
                         mode.support == Support::airborne};
  if (const auto reason = beyond_curve(*rim.curve, press, mode.dented, u, dents))
    throw SolverStopped("impact_law \"curve\" at t = " + std::to_string(t) + " s: " + *reason +
                        "; take rung rim (rimpact run --rung rim)");
}

void Dynamics::place(const Mode &mode, State &y) const {
  if (rises(mode)) return;
  const auto p = height.at(y[iX], y[iY]);
  y[iZ] = p.z;
  y[iVZ] = p.gradient[0] * y[iVX] + p.gradient[1] * y[iVY];
}

void Dynamics::project(Mode &mode, State &y) const {
  if (mode.support == Support::airborne) return;
  place(mode, y);
  const double speed = std::hypot(y[iVX], y[iVY]);
  if (mode.support == Support::sliding && speed > 0) mode.e0 = Vector2d(y[iVX], y[iVY]) / speed;
}

void Dynamics::update_mode(Mode &mode, double t, State &y) const {
  if (mode.support == Support::airborne) return;
  mode.support = Support::sliding;
  project(mode, y);
  const bool at_rest = y[iVX] == 0 && y[iVY] == 0;
  if (at_rest && !park_wen_) {
    const Hold h = hold(mode, t, y);
    mode.e0 = h.direction;
    mode.slow = h.excess > 0 && friction_law.holds();
    if (h.excess <= 0) mode.support = Support::stuck;
  }
  if (reading == NormalForce::inertia && evaluate(mode, t, y).normal < 0) {
    mode.support = Support::airborne;
    mode.slow = false;
  }
}

void Dynamics::release_from_rest(Mode &mode, double t, State &y) const {
  update_mode(mode, t, y);
  if (mode.support == Support::stuck) {
    mode.e0 = hold(mode, t, y).direction;
    mode.support = Support::sliding;
    mode.slow = friction_law.holds();
  }
}

double Dynamics::land(Mode &mode, double t, State &y) const {
  const auto p = height.at(y[iX], y[iY]);
  const Vector3d n = Vector3d(-p.gradient[0], -p.gradient[1], 1).normalized();
  Vector3d v(y[iVX], y[iVY], y[iVZ]);
  const double vn = v.dot(n);
  double rebound = -vertical_restitution_ * vn;
  // Ever smaller bounces would follow one another without end: below this the mass stays on the dish.
  const bool bounces = rebound > 1e-5 * speed_scale;
  if (!bounces) rebound = 0;
  v += (rebound - vn) * n; // frictionless impulse along the normal
  y[iVX] = v[0], y[iVY] = v[1], y[iVZ] = v[2], y[iZ] = p.z;
  if (!bounces) {
    mode.support = Support::sliding;
    update_mode(mode, t, y);
  }
  return mass / 2 * (vn * vn - rebound * rebound);
}

RimContact Dynamics::rim_after(Event event, const Mode &mode, double t, const State &y) const {
  switch (event) {
  case Event::touch: // a dented place is met only at its dent's bottom
    return mode.dented.deepest_at({y[iX], y[iY]}, dents) > 0 &&
                   rim_push(mode, t, {y[iX], y[iY]}, {y[iVX], y[iVY]}).trial <= 0
               ? RimContact::relaxed
               : RimContact::pressed;
  case Event::press_again:
    return RimContact::pressed;
  case Event::let_go:
    return RimContact::relaxed;
  default:
    return RimContact::open;
  }
}

double Dynamics::apply(Event event, Mode &mode, double t, State &y) const {
  switch (event) {
  case Event::stop:
    // A right angle turned within one step is no stop: the run goes on with the new direction. In slow
    // sliding what is left across the drive is the error of that approximation.
    if (mode.slow || std::hypot(y[iVX], y[iVY]) <= stop_speed) y[iVX] = y[iVY] = y[iVZ] = 0;
    mode.slow = false;
    break;
  case Event::slip:
    release_from_rest(mode, t, y);
    return 0;
  case Event::uplift:
    project(mode, y);
    mode.support = Support::airborne;
    mode.slow = false;
    keep_to_rim(mode, t, y);
    return 0;
  case Event::landing:
    return land(mode, t, y);
  case Event::touch:
  case Event::press_again:
    mode.rim = rim_after(event, mode, t, y);
    keep_to_rim(mode, t, y);
    break;
  case Event::release:
  case Event::let_go:
    mode.rim = rim_after(event, mode, t, y);
    break;
  case Event::underway:
    mode.slow = false;
    return 0;
  case Event::turning:
  case Event::collapse:
  case Event::target:
    return 0;
  }
  update_mode(mode, t, y);
  return 0;
}

Mode Dynamics::starting_mode(const BearingState &start, State &y) const {
  y = State(n_state());
  for (int c = 0; c < 3; ++c) y[iX + c] = start.u[c], y[iVX + c] = start.v[c];
  y[iEX] = start.eta[0], y[iEY] = start.eta[1];
  building.follow({start.u, start.v}, y);
  if (heats()) std::copy(start.heat.begin(), start.heat.end(), y.begin() + heat_begins());
  Mode mode;
  mode.dented = start.rim;
  const Vector2d u(y[iX], y[iY]), v(y[iVX], y[iVY]);
  const double d = u.norm() - lateral_capacity;
  // A state located at touch lies within rounding of it and moves outwards.
  if (has_rim() && (d > 0 || (d > -1e-12 && u.dot(v) > 0)))
    mode.rim =
        rim.law->unilateral && rim_push(mode, start.t, u, v).trial <= 0 ? RimContact::relaxed : RimContact::pressed;
  mode.support = start.airborne && reading == NormalForce::inertia ? Support::airborne : Support::sliding;
  update_mode(mode, start.t, y);
  return mode;
}

} // namespace rimpact::reduced
