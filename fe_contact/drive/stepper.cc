#include "fe_contact/drive/stepper.h"

#include "fe_contact/drive/step_control.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {

MarchReport Stepper::march_to(double start, double end, const StepLimits &limits) {
  return march(start, end, limits, [this](double t, double dt) { return attempt(t, dt); });
}

Attempt Stepper::attempt(double t, double dt) {
  constexpr int steps_without_growth = 3; // after one that did not converge: growth alone led there
  prepare(t, dt);
  if (const double shorter = clipped(t, dt); shorter > 0) return {false, shorter, "the step would pass an event"};
  const SystemState before = state();
  const ContactStepReport report = solve(t, dt);
  if (!report.converged) {
    state() = before;
    state().growth_hold = steps_without_growth;
    return {false, 0, report.reason};
  }
  const SolvedStep step{t, dt, before, report};
  const std::vector<Event> now = events(step);
  if (const double sharp = sharp_step(now); sharp > 0 && dt > sharp)
    return refuse(before, {false, dt / 4, "an event falls into the step"});
  Attempt result = assess(step);
  if (!result.accepted) return refuse(before, result);
  state().growth_hold = std::max(0, state().growth_hold - 1);
  accept(step);
  state().refused_error = 0;
  result.last = take(now);
  if (!result.last) keep(result.suggested_step);
  return result;
}

Attempt Stepper::refuse(const SystemState &before, Attempt cut) {
  state() = before;
  if (cut.error > 0 && std::isfinite(cut.error)) state().refused_error = std::min(cut.error, most_refused_error);
  ++system().work.cuts;
  return cut;
}

} // namespace rimpact::fe
