#include "fe_contact/drive/sliding_pace.h"

#include <algorithm>

namespace rimpact::fe {
namespace {

constexpr double turning_step = 1e-4; // the slider turns round in steps of this [s]

} // namespace

/// Where the slider turns round its friction does, and a step takes it as it is at the step's end: by up to a step's
/// length too early, an impulse of 2 mu N dt. So steps shrink with the time to (and since) the turn; a slider that
/// hardly accelerates has none.
double SlidingPace::longest_at_turn(const SlidingStack &stack) const {
  constexpr double at_rest = 0.3, share = 0.95; // [m/s^2]; of that time
  const double speed = stack.velocity().head<2>().norm(), rate = stack.acceleration().head<2>().norm();
  return rate > at_rest ? std::max(turning_step, share * speed / rate) : longest_sliding_step;
}

bool SlidingPace::rests_at(double t, const SlidingStack &stack) const {
  const bool scout_rests = t < plan_.moves_from || (plan_.rests_from > 0 && t > plan_.rests_from);
  return scout_rests && stack.velocity().head<2>().norm() < sliding_speed;
}

double SlidingPace::longest(const SlidingStack &stack, bool resting) const {
  if (stack.near_rim) return plan_.step_in_contact;
  return resting ? planning::longest_resting_step : longest_sliding_step;
}

double SlidingPace::clipped(double t, double dt, const SlidingStack &stack, bool resting, double surface_gap) const {
  constexpr double sliver = 1e-6; // [s]
  if (const double left = plan_.moves_from - t; resting && left > sliver && dt > left + sliver) return left;
  if (const double longest = longest_at_turn(stack); !stack.near_rim && !resting && dt > 1.001 * longest)
    return longest;
  const double closing = stack.closing_speed();
  if (closing <= 0 || stack.touching()) return 0;
  const double left = stack.near_rim ? surface_gap : stack.gap() - 0.9 * joining_gap, until = left / closing;
  if (until >= dt) return 0;
  if (!stack.near_rim) return until > 1e-4 * dt ? until : 0;
  if (until > contact_step_) return until;
  return dt > 1.001 * contact_step_ ? contact_step_ : 0;
}

} // namespace rimpact::fe
