#include "reduced_models/motion/cvode_run.h"
#include "io/files/error.h"
#include "reduced_models/motion/hybrid_run.h"
#include "reduced_models/motion/rest.h"
#include "reduced_models/motion/sundials.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {

namespace {

/// CVODE's objects, created once a run and reinitialised after each event.
class Cvode {
public:
  Cvode(const Dynamics &dynamics, double tolerance) : dynamics_(dynamics) {
    const int n_state = dynamics.n_state();
    y_ = N_VNew_Serial(n_state, context_);
    absolute_ = N_VNew_Serial(n_state, context_);
    // Displacements and velocities decide; the works are quadratures along the way.
    const double work = dynamics.weight * dynamics.lateral_capacity;
    const double scales[n_bearing] = {dynamics.lateral_capacity,
                                      dynamics.lateral_capacity,
                                      dynamics.lateral_capacity,
                                      dynamics.speed_scale,
                                      dynamics.speed_scale,
                                      dynamics.speed_scale,
                                      1,
                                      1,
                                      work,
                                      work,
                                      work,
                                      work};
    for (int i = 0; i < n_bearing; ++i) NV_Ith_S(absolute_, i) = tolerance * std::max(scales[i], 1e-12);
    for (int i = dynamics.heat_begins(); i < n_state; ++i) NV_Ith_S(absolute_, i) = 1e-4; // [K]
    for (int i = iDamping; i < dynamics.heat_begins(); ++i)
      NV_Ith_S(absolute_, i) = tolerance * (i < iFloors ? work : scales[(i - iFloors) % n_floor]);
    matrix_ = SUNDenseMatrix(n_state, n_state, context_);
    solver_ = SUNLinSol_Dense(y_, matrix_, context_);
    memory_ = CVodeCreate(CV_BDF, context_);
    check(CVodeInit(memory_, rhs, 0.0, y_), "CVodeInit");
    check(CVodeSetUserData(memory_, this), "CVodeSetUserData");
    check(CVodeSVtolerances(memory_, tolerance, absolute_), "CVodeSVtolerances");
    check(CVodeSetLinearSolver(memory_, solver_, matrix_), "CVodeSetLinearSolver");
    check(CVodeSetMaxNumSteps(memory_, 10'000'000), "CVodeSetMaxNumSteps");
    silence(context_, memory_);
    CVodeSetNoInactiveRootWarn(memory_);
  }
  ~Cvode() {
    CVodeFree(&memory_);
    SUNLinSolFree(solver_);
    SUNMatDestroy(matrix_);
    N_VDestroy(absolute_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  Cvode(const Cvode &) = delete;
  Cvode &operator=(const Cvode &) = delete;

  /// Begins a branch at (t, y) with its events as root functions.
  void restart(const Mode &mode, double t, const State &y, double largest_step) {
    mode_ = mode;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(y_));
    check(CVodeReInit(memory_, t, y_), "CVodeReInit");
    check(CVodeSetMaxStep(memory_, largest_step), "CVodeSetMaxStep");
    const auto events = dynamics_.events(mode);
    check(CVodeRootInit(memory_, events.n, roots), "CVodeRootInit");
    int falling[EventList::largest];
    std::fill_n(falling, EventList::largest, -1);
    check(CVodeSetRootDirection(memory_, falling), "CVodeSetRootDirection");
  }
  /// The direction of sliding turns along the way; the branch stays.
  void follow(const Mode &mode) { mode_ = mode; }
  /// One internal step, not beyond `limit`. True when it ended at a root.
  bool step(double limit, double &t, State &y) {
    check(CVodeSetStopTime(memory_, limit), "CVodeSetStopTime");
    const int flag = CVode(memory_, limit, y_, &t, CV_ONE_STEP);
    check(flag, "CVode");
    std::copy_n(N_VGetArrayPointer(y_), y.size(), y.begin());
    return flag == CV_ROOT_RETURN;
  }
  Event root() const {
    int info[EventList::largest] = {};
    CVodeGetRootInfo(memory_, info);
    const auto events = dynamics_.events(mode_);
    for (int i = events.n - 1; i >= 0; --i) // turning stands first: a stop at the same instant goes before it
      if (info[i] != 0) return events.list[i];
    throw SolverStopped("CVODE reports a root without naming it");
  }
  State interpolate(double t) const {
    State y(dynamics_.n_state());
    N_Vector at = N_VMake_Serial(y.size(), y.begin(), context_);
    CVodeGetDky(memory_, t, 0, at);
    N_VDestroy(at);
    return y;
  }

private:
  static int rhs(double t, N_Vector y, N_Vector dy, void *self) {
    const auto &c = *static_cast<Cvode *>(self);
    State from(c.dynamics_.n_state()), to = from;
    std::copy_n(N_VGetArrayPointer(y), from.size(), from.begin());
    c.dynamics_.rhs(c.mode_, t, from, to);
    if (std::isnan(to[iX])) return 1; // recoverable: off the dish
    std::copy(to.begin(), to.end(), N_VGetArrayPointer(dy));
    return 0;
  }
  static int roots(double t, N_Vector y, double *values, void *self) {
    const auto &c = *static_cast<Cvode *>(self);
    State at(c.dynamics_.n_state());
    std::copy_n(N_VGetArrayPointer(y), at.size(), at.begin());
    for (const Event event : c.dynamics_.events(c.mode_)) *values++ = c.dynamics_.value(event, c.mode_, t, at);
    return 0;
  }
  void check(int flag, const char *what) const {
    if (flag < 0) throw SolverStopped(std::string(what) + " of SUNDIALS failed with " + CVodeGetReturnFlagName(flag));
  }

  const Dynamics &dynamics_;
  Mode mode_;
  SUNContext context_ = sundials_context();
  N_Vector y_, absolute_;
  SUNMatrix matrix_;
  SUNLinearSolver solver_;
  void *memory_;
};

double largest_step(const Dynamics &dynamics, const Mode &mode) {
  if (mode.rim == RimContact::open) return mode.support == Support::airborne ? 5e-3 : 0.02;
  return std::min(2e-3, std::numbers::pi * std::sqrt(dynamics.mass / dynamics.rim.stiffness) / 20);
}

/// Rest ends as for the own stepper: a scalar equation in time.
void rest(const Dynamics &dynamics, Mode &mode, double &t, State &y, double t_end, Recorder &recorder) {
  const double t1 = end_of_rest(dynamics, mode, y, t, t_end, 5e-3);
  recorder.segment(mode, {t, t1, y, y, [&](double) { return y; }}, false);
  t = t1;
  if (t1 >= t_end) return;
  const Mode before = mode;
  dynamics.release_from_rest(mode, t, y);
  recorder.branch(before, mode, t, y, 0);
}

} // namespace

bool run_with_cvode(const Dynamics &dynamics, const scene::Scene &scene, const BearingState &start, double t_end,
                    Recorder &recorder) {
  Cvode cvode(dynamics, std::min(scene.reduced.tolerance, 1e-9));
  State y;
  Mode mode = dynamics.starting_mode(start, y);
  double t = start.t;
  recorder.begin(mode, t, y);
  const auto &breaks = dynamics.ground.breakpoints();
  bool fresh = true;
  while (t < t_end - 1e-13) {
    if (dynamics.at_rest(mode)) {
      rest(dynamics, mode, t, y, t_end, recorder);
      fresh = true;
      continue;
    }
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), t + 1e-12);
    const double limit = next == breaks.end() ? t_end : std::min(*next, t_end);
    if (fresh) cvode.restart(mode, t, y, largest_step(dynamics, mode));
    if (dynamics.denting(mode)) {
      State rates(dynamics.n_state());
      dynamics.rhs(mode, t, y, rates);
      dynamics.begin_step(mode, t, y, rates);
      cvode.follow(mode);
    }
    const double t0 = t;
    const State y0 = y;
    const bool at_root = cvode.step(limit, t, y);
    recorder.steps.add(t);
    const Event event = at_root ? cvode.root() : Event::turning;
    const Mode during = mode; // with the direction the step began in
    dynamics.project(mode, y);
    recorder.segment(during, {t0, t, y0, y, [&](double at) { return cvode.interpolate(at); }},
                     at_root && changes_rim(event));
    if (event == Event::collapse) {
      recorder.end(mode, t, y);
      return true;
    }
    dynamics.arrive(mode, t, y);
    const Mode before = mode;
    double loss = 0;
    if (at_root) loss = dynamics.apply(event, mode, t, y);
    const bool slowed = event == Event::turning && dynamics.slow_down(mode, t, y);
    const bool changed = at_root || slowed;
    if (changed) recorder.branch(before, mode, t, y, loss);
    fresh = changed || t >= limit;
    cvode.follow(mode);
  }
  recorder.end(mode, t, y);
  return false;
}

} // namespace rimpact::reduced
