#include "reduced_models/hybrid_run.h"
#include "files/error.h"
#include <algorithm>
#include <numbers>

namespace rimpact::reduced {

namespace {

/// From this tolerance on the error estimate judges steps over a record's kinks; below it every kink ends one.
constexpr double coarse = 1e-6;

Eigen::Vector3d position(const Dynamics &dynamics, const Mode &mode, const State &y) {
  const bool air = mode.support == Support::airborne;
  return {y[iX], y[iY], air ? y[iZ] : dynamics.height.at(y[iX], y[iY]).z};
}

[[noreturn]] void give_up(const Dynamics &dynamics, double t, const State &y) {
  const double r = std::hypot(y[iX], y[iY]);
  if (r > 0.98 * dynamics.height.limit_radius())
    throw SolverStopped("the slider left the dish at t = " + std::to_string(t) + " s: travel " + std::to_string(r) +
                        " m reaches its edge at " + std::to_string(dynamics.height.limit_radius()) + " m");
  throw SolverStopped("the time step of the reduced model became too small at t = " + std::to_string(t) + " s");
}

} // namespace

HybridRun::HybridRun(const Dynamics &dynamics, const scene::Scene &scene)
    : dynamics_(dynamics), tolerance_(scene.reduced.tolerance), pulse_scale_(0.02) {
  if (scene.excitation.kind == scene::ExcitationKind::ricker)
    pulse_scale_ = std::min(pulse_scale_, scene.excitation.period / 20);
  quiet_ = scene.excitation.kind == scene::ExcitationKind::free ||
           (scene.excitation.kind == scene::ExcitationKind::window && !scene.excitation.with_ground);
  // a contact is half a period of mass and spring: never fewer than 20 steps
  contact_limit_ = pulse_scale_;
  if (dynamics.has_rim())
    contact_limit_ = std::min(2e-3, std::numbers::pi * std::sqrt(dynamics.mass / dynamics.rim.stiffness) / 20);
}

void HybridRun::set_scales(const BearingState &start) {
  // Without ground motion the energy at the start bounds the speeds: a gentle motion gets as many digits.
  double share = 1;
  if (quiet_) {
    const double energy =
        dynamics_.supported_mass / 2 * start.v.squaredNorm() + dynamics_.weight * std::max(0.0, start.u[2]);
    share = std::clamp(std::sqrt(2 * energy / dynamics_.supported_mass) / dynamics_.speed_scale, 1e-4, 1.0);
  }
  inverse_scale_ = State(dynamics_.n_state());
  for (int i : {iX, iY, iZ}) inverse_scale_[i] = 1 / (tolerance_ * share * dynamics_.lateral_capacity);
  for (int i : {iVX, iVY, iVZ}) inverse_scale_[i] = 1 / (tolerance_ * share * dynamics_.speed_scale);
  // enters through m a only: one digit less where many are asked for
  for (int i : {iEX, iEY}) inverse_scale_[i] = 1 / std::min(std::max(1e-8, tolerance_), 10 * tolerance_);
  for (int floor = 0; floor < dynamics_.building.n_floors(); ++floor)
    for (int i = 0; i < n_floor; ++i) inverse_scale_[iFloors + floor * n_floor + i] = inverse_scale_[iX + i];
}

double HybridRun::largest_step(const Mode &mode) const {
  if (mode.rim != RimContact::open) return contact_limit_;
  return mode.support == Support::airborne ? 5e-3 : pulse_scale_;
}

void HybridRun::try_step(double h) {
  step_.advance([&](double t, const State &y, State &dy) { end_ = dynamics_.rhs(mode_, t, y, dy, &footing_); }, h);
}

double HybridRun::event_value(const Crossing &c, double t, const State &y) const {
  return c.by_stop ? (*stop_)(position(dynamics_, mode_, y)) : dynamics_.value(c.event, mode_, t, y);
}

/// Of the step last tried, most of it already evaluated.
double HybridRun::value_at_end(const Crossing &c) const {
  const bool is_known = !c.by_stop && dynamics_.inside(step_.y1);
  if (is_known && c.event == Event::uplift) return end_.normal / dynamics_.weight;
  if (is_known && c.event == Event::slip) return -end_.excess;
  return event_value(c, step_.t + step_.h, step_.y1);
}

bool HybridRun::crosses(const Crossing &c) {
  const double after = value_at_end(c);
  if (after > 0) return false;
  const double before = c.by_stop ? stop_start_ : event_value(c, step_.t, step_.y0);
  if (before > 0) return true;
  return after < 0 && !(c.event == Event::turning && !c.by_stop);
}

/// Shortens the step to the crossing, by steps of other lengths from its start (Illinois).
void HybridRun::locate(const Crossing &c) {
  double low = 0, high = step_.h;
  double f_low = c.by_stop ? stop_start_ : event_value(c, step_.t, step_.y0);
  double f_high = value_at_end(c);
  int last_side = 0;
  for (int i = 0; i < 100 && high - low > 1e-15 + 1e-16 * step_.t; ++i) {
    double h = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(h > low && h < high) || i % 12 == 11) h = (low + high) / 2;
    try_step(h);
    const double f = value_at_end(c);
    if (f == 0) return;
    const int side = f > 0 ? 1 : -1;
    (f > 0 ? low : high) = h;
    (f > 0 ? f_low : f_high) = f;
    if (side == last_side) // Illinois: halve the weight of the end that stays
      (f > 0 ? f_high : f_low) /= 2;
    last_side = side;
  }
  try_step(high);
}

HybridRun::Crossing HybridRun::first_crossing(const StopFunction &stop) {
  Crossing first;
  const auto look = [&](const Crossing &c) {
    if (!crosses(c)) return;
    const double before = c.by_stop ? stop_start_ : event_value(c, step_.t, step_.y0);
    if (before <= 0) { // a branch that began exactly at the zero: is there a shorter step with a positive value?
      for (double h = step_.h / 4; h > 1e-10; h /= 4) {
        try_step(h);
        if (event_value(c, step_.t + h, step_.y1) > 0) {
          first.found = false; // what was found lies beyond the shortened step
          return;
        }
      }
      try_step(0);
    } else {
      locate(c);
    }
    first = c;
    first.found = true;
  };
  for (const Event event : dynamics_.events(mode_)) look({false, false, event});
  if (stop) look({false, true, Event::touch});
  return first;
}

/// A step shortened to a stop has stages close to v = 0, where the direction of friction swings round unless
/// the motion is straight. When that spoils the step it ends before the stop: the next ones come closer.
bool HybridRun::stops_accurately() {
  const double h = step_.h;
  if (step_.error(inverse_scale_) <= 1) return true;
  for (double share = 0.9; share * h > 1e-12; share /= 2) {
    try_step(share * h);
    if (step_.error(inverse_scale_) <= 1) return false;
  }
  try_step(h);
  return true;
}

double HybridRun::next_break(double t, double t_end) {
  if (tolerance_ >= coarse) return t_end;
  const auto &breaks = dynamics_.ground.breakpoints();
  while (break_index_ < breaks.size() && breaks[break_index_] <= t + 1e-12) ++break_index_;
  return break_index_ < breaks.size() ? std::min(breaks[break_index_], t_end) : t_end;
}

void HybridRun::attempt_until_accepted(double t_limit) {
  for (;;) {
    const double room = std::min(largest_step(mode_), t_limit - step_.t);
    const double h = h_ < 0.999 * room ? h_ : room;
    try_step(h);
    const double error = step_.error(inverse_scale_);
    if (error <= 1) {
      const double grown = h * std::min(4.0, 0.9 * std::pow(std::max(error, 1e-10), -0.2));
      h_ = h < h_ ? std::max(h_, grown) : grown; // a step cut short by a limit says nothing against a longer one
      return;
    }
    h_ = std::isfinite(error) ? h * std::max(0.2, 0.9 * std::pow(error, -0.2)) : h / 4;
    if (h_ < 1e-13) give_up(dynamics_, step_.t, step_.y0);
  }
}

void HybridRun::rest(double t_end, Recorder &recorder) {
  const double t1 = end_of_rest(dynamics_, mode_, step_.y0, step_.t, t_end, pulse_scale_ / 2);
  const State y = step_.y0;
  recorder.segment(mode_, {step_.t, t1, y, y, [&](double) { return y; }}, false);
  step_.t = t1;
  if (t1 >= t_end) return;
  const Mode before = mode_;
  dynamics_.release_from_rest(mode_, t1, step_.y0);
  recorder.branch(before, mode_, t1, step_.y0, 0);
  dynamics_.rhs(mode_, t1, step_.y0, step_.k[0]);
}

HybridRun::Result HybridRun::run(const BearingState &start, double t_end, const StopFunction &stop,
                                 Recorder &recorder) {
  Result result;
  stop_ = &stop;
  break_index_ = 0;
  set_scales(start);
  h_ = 1e-3;
  step_.resize(dynamics_.n_state());
  step_.t = start.t;
  mode_ = dynamics_.starting_mode(start, step_.y0);
  recorder.begin(mode_, step_.t, step_.y0);
  if (stop) stop_start_ = stop(position(dynamics_, mode_, step_.y0));
  dynamics_.rhs(mode_, step_.t, step_.y0, step_.k[0]);
  int n_short = 0;
  while (step_.t < t_end - 1e-13) {
    if (dynamics_.at_rest(mode_)) {
      rest(t_end, recorder);
      continue;
    }
    dynamics_.set_out(mode_, step_.t, step_.y0, step_.k[0]);
    attempt_until_accepted(next_break(step_.t, t_end));
    Crossing crossing = first_crossing(stop);
    if (crossing.found && crossing.event == Event::stop && !crossing.by_stop) crossing.found = stops_accurately();
    recorder.steps.add(step_.t);
    n_short = step_.h < 1e-10 ? n_short + 1 : 0;
    if (n_short > 100)
      throw SolverStopped("the reduced model chatters between branches at t = " + std::to_string(step_.t) + " s");
    const Mode during = mode_; // with the direction the step began in: at a stop y1 may lie just beyond v = 0
    dynamics_.project(mode_, step_.y1);
    const double t1 = step_.t + step_.h;
    const bool rim_changes = crossing.found && (crossing.by_stop || changes_rim(crossing.event));
    recorder.segment(
        during, {step_.t, t1, step_.y0, step_.y1, [&](double t) { return step_.at((t - step_.t) / step_.h); }, &end_},
        rim_changes);
    step_.t = t1;
    step_.y0 = step_.y1;
    if (stop) stop_start_ = stop(position(dynamics_, mode_, step_.y0));
    if (crossing.found && crossing.by_stop) {
      result.stopped = true;
      break;
    }
    if (crossing.found && crossing.event == Event::collapse) {
      result.collapsed = true;
      break;
    }
    dynamics_.arrive(mode_, t1, step_.y0);
    const Mode before = mode_;
    double loss = 0;
    if (crossing.found) loss = dynamics_.apply(crossing.event, mode_, t1, step_.y0);
    if (crossing.found || dynamics_.slow_down(mode_, t1, step_.y0)) {
      recorder.branch(before, mode_, t1, step_.y0, loss);
      dynamics_.rhs(mode_, t1, step_.y0, step_.k[0]);
    } else {
      step_.k[0] = step_.k[6];
    }
  }
  recorder.end(mode_, step_.t, step_.y0);
  const State &y = step_.y0;
  result.mode = mode_;
  result.state = {step_.t,          {y[iX], y[iY], y[iZ]}, {y[iVX], y[iVY], y[iVZ]}, mode_.support == Support::airborne,
                  {y[iEX], y[iEY]}, mode_.dented};
  return result;
}

} // namespace rimpact::reduced
