#include "reduced_models/motion/hybrid_run.h"
#include "io/files/error.h"
#include "reduced_models/motion/rest.h"
#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::reduced {

namespace {

/// From this tolerance on the error estimate judges steps over a record's kinks; below it every kink ends one.
constexpr double coarse = 1e-6;
/// Local error of the sliding steel's temperature [K]: 6e-6 of a coefficient.
constexpr double degrees_a_step = 1e-3;

Eigen::Vector3d position(const Dynamics &dynamics, const Mode &mode, const State &y) {
  return {y[iX], y[iY], dynamics.rises(mode) ? y[iZ] : dynamics.height.at(y[iX], y[iY]).z};
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

State HybridRun::scales(const BearingState &start) const {
  // Without ground motion the energy at the start bounds the speeds: a gentle motion gets as many digits.
  double share = 1;
  if (quiet_) {
    const double energy =
        dynamics_.supported_mass / 2 * start.v.squaredNorm() + dynamics_.weight * std::max(0.0, start.u[2]);
    share = std::clamp(std::sqrt(2 * energy / dynamics_.supported_mass) / dynamics_.speed_scale, 1e-4, 1.0);
  }
  State inverse(dynamics_.n_state());
  for (int i : {iX, iY, iZ}) inverse[i] = 1 / (tolerance_ * share * dynamics_.lateral_capacity);
  for (int i : {iVX, iVY, iVZ}) inverse[i] = 1 / (tolerance_ * share * dynamics_.speed_scale);
  // enters through m a only: one digit less where many are asked for
  for (int i : {iEX, iEY}) inverse[i] = 1 / std::min(std::max(1e-8, tolerance_), 10 * tolerance_);
  for (int floor = 0; floor < dynamics_.building.n_floors(); ++floor)
    for (int i = 0; i < n_floor; ++i) inverse[iFloors + floor * n_floor + i] = inverse[iX + i];
  for (int i = dynamics_.heat_begins(); i < dynamics_.n_state(); ++i) inverse[i] = 1 / degrees_a_step;
  return inverse;
}

double HybridRun::largest_step() const {
  if (mode_.rim != RimContact::open) return contact_limit_;
  return mode_.support == Support::airborne ? 5e-3 : pulse_scale_;
}

void HybridRun::give_up(double t, const State &y) const {
  const double r = std::hypot(y[iX], y[iY]), edge = dynamics_.height.limit_radius();
  if (r > 0.98 * edge)
    throw SolverStopped(fmt::format(
        "the slider left the dish at t = {:.6f} s: travel {:.6f} m reaches its edge at {:.6f} m", t, r, edge));
  throw SolverStopped(fmt::format("the time step of the reduced model became too small at t = {:.6f} s", t));
}

double HybridRun::value(Event event, double t, const State &y) const {
  return event == Event::target ? (*stop_)(position(dynamics_, mode_, y)) : dynamics_.value(event, mode_, t, y);
}

/// Most of it already evaluated.
double HybridRun::value_at_end(Event event, const DormandPrinceStep &step) const {
  const bool is_known = dynamics_.inside(step.y1);
  if (is_known && event == Event::uplift) return end_.normal / dynamics_.weight;
  if (is_known && event == Event::slip) return -end_.excess;
  return value(event, step.t + step.h, step.y1);
}

/// A step shortened to a stop has stages close to v = 0, where the direction of friction swings round unless
/// the motion is straight. When that spoils the step it ends before the stop: the next ones come closer.
bool HybridRun::stops_accurately() {
  const double h = stepper_.step.h;
  if (stepper_.accurate()) return true;
  for (double share = 0.9; share * h > 1e-12; share /= 2) {
    stepper_.try_step(share * h);
    if (stepper_.accurate()) return false;
  }
  stepper_.try_step(h);
  return true;
}

void HybridRun::rest(double t_end, Recorder &recorder) {
  auto &s = stepper_.step;
  const double t1 = end_of_rest(dynamics_, mode_, s.y0, s.t, t_end, pulse_scale_ / 2);
  const State y = s.y0;
  recorder.segment(mode_, {s.t, t1, y, y, [&](double) { return y; }}, false);
  s.t = t1;
  if (t1 >= t_end) return;
  const Mode before = mode_;
  dynamics_.release_from_rest(mode_, t1, s.y0);
  recorder.branch(before, mode_, t1, s.y0, 0);
  dynamics_.rhs(mode_, t1, s.y0, s.k[0]);
}

/// One step and what has ended it.
std::optional<Event> HybridRun::step(double t_end, Recorder &recorder) {
  auto &s = stepper_.step;
  dynamics_.begin_step(mode_, s.t, s.y0, s.k[0]);
  EventList events = dynamics_.events(mode_);
  if (*stop_) events.add(Event::target);
  const int found = stepper_.advance(events, t_end);
  std::optional<Event> event;
  if (found >= 0) event = events.list[found];
  if (event == Event::stop && !stops_accurately()) event.reset();
  recorder.steps.add(s.t);
  const Mode during = mode_; // with the direction the step began in: at a stop y1 may lie just beyond v = 0
  dynamics_.project(mode_, s.y1);
  recorder.segment(during, {s.t, s.t + s.h, s.y0, s.y1, [&](double t) { return s.at((t - s.t) / s.h); }, &end_},
                   event && changes_rim(*event));
  stepper_.move_on(s.y1);
  if (stepper_.chatters(100))
    throw SolverStopped("the reduced model chatters between branches at t = " + std::to_string(s.t) + " s");
  return event;
}

/// The branch after a step.
void HybridRun::follow(std::optional<Event> event, Recorder &recorder) {
  auto &s = stepper_.step;
  dynamics_.arrive(mode_, s.t, s.y0);
  const Mode before = mode_;
  double loss = 0;
  if (event) loss = dynamics_.apply(*event, mode_, s.t, s.y0);
  if (event || dynamics_.slow_down(mode_, s.t, s.y0)) {
    recorder.branch(before, mode_, s.t, s.y0, loss);
    dynamics_.rhs(mode_, s.t, s.y0, s.k[0]);
  } else {
    s.k[0] = s.k[6];
  }
}

HybridRun::Result HybridRun::run(const BearingState &start, double t_end, const StopFunction &stop,
                                 Recorder &recorder) {
  static const std::vector<double> none;
  Result result;
  stop_ = &stop;
  State first;
  mode_ = dynamics_.starting_mode(start, first);
  stepper_.begin(start.t, first, scales(start), tolerance_ < coarse ? dynamics_.ground.breakpoints() : none);
  auto &s = stepper_.step;
  recorder.begin(mode_, s.t, s.y0);
  dynamics_.rhs(mode_, s.t, s.y0, s.k[0]);
  while (s.t < t_end - 1e-13) {
    if (dynamics_.at_rest(mode_)) {
      rest(t_end, recorder);
      continue;
    }
    const auto event = step(t_end, recorder);
    result.stopped = event == Event::target, result.collapsed = event == Event::collapse;
    if (result.stopped || result.collapsed) break;
    follow(event, recorder);
  }
  recorder.end(mode_, s.t, s.y0);
  const State &y = s.y0;
  result.mode = mode_;
  result.state = {s.t,
                  {y[iX], y[iY], y[iZ]},
                  {y[iVX], y[iVY], y[iVZ]},
                  mode_.support == Support::airborne,
                  {y[iEX], y[iEY]},
                  mode_.dented};
  if (dynamics_.heats())
    std::copy_n(y.begin() + dynamics_.heat_begins(), friction::n_heat_modes, result.state.heat.begin());
  return result;
}

} // namespace rimpact::reduced
