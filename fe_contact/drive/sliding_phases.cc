// Where the slider is, its rim joining and leaving the equations, and what an impact was.
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/sliding_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {

Eigen::VectorXd SlidingRun::displacements() const {
  Eigen::VectorXd u = active().expand(state_);
  if (!rim_is_solid() && held_.displacement.size()) u += held_.displacement;
  return u;
}

Eigen::Vector3d SlidingRun::travel() const {
  return active().top_of(state_.u) - Eigen::Vector3d(0, 0, rest_height_);
}

double SlidingRun::gap() const {
  return scene_.bearing.lateral_capacity() - travel().head<2>().norm();
}

double SlidingRun::surface_gap() const {
  return impact_.touched() ? active().wall_distance(state_, gap()) : gap();
}

double SlidingRun::closing_speed() const {
  const Eigen::Vector2d u = travel().head<2>(), v = active().top_of(state_.v).head<2>();
  return u.norm() > 0 ? v.dot(u.normalized()) : 0;
}

bool SlidingRun::touching() const {
  return active().walls_touch(state_);
}

void SlidingRun::join() {
  if (!all_solid()) state_ = joined_state(alone_, state_, held_, joined_);
  near_rim_ = true;
  impact_.forget();
}

void SlidingRun::part() {
  if (impact_.touched()) {
    record_.impacts.push_back(impact_.impact());
    write_fields();
  }
  next_step_ = motion_.contact_step;
  const double kinetic = joined_.kinetic_energy(state_);
  if (!all_solid()) state_ = parted_state(model_, joined_, state_, alone_, held_);
  near_rim_ = false;
  impact_.forget();
  if (all_solid()) return;
  const double left = alone_.kinetic_energy(state_);
  record_.ledger.impact += model_.share() * (kinetic - left); // the rim still rang
  record_.ledger.kinetic = model_.share() * left;
}

void SlidingRun::follow_impact(const SolvedStep &step) {
  const double force = active().force_of(state_, Role::wall).head<2>().norm();
  if (force <= 0) return;
  if (!impact_.touched()) impact_.begin(step.t, travel(), closing_before_);
  impact_.touch();
  impact_.follow(t_, force, -gap(), closing_speed());
  if (impact_.turns(closing_speed())) write_fields();
}

/// Once, at the first instant without a normal force: the landings that follow are most of the run.
void SlidingRun::report_lift() {
  constexpr double worth_it = 0.5; // left of the scene [s]
  if (reported_lift_ || !options_.remark || forces_of(active(), state_).normal > 0 || end_time() - t_ < worth_it)
    return;
  reported_lift_ = true;
  const bool damped = model_.options.pad_retardation > 0;
  options_.remark(fmt::format(
      "the slider leaves the dish at t = {:.3f} of {:g} s: it lands again every tenth of a second or so{}, and each "
      "landing takes about a hundred iterations; a shorter excitation.duration_s{} ends the run sooner",
      t_, end_time(), damped ? "" : ", undamped", damped ? "" : ", or a loss of the pad (bearing.pad.loss_factor),"));
}

} // namespace rimpact::fe
