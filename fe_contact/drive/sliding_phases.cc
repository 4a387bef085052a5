// Where the slider is, its rim joining and leaving the equations, what an impact was, and the ledger over all of it.
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
  return touched_ ? active().wall_distance(state_, gap()) : gap();
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
  touched_ = peak_written_ = false;
  report_.ledger.elastic = state_.energies.elastic;
  report_.ledger.plastic = state_.energies.plastic;
}

void SlidingRun::part() {
  if (touched_) {
    record_.impacts.push_back(impact_);
    write_fields();
  }
  next_step_ = transient_.contact_step;
  if (all_solid()) {
    near_rim_ = touched_ = false;
    return;
  }
  const double kinetic = joined_.kinetic_energy(state_);
  state_ = parted_state(model_, joined_, state_, alone_, held_);
  near_rim_ = touched_ = false;
  auto &ledger = report_.ledger;
  ledger.elastic = state_.energies.elastic;
  ledger.plastic = state_.energies.plastic;
  ledger.kinetic = alone_.kinetic_energy(state_);
  record_.ledger.impact += model_.share() * (kinetic - ledger.kinetic); // the rim still rang
  record_.ledger.kinetic = model_.share() * ledger.kinetic;
}

void SlidingRun::follow_impact(double t, double dt) {
  const double force = active().force_of(state_, Role::wall).head<2>().norm();
  if (force <= 0) return;
  const Eigen::Vector3d u = travel();
  if (!touched_) impact_ = {t - dt, t, std::atan2(u.y(), u.x()) * 180 / M_PI, closing_before_, 0, 0, 0};
  touched_ = true;
  impact_.release_time = t;
  impact_.rebound_speed = -closing_speed();
  impact_.peak_force = std::max(impact_.peak_force, force);
  impact_.peak_penetration = std::max(impact_.peak_penetration, -gap());
  if (peak_written_ || closing_speed() > 0) return;
  peak_written_ = true;
  write_fields();
}

/// Once, at the first instant without a normal force: the landings that follow are most of the run.
void SlidingRun::tell_lift() {
  constexpr double worth_it = 0.5; // left of the scene [s]
  if (told_lift_ || !options_.remark || forces_of(active(), state_).normal > 0 || end_time() - t_ < worth_it) return;
  told_lift_ = true;
  options_.remark(fmt::format(
      "the slider leaves the dish at t = {:.3f} of {:g} s: it lands again every tenth of a second or so, undamped, and "
      "each landing takes about a hundred iterations; a shorter excitation.duration_s ends the run sooner",
      t_, end_time()));
}

/// The model's ledger of the step becomes the whole bearing's.
void SlidingRun::account() {
  auto &ledger = record_.ledger;
  const auto &model = report_.ledger;
  const double share = model_.share();
  const double weight = -scene_.load.vertical * (travel().z() - height_before_); // work of the dead load
  ledger.external += share * (model.external - external_before_) - weight;
  ledger.gravity -= weight;
  ledger.kinetic = share * model.kinetic;
  ledger.elastic = share * (model.elastic + (rim_is_solid() ? 0 : held_.energies.elastic)) - rest_elastic_;
  ledger.plastic = share * (model.plastic + (rim_is_solid() ? 0 : held_.energies.plastic)) - rest_plastic_;
  ledger.friction = share * model.friction;
  ledger.contact = share * model.contact;
  ledger.integrator = share * model.integrator;
  ledger.largest_input = std::max(ledger.largest_input, ledger.initial + std::abs(ledger.external));
  external_before_ = model.external;
  height_before_ = travel().z();
}

} // namespace rimpact::fe
