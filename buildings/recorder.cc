#include "buildings/recorder.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::buildings {

using Eigen::Vector2d, Eigen::VectorXd;
using reduced::RimContact, reduced::Support;

namespace {
bool on_rims(const BearingModes &modes) {
  return std::any_of(modes.begin(), modes.end(), [](const auto &mode) { return mode.rim != RimContact::open; });
}
} // namespace

BuildingRecorder::BuildingRecorder(const BuildingBasis &building, Response *response, double output_step,
                                   BuildingTrace *trace, const MemberForces *members)
    : dynamics_(building), response_(response), trace_(trace), members_(members), output_step_(output_step),
      contact_step_(output_step), bearings_(building.slider.size()), floors_(building.model.n_diaphragms - 1) {
  if (building.n_bearings() > most_bearings || static_cast<int>(floors_.size()) > most_floors)
    throw InputError(fmt::format("the building has {} bearings and {} floors above its base; {} and {} are the most",
                                 building.n_bearings(), floors_.size(), most_bearings, most_floors));
  for (const double stiffness : building.rim_stiffness)
    if (stiffness > 0)
      contact_step_ = std::min(contact_step_, std::numbers::pi * std::sqrt(building.model.mass[0] / stiffness) / 120);
}

double BuildingRecorder::next_after(bool on_rims, double t) const {
  return on_rims ? t + contact_step_ : (std::floor(t / output_step_ + 1e-9) + 1) * output_step_;
}

void BuildingRecorder::begin(const VectorXd &y, const BuildingResponse &r) {
  initial_elastic_ = dynamics_.elastic_energy(y);
  initial_kinetic_ = dynamics_.kinetic_energy(y) + y[dynamics_.work(BuildingBasis::sliders_kinetic)];
  initial_gravity_ = dynamics_.potential_energy(y);
  initial_height_ =
      initial_gravity_ - dynamics_.potential_energy(dynamics_.at_rest()); // a building let go from a height
  final_ = y;
  watch(0, y, r), store(0, y, r);
  next_sample_ = next_after(false, 0);
}

void BuildingRecorder::begin(const BuildingDynamics &dynamics, const BearingModes &modes, const VectorXd &y) {
  begin(y, dynamics.evaluate(modes, 0, y));
  next_sample_ = next_after(on_rims(modes), 0);
}

void BuildingRecorder::segment(const BuildingDynamics &dynamics, const BearingModes &modes, const BuildingSegment &s) {
  while (next_sample_ <= s.t1) {
    if (response_) {
      VectorXd y = s.at(next_sample_);
      dynamics.project(modes, y);
      const auto r = dynamics.evaluate(modes, next_sample_, y);
      watch(next_sample_, y, r), store(next_sample_, y, r);
    }
    next_sample_ = next_after(on_rims(modes), next_sample_);
  }
  if (s.t1 > s.t0) {
    VectorXd y = s.at((s.t0 + s.t1) / 2);
    dynamics.project(modes, y);
    watch((s.t0 + s.t1) / 2, y, dynamics.evaluate(modes, (s.t0 + s.t1) / 2, y));
  }
  watch(s.t1, s.y1, dynamics.evaluate(modes, s.t1, s.y1));
  final_ = s.y1;
  largest_input_ = std::max(largest_input_, std::abs(s.y1[dynamics_.work(BuildingBasis::external)]));
}

void BuildingRecorder::press(int b, bool pressed, double t, const Vector2d &u, const Vector2d &v) {
  const double outwards = u.dot(v) / u.norm();
  bearings_[b].pressed = pressed;
  if (pressed) {
    Impact impact{};
    impact.touch_time = t, impact.release_time = -1, impact.impulse = 0; // before its touch: not released yet
    impact.direction_deg = std::atan2(u[1], u[0]) * 180 / std::numbers::pi, impact.approach_speed = outwards;
    bearings_[b].impacts.push_back(impact);
  } else {
    bearings_[b].impacts.back().release_time = t, bearings_[b].impacts.back().rebound_speed = -outwards;
  }
}

void BuildingRecorder::branch(const BuildingDynamics &dynamics, const BearingModes &before, const BearingModes &after,
                              double t, const VectorXd &y, double loss) {
  landing_loss_ += loss;
  bool changed = false;
  const auto r = dynamics.evaluate(after, t, y);
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    const bool was = before[b].rim == RimContact::pressed, is = after[b].rim == RimContact::pressed;
    if (was == is) continue;
    changed = true;
    press(b, is, t, r.bearings[b].u.head<2>(), r.bearings[b].v.head<2>());
  }
  watch(t, y, r);
  if (!changed) return;
  store(t, y, r);
  next_sample_ = next_after(on_rims(after), t);
}

void BuildingRecorder::step(double t, const VectorXd &y, const BuildingResponse &r) {
  bool changed = false, pressed = false;
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    const auto &one = r.bearings[b];
    const bool is = one.rim_force != 0;
    if (is != bearings_[b].pressed) changed = true, press(b, is, t, one.u.head<2>(), one.v.head<2>());
    pressed = pressed || is;
  }
  watch(t, y, r);
  if (changed || pressed || t >= next_sample_ - 1e-12) store(t, y, r);
  while (next_sample_ <= t + 1e-12) next_sample_ = next_after(false, next_sample_);
  final_ = y;
  largest_input_ = std::max(largest_input_, std::abs(y[dynamics_.work(BuildingBasis::external)]));
}

void BuildingRecorder::end(double t, const VectorXd &y, const BuildingResponse &r) {
  store(t, y, r);
  final_ = y;
}

Vector2d BuildingRecorder::drift(int floor, const VectorXd &y) const {
  return y.segment<2>(3 * floor + 3) - y.segment<2>(3 * floor);
}

/// Of the bearings' vertical forces, about the base's mass centre at rest.
Vector2d BuildingRecorder::overturning(const BuildingResponse &r) const {
  Vector2d m = Vector2d::Zero();
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    const double up = r.bearings[b].force()[2];
    m += up * Vector2d(dynamics_.slider[b].arm_y, -dynamics_.slider[b].arm_x);
  }
  return m;
}

void BuildingRecorder::watch(double t, const VectorXd &y, const BuildingResponse &r) {
  if (trace_) trace(t, y, r);
  hinges_.widen(r.members.hinges);
  const auto raise = [](double &peak, double value) { peak = std::max(peak, value); };
  Vector2d total = Vector2d::Zero();
  double up = 0;
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    auto &p = bearings_[b];
    const auto &one = r.bearings[b];
    const double travel = one.u.head<2>().norm();
    raise(p.travel, travel), raise(p.force, one.force().head<2>().norm()), raise(p.impact, one.rim_force);
    raise(p.largest_normal, one.normal), raise(p.lift, one.u[2] - one.height), raise(peak_height_, one.u[2]);
    p.smallest_normal = std::min(p.smallest_normal, std::max(0.0, one.normal));
    p.interface_slip = one.interface_slip;
    if (p.pressed) {
      Impact &impact = p.impacts.back();
      raise(impact.peak_force, one.rim_force), raise(impact.peak_penetration, -one.gap);
      *impact.impulse += (t - p.watched) / 2 * (p.rim_force + one.rim_force);
    }
    p.watched = t, p.rim_force = one.rim_force;
    total += one.force().head<2>(), up += std::max(0.0, one.normal);
  }
  raise(peak_displacement_, y.head<2>().norm()), raise(peak_shear_, total.norm()),
      raise(peak_rotation_, std::abs(y[2]));
  raise(peak_overturning_, overturning(r).norm());
  smallest_total_ = std::min(smallest_total_, up);
  raise(base_acceleration_, (r.acceleration.head<2>() + r.ground.head<2>()).norm());
  Vector2d shear = Vector2d::Zero();
  for (int f = static_cast<int>(floors_.size()) - 1; f >= 0; --f) {
    const int d = 3 * (f + 1);
    const Vector2d acceleration = r.acceleration.segment<2>(d) + r.ground.head<2>(), between = drift(f, y);
    shear += dynamics_.model.mass[d] * acceleration;
    auto &p = floors_[f];
    raise(p.displacement, y.segment<2>(d).norm()), raise(p.drift, between.norm()),
        raise(p.acceleration, acceleration.norm());
    raise(p.drift_x, std::abs(between[0])), raise(p.drift_y, std::abs(between[1])), raise(p.shear, shear.norm());
  }
}

BuildingInstant BuildingRecorder::instant(double t, const VectorXd &y, const BuildingResponse &r) const {
  BuildingInstant at{t, y.head(dynamics_.n), {}, {}, r.members.forces};
  for (const auto &b : r.bearings) at.normal.push_back(std::max(0.0, b.normal)), at.rim_force.push_back(b.rim_force);
  return at;
}

void BuildingRecorder::trace(double t, const VectorXd &y, const BuildingResponse &r) {
  if (members_) trace_->members.widen(r.members.forces.size() ? r.members.forces : members_->at(y.head(dynamics_.n)));
  double force = 0, travel = 0;
  for (const auto &b : r.bearings)
    force = std::max(force, b.rim_force), travel = std::max(travel, b.u.head<2>().norm());
  const bool harder = force > hardest_force_ || (hardest_force_ == 0 && travel > hardest_travel_);
  if (harder) trace_->hardest = instant(t, y, r), hardest_force_ = force, hardest_travel_ = travel;
  if (trace_->step > 0 && t >= trace_->step * static_cast<double>(trace_->instants.size()) - 1e-9)
    trace_->instants.push_back(instant(t, y, r));
}

EnergyLedger BuildingRecorder::ledger(const VectorXd &y) const {
  const auto &d = dynamics_;
  EnergyLedger l;
  l.initial = initial_kinetic_ + initial_height_;
  l.external = y[d.work(BuildingBasis::external)];
  l.gravity = d.potential_energy(y) - initial_gravity_ + initial_height_;
  l.gravity += y[d.work(BuildingBasis::sliders_potential)];
  l.kinetic = d.kinetic_energy(y) + y[d.work(BuildingBasis::sliders_kinetic)];
  l.elastic = d.elastic_energy(y) - initial_elastic_;
  l.plastic = y[d.work(BuildingBasis::hysteretic)];
  l.damping = y[d.work(BuildingBasis::damping)], l.friction = y[d.work(BuildingBasis::friction)];
  l.impact = y[d.work(BuildingBasis::rim)], l.contact = landing_loss_ + y[d.work(BuildingBasis::contact)];
  l.largest_input = largest_input_ + l.initial;
  return l;
}

} // namespace rimpact::buildings
