#include "buildings/building_run.h"
#include "io/files/error.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::buildings {

using Eigen::VectorXd;
using reduced::Event, reduced::RimContact, reduced::Support;

BuildingRun::BuildingRun(const BuildingDynamics &dynamics, const scene::Scene &scene)
    : dynamics_(dynamics), tolerance_(scene.reduced.tolerance), pulse_step_(0.02), modes_(dynamics.laws.size()) {
  if (scene.excitation.kind == scene::ExcitationKind::ricker)
    pulse_step_ = std::min(pulse_step_, scene.excitation.period / 20);
  contact_step_ = pulse_step_; // a contact is half a period of the base on its rim: never fewer than 20 steps
  for (const auto &law : dynamics.laws)
    if (law.has_rim())
      contact_step_ = std::min(
          {contact_step_, 2e-3, std::numbers::pi * std::sqrt(dynamics.model.mass[0] / law.rim.stiffness) / 20});
}

VectorXd BuildingRun::scales() const {
  const auto &d = dynamics_;
  const int n = d.n;
  VectorXd inverse = VectorXd::Zero(d.n_state()); // the works are counted, not controlled
  double capacity = 1e300, arm = 1;
  for (const auto &law : d.laws) capacity = std::min(capacity, law.lateral_capacity);
  for (const auto &s : d.slider) arm = std::max(arm, std::hypot(s.arm_x, s.arm_y));
  const double speed = std::sqrt(d.gravity * capacity);
  inverse.head(n).setConstant(1 / (tolerance_ * capacity));
  inverse.segment(n, n).setConstant(1 / (tolerance_ * speed));
  for (int i = 0; i < d.model.n_diaphragms; ++i) inverse[3 * i + 2] *= arm, inverse[n + 3 * i + 2] *= arm;
  // enters through the friction only: one digit less where many are asked for
  inverse.segment(2 * n, 2 * d.n_bearings()).setConstant(1 / std::min(std::max(1e-8, tolerance_), 10 * tolerance_));
  return inverse;
}

std::vector<BuildingRun::Watch> BuildingRun::watched() const {
  std::vector<Watch> list;
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    list.push_back({b, modes_[b].support == Support::airborne ? Event::landing : Event::uplift});
    const auto &law = dynamics_.laws[b];
    if (!law.has_rim()) continue;
    switch (modes_[b].rim) {
    case RimContact::open:
      list.push_back({b, Event::touch});
      break;
    case RimContact::relaxed:
      list.push_back({b, Event::release});
      list.push_back({b, Event::press_again});
      break;
    case RimContact::pressed:
      list.push_back({b, law.rim.law->unilateral ? Event::let_go : Event::release});
    }
  }
  return list;
}

double BuildingRun::value(const Watch &watch, double t, const VectorXd &y) const {
  const auto &[b, event] = watch;
  if (event == Event::uplift) return dynamics_.evaluate(modes_, t, y).bearings[b].normal / dynamics_.weight;
  return dynamics_.laws[b].value(event, modes_[b], t, dynamics_.bearing_state(b, y));
}

/// A normal force is already evaluated.
double BuildingRun::value_at_end(const Watch &watch, const reduced::DormandPrince<VectorXd> &step) const {
  if (watch.event == Event::uplift) return end_.bearings[watch.bearing].normal / dynamics_.weight;
  return value(watch, step.t + step.h, step.y1);
}

double BuildingRun::largest_step() const {
  double h = pulse_step_;
  for (const auto &mode : modes_) {
    if (mode.rim != RimContact::open) h = std::min(h, contact_step_);
    if (mode.support == Support::airborne) h = std::min(h, 5e-3);
  }
  return h;
}

void BuildingRun::give_up(double t, const VectorXd &y) const {
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    const double r = dynamics_.slider[b].of(y.data()).head<2>().norm(), edge = dynamics_.laws[b].height.limit_radius();
    if (r > 0.98 * edge)
      throw SolverStopped(fmt::format(
          "the slider of bearing {} left its dish at t = {:.6g} s: travel {:.4g} m reaches the edge at {:.4g} m", b + 1,
          t, r, edge));
  }
  throw SolverStopped(fmt::format("the time step of the building became too small at t = {:.6g} s", t));
}

void BuildingRun::begin_step_on_rims(double t, const VectorXd &y, const VectorXd &dy) {
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    if (!dynamics_.laws[b].denting(modes_[b])) continue;
    const auto state = dynamics_.bearing_state(b, y);
    auto rate = state;
    const Eigen::Vector3d a = dynamics_.slider[b].of(dy.data() + dynamics_.n);
    rate[reduced::iVX] = a[0], rate[reduced::iVY] = a[1];
    dynamics_.laws[b].begin_step(modes_[b], t, state, rate);
  }
}

void BuildingRun::arrive_on_rims(double t, const VectorXd &y) {
  for (int b = 0; b < dynamics_.n_bearings(); ++b) try {
      dynamics_.laws[b].arrive(modes_[b], t, dynamics_.bearing_state(b, y));
    } catch (const SolverStopped &stop) {
      throw SolverStopped(fmt::format("bearing {}: {}", b + 1, stop.what()));
    }
}

void BuildingRun::apply(const Watch &watch, double t, VectorXd &y, BuildingRecorder &recorder) {
  const BearingModes before = modes_;
  auto &mode = modes_[watch.bearing];
  double loss = 0;
  if (watch.event == Event::uplift)
    mode.support = Support::airborne;
  else if (watch.event == Event::landing)
    loss = dynamics_.land(watch.bearing, modes_, t, y);
  else
    mode.rim = dynamics_.laws[watch.bearing].rim_after(watch.event, mode, t, dynamics_.bearing_state(watch.bearing, y));
  if (watch.event != Event::landing)
    dynamics_.update_modes(modes_, t, y, watch.event == Event::uplift ? watch.bearing : -1);
  dynamics_.project(modes_, y);
  recorder.branch(dynamics_, before, modes_, t, y, loss);
}

void BuildingRun::run(double t_end, BuildingRecorder &recorder) {
  VectorXd first = dynamics_.start();
  dynamics_.update_modes(modes_, 0, first);
  stepper_.begin(0, first, scales(), dynamics_.laws[0].ground.breakpoints());
  auto &s = stepper_.step;
  recorder.begin(dynamics_, modes_, s.y0);
  dynamics_.rhs(modes_, 0, s.y0, s.k[0]);
  while (s.t < t_end - 1e-13) {
    const auto events = watched();
    begin_step_on_rims(s.t, s.y0, s.k[0]);
    const int event = stepper_.advance(events, t_end);
    recorder.steps.add(s.t);
    dynamics_.project(modes_, s.y1);
    recorder.segment(dynamics_, modes_, {s.t, s.t + s.h, s.y0, s.y1, [&](double t) { return s.at((t - s.t) / s.h); }});
    stepper_.move_on(s.y1);
    if (stepper_.chatters(100 + 2 * dynamics_.n_bearings())) // all may change at one instant
      throw SolverStopped(fmt::format("the building chatters between branches at t = {:.6g} s", s.t));
    arrive_on_rims(s.t, s.y0);
    if (event >= 0) {
      apply(events[event], s.t, s.y0, recorder);
      dynamics_.rhs(modes_, s.t, s.y0, s.k[0]);
    } else {
      s.k[0] = s.k[6];
    }
  }
  recorder.end(s.t, s.y0, dynamics_.evaluate(modes_, s.t, s.y0));
}

} // namespace rimpact::buildings
