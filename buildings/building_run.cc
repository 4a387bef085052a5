#include "buildings/building_run.h"
#include "files/error.h"
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

void BuildingRun::set_scales() {
  const auto &d = dynamics_;
  const int n = d.n;
  inverse_scale_ = VectorXd::Zero(d.n_state()); // the works are counted, not controlled
  double capacity = 1e300, arm = 1;
  for (const auto &law : d.laws) capacity = std::min(capacity, law.lateral_capacity);
  for (const auto &s : d.slider) arm = std::max(arm, std::hypot(s.arm_x, s.arm_y));
  const double speed = std::sqrt(d.gravity * capacity);
  inverse_scale_.head(n).setConstant(1 / (tolerance_ * capacity));
  inverse_scale_.segment(n, n).setConstant(1 / (tolerance_ * speed));
  for (int i = 0; i < d.model.n_diaphragms; ++i) inverse_scale_[3 * i + 2] *= arm, inverse_scale_[n + 3 * i + 2] *= arm;
  // enters through the friction only: one digit less where many are asked for
  inverse_scale_.segment(2 * n, 2 * d.n_bearings())
      .setConstant(1 / std::min(std::max(1e-8, tolerance_), 10 * tolerance_));
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

std::vector<double> BuildingRun::values(const std::vector<Watch> &events, double t, const VectorXd &y) const {
  std::vector<double> list;
  const BuildingResponse r = dynamics_.evaluate(modes_, t, y);
  for (const auto &[b, event] : events)
    list.push_back(event == Event::uplift
                       ? r.bearings[b].normal / dynamics_.weight
                       : dynamics_.laws[b].value(event, modes_[b], t, dynamics_.bearing_state(b, y)));
  return list;
}

void BuildingRun::try_step(double h) {
  step_.advance([&](double t, const VectorXd &y, VectorXd &dy) { dynamics_.rhs(modes_, t, y, dy); }, h);
}

double BuildingRun::largest_step() const {
  double h = pulse_step_;
  for (const auto &mode : modes_) {
    if (mode.rim != RimContact::open) h = std::min(h, contact_step_);
    if (mode.support == Support::airborne) h = std::min(h, 5e-3);
  }
  return h;
}

double BuildingRun::next_break(double t, double t_end) {
  const auto &breaks = dynamics_.laws[0].ground.breakpoints();
  while (break_index_ < breaks.size() && breaks[break_index_] <= t + 1e-12) ++break_index_;
  return break_index_ < breaks.size() ? std::min(breaks[break_index_], t_end) : t_end;
}

void BuildingRun::give_up() const {
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    const double r = dynamics_.slider[b].of(step_.y0.data()).head<2>().norm(),
                 edge = dynamics_.laws[b].height.limit_radius();
    if (r > 0.98 * edge)
      throw SolverStopped(fmt::format(
          "the slider of bearing {} left its dish at t = {:.6g} s: travel {:.4g} m reaches the edge at {:.4g} m", b + 1,
          step_.t, r, edge));
  }
  throw SolverStopped(fmt::format("the time step of the building became too small at t = {:.6g} s", step_.t));
}

void BuildingRun::attempt_until_accepted(double t_limit) {
  for (;;) {
    const double room = std::min(largest_step(), t_limit - step_.t), h = h_ < 0.999 * room ? h_ : room;
    try_step(h);
    const double error = step_.error(inverse_scale_);
    if (error <= 1) {
      const double grown = h * std::min(4.0, 0.9 * std::pow(std::max(error, 1e-10), -0.2));
      h_ = h < h_ ? std::max(h_, grown) : grown; // a step cut short by a limit says nothing against a longer one
      return;
    }
    h_ = std::isfinite(error) ? h * std::max(0.2, 0.9 * std::pow(error, -0.2)) : h / 4;
    if (h_ < 1e-13) give_up();
  }
}

void BuildingRun::locate(const std::vector<Watch> &events, int which, double f_low, double f_high) {
  double low = 0, high = step_.h;
  const std::vector<Watch> one{events[which]};
  int last_side = 0;
  for (int i = 0; i < 100 && high - low > 1e-15 + 1e-16 * step_.t; ++i) {
    double h = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(h > low && h < high) || i % 12 == 11) h = (low + high) / 2;
    try_step(h);
    const double f = values(one, step_.t + h, step_.y1)[0];
    if (f == 0) return;
    const int side = f > 0 ? 1 : -1;
    (f > 0 ? low : high) = h;
    (f > 0 ? f_low : f_high) = f;
    if (side == last_side) (f > 0 ? f_high : f_low) /= 2; // Illinois: halve the weight of the end that stays
    last_side = side;
  }
  try_step(high);
}

int BuildingRun::first_event(const std::vector<Watch> &events) {
  int first = -1;
  std::vector<bool> located(events.size(), false); // two may cross together, to rounding
  for (;;) { // each located event shortens the step; others may still lie before it
    const auto after = values(events, step_.t + step_.h, step_.y1);
    int next = -1;
    for (std::size_t i = 0; i < events.size(); ++i)
      if (!located[i] && after[i] < 0 && (next < 0 || at_start_[i] <= 0)) next = static_cast<int>(i);
    if (next < 0) return first;
    if (at_start_[next] > 0) {
      locate(events, next, at_start_[next], after[next]);
    } else { // begun at its zero: only where no shorter step finds it beyond
      const std::vector<Watch> one{events[next]};
      double h = step_.h;
      do h /= 4, try_step(h);
      while (h > 1e-10 && values(one, step_.t + h, step_.y1)[0] < 0);
      if (h > 1e-10) { // what was located lies beyond the shortened step
        first = -1, located.assign(events.size(), false);
        continue;
      }
      try_step(0);
    }
    first = next, located[next] = true;
    if (step_.h == 0) return first;
  }
}

void BuildingRun::set_out_on_rims(double t, const VectorXd &y, const VectorXd &dy) {
  for (int b = 0; b < dynamics_.n_bearings(); ++b) {
    if (!dynamics_.laws[b].denting(modes_[b])) continue;
    const auto state = dynamics_.bearing_state(b, y);
    auto rate = state;
    const Eigen::Vector3d a = dynamics_.slider[b].of(dy.data() + dynamics_.n);
    rate[reduced::iVX] = a[0], rate[reduced::iVY] = a[1];
    dynamics_.laws[b].set_out(modes_[b], t, state, rate);
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
  if (watch.event != Event::landing) dynamics_.settle(modes_, t, y, watch.event == Event::uplift ? watch.bearing : -1);
  dynamics_.project(modes_, y);
  recorder.branch(dynamics_, before, modes_, t, y, loss);
}

void BuildingRun::run(double t_end, BuildingRecorder &recorder) {
  set_scales();
  step_.resize(dynamics_.n_state());
  step_.t = 0, step_.y0 = dynamics_.start();
  dynamics_.settle(modes_, 0, step_.y0);
  recorder.begin(dynamics_, modes_, step_.y0);
  dynamics_.rhs(modes_, 0, step_.y0, step_.k[0]);
  int n_short = 0;
  while (step_.t < t_end - 1e-13) {
    const auto events = watched();
    at_start_ = values(events, step_.t, step_.y0);
    set_out_on_rims(step_.t, step_.y0, step_.k[0]);
    attempt_until_accepted(next_break(step_.t, t_end));
    const int event = first_event(events);
    recorder.steps.add(step_.t);
    n_short = step_.h < 1e-10 ? n_short + 1 : 0;
    if (n_short > 100)
      throw SolverStopped(fmt::format("the building chatters between branches at t = {:.6g} s", step_.t));
    dynamics_.project(modes_, step_.y1);
    const double t1 = step_.t + step_.h;
    recorder.segment(dynamics_, modes_,
                     {step_.t, t1, step_.y0, step_.y1, [&](double t) { return step_.at((t - step_.t) / step_.h); }});
    step_.t = t1, step_.y0 = step_.y1;
    arrive_on_rims(t1, step_.y0);
    if (event >= 0) {
      apply(events[event], t1, step_.y0, recorder);
      dynamics_.rhs(modes_, t1, step_.y0, step_.k[0]);
    } else {
      step_.k[0] = step_.k[6];
    }
  }
  recorder.end(step_.t, step_.y0, dynamics_.evaluate(modes_, step_.t, step_.y0));
}

} // namespace rimpact::buildings
