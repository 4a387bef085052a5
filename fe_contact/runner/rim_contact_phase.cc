// A dynamic run of rung R1 while slider and rim touch: from the first overlap to the parts at rest after the release.
#include "fe_contact/runner/rim_dynamic.h"

#include "scene/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr double first_overlap = 1e-5;  ///< the first step moves the slider by this [m]
constexpr double smallest_pull = 1e-3;   ///< of the dish on the mass, over m g: lifted off beyond it
constexpr double deepest_landing = 1e-6; ///< the mass is back on the dish when it has sunk by this [m]
constexpr int checkpoint_every = 25;   ///< contact steps
constexpr double passing_share = 0.01; ///< of the approach speed, outwards at release: not a rebound
constexpr double chatter_depth = 1e-4; ///< nearer to L_c than this the walls may only have parted for an instant [m]

} // namespace

MassForces DynamicRun::forces_now(const Arc &arc, double t) const {
  return loads_.forces(arc.frame.displacement(arc.state.master),
                       arc.frame.to_global(arc.state.master_velocity), t, support_, multiplier_);
}

void DynamicRun::begin_contact(Arc &arc) {
  lift_height_ = 0;
  if (support_ != Support::held) support_ = bearing_.airborne ? Support::airborne : Support::dish;
  const auto reduced = model_.forces(bearing_);
  multiplier_ =
      support_ == Support::dish
          ? reduced.normal / std::hypot(1.0, model_.height(bearing_.u.x(), bearing_.u.y()).gradient.norm())
          : 0;
  const MassForces now = loads_.forces(bearing_.u, bearing_.v, bearing_.t, support_, multiplier_);
  Eigen::Vector3d acceleration = now.total() / scene_.load.mass;
  if (support_ == Support::held) acceleration.z() = 0;
  arc.state.v.setZero();
  arc.state.a.setZero();
  arc.state.R.setZero();
  solver_.place(arc.state, arc.frame.master(bearing_.u), arc.frame.to_local(bearing_.v),
                arc.frame.to_local(acceleration));
  solver_.refresh_forces(arc.state, loads_.law(arc.frame, bearing_.t, support_), multiplier_);
  const Eigen::Vector2d radial = bearing_.u.head<2>().normalized();
  impact_ = {bearing_.t,
             bearing_.t,
             std::atan2(radial.y(), radial.x()) * 180 / M_PI,
             bearing_.v.head<2>().dot(radial),
             0,
             0,
             0};
  others_elastic_ = record_.ledger.elastic - solver_.share() * arc.state.energies.elastic;
  others_plastic_ = record_.ledger.plastic - solver_.share() * arc.state.energies.plastic;
  touched_ = false;
  peak_written_ = false;
  dt_ = std::min(0.25 * plan_.step_in_contact, first_overlap / std::max(1e-3, impact_.approach_speed));
  in_contact_ = true;
  if (record_.response.size() == 0) sample(arc, {}, now, 0); // a window starts here
}

void DynamicRun::contact() {
  Arc &arc = touched_arc();
  if (!in_contact_) begin_contact(arc);
  for (int steps = 0; in_contact_; ++steps) {
    if (is_interrupted(options_)) {
      save();
      throw Interrupted();
    }
    if (bearing_.t >= end_time() - 1e-12) break;
    step(arc);
    if (steps % checkpoint_every == checkpoint_every - 1) save();
  }
}

void DynamicRun::step(Arc &arc) {
  const double dt = std::min(dt_, end_time() - bearing_.t);
  const MassForces before = forces_now(arc, bearing_.t);
  const ArcState kept = arc.state;
  const auto law = loads_.law(arc.frame, bearing_.t + dt, support_);
  const StepReport report = solver_.step(arc.state, dt, law, multiplier_);
  record_.n_newton += report.iterations;
  if (!report.converged) {
    ++record_.n_cuts;
    dt_ = dt / 2;
    if (dt_ < plan_.step_in_contact / 4096) {
      save();
      throw SolverStopped(
          "the solver stopped at t = " + std::to_string(bearing_.t) + " s, in contact, with a step of " +
          std::to_string(1e6 * dt) + " us: " + report.reason +
          "; partial results are kept; try --set model.mesh=2 or a smaller model.step_ms and --resume");
    }
    return;
  }
  const double finest = plan_.step_in_contact / 32;
  if (!event_is_sharp(arc, report, dt, finest) || !error_is_small(arc, kept, before, report, dt)) {
    arc.state = kept;
    return;
  }
  accept(arc, kept, before, report, dt);
  if (lifts_off(report)) {
    support_ = Support::airborne;
    multiplier_ = 0;
    lift_height_ = std::min(0.0, height_above_dish(arc));
  } else if (lands(arc)) {
    land(arc);
  }
  if (arc.state.report.active > 0) touched_ = true;
  const double radial_speed = arc.state.master_velocity.x();
  if (arc.state.report.active != 0 || (!touched_ && radial_speed >= 0)) return;
  refuse_passage(radial_speed);
  end_contact(arc);
}

void DynamicRun::refuse_passage(double outward_speed) {
  const double depth = bearing_.u.head<2>().norm() - capacity();
  // In a history walls may part for an instant at first touch, the slider still coming on: it is touched again.
  if (!touched_ || outward_speed <= passing_share * impact_.approach_speed || (!window() && depth < chatter_depth)) return;
  save();
  throw SolverStopped(fmt::format(
      "the rim let go of the slider at t = {:.5g} s, {:.2f} mm beyond L_c, while it still moves outwards at {:.3g} m/s: it passes through or over "
      "the rim (height {:g} mm, thickness {:g} mm), which this model does not follow; nothing after the touch is a result for this impact of {:.3g} m/s",
      bearing_.t, 1e3 * depth, outward_speed, 1e3 * scene_.bearing.rim.height, 1e3 * scene_.bearing.rim.thickness, impact_.approach_speed));
}

bool DynamicRun::lifts_off(const StepReport &report) const {
  return support_ == Support::dish && report.multiplier < -smallest_pull * scene_.load.mass * scene_.load.gravity;
}

bool DynamicRun::lands(const Arc &arc) const {
  return support_ == Support::airborne && height_above_dish(arc) < lift_height_ - deepest_landing;
}

double DynamicRun::height_above_dish(const Arc &arc) const {
  return loads_.height_above_dish(arc.frame.displacement(arc.state.master));
}

bool DynamicRun::event_is_sharp(const Arc &arc, const StepReport &report, double dt, double finest) {
  const bool release = touched_ && arc.state.report.active == 0;
  if ((!lifts_off(report) && !lands(arc) && !release) || dt <= finest) return true;
  dt_ = dt / 4;
  return false;
}

bool DynamicRun::error_is_small(const Arc &arc, const ArcState &kept, const MassForces &before,
                                const StepReport &report, double dt) {
  constexpr double displacement_tolerance = 2e-6; // [m] a step
  constexpr double energy_tolerance = 1.5e-5;     // of the largest input, a step
  const auto scheme = GeneralizedAlpha::from(scene_.model.rho_inf);
  const double change = solver_.master_acceleration(arc.state).x() - solver_.master_acceleration(kept).x();
  const double displacement =
      std::abs(scheme.beta - 1.0 / 6) * dt * dt * std::abs(change) / displacement_tolerance;
  // What the step leaves unbalanced: the trapezoidal work of the forces against the change of energy.
  const MassForces after =
      loads_.forces(arc.frame.displacement(arc.state.master), arc.frame.to_global(arc.state.master_velocity),
                    bearing_.t + dt, support_, report.multiplier);
  const Eigen::Vector3d du = arc.frame.displacement(arc.state.master) - arc.frame.displacement(kept.master);
  const double stored = solver_.share() * (arc.state.energies.elastic + arc.state.energies.plastic -
                                           kept.energies.elastic - kept.energies.plastic);
  const double unbalanced = 0.5 * (before.total() + after.total()).dot(du) -
                            (solver_.kinetic_energy(arc.state) - solver_.kinetic_energy(kept) + stored +
                             report.contact_work + report.integrator_loss);
  const double energy =
      std::abs(unbalanced) / (energy_tolerance * std::max(1.0, record_.ledger.largest_input));
  const double error = std::max(displacement, energy);
  if (error > 4 && dt > plan_.step_in_contact / 32) {
    dt_ = dt * std::clamp(0.8 / std::cbrt(error), 0.25, 0.7);
    return false;
  }
  dt_ = std::min(plan_.step_in_contact, dt * std::clamp(0.9 / std::cbrt(std::max(error, 1e-3)), 0.5, 1.6));
  return true;
}

void DynamicRun::accept(Arc &arc, const ArcState &kept, const MassForces &before, const StepReport &report,
                        double dt) {
  ++record_.n_steps;
  if (report.augmentations >= solver_.options().max_augmentations) ++record_.augmentation_caps;
  bearing_.t += dt;
  multiplier_ = report.multiplier;
  const MassForces after = forces_now(arc, bearing_.t);
  const Eigen::Vector3d u0 = arc.frame.displacement(kept.master),
                        u1 = arc.frame.displacement(arc.state.master), du = u1 - u0;
  auto &ledger = record_.ledger;
  ledger.external += 0.5 * (before.ground + after.ground).dot(du);
  ledger.gravity -= 0.5 * (before.weight + after.weight).dot(du);
  ledger.friction -= 0.5 * (before.friction + after.friction).dot(du);
  ledger.elastic = others_elastic_ + solver_.share() * arc.state.energies.elastic;
  ledger.plastic = others_plastic_ + solver_.share() * arc.state.energies.plastic;
  ledger.contact += report.contact_work;
  ledger.integrator += report.integrator_loss;
  ledger.kinetic = solver_.kinetic_energy(arc.state);
  ledger.largest_input = std::max(ledger.largest_input, ledger.initial + std::abs(ledger.external));
  bearing_.u = u1;
  bearing_.v = arc.frame.to_global(arc.state.master_velocity);
  sample(arc, report, after, dt);

  const double force = report.rim_force.head<2>().norm();
  impact_.peak_force = std::max(impact_.peak_force, force);
  impact_.peak_penetration = std::max(impact_.peak_penetration, bearing_.u.head<2>().norm() - capacity());
  if (force > 0) impact_.release_time = bearing_.t;
  if (!peak_written_ && touched_ && arc.state.master_velocity.x() < 0) {
    write_fields(solver_, arc.state, arc.frame, bearing_.t, options_, record_);
    peak_written_ = true;
  }
  if (options_.progress)
    options_.progress(
        {bearing_.t, end_time(), dt, report.iterations, capacity() - bearing_.u.head<2>().norm(), force, "contact"});
}

void DynamicRun::land(Arc &arc) {
  const Eigen::Vector3d n = loads_.normal(bearing_.u);
  const double approach = bearing_.v.dot(n);
  support_ = Support::dish;
  if (approach >= 0) return;
  const double before = solver_.kinetic_energy(arc.state);
  solver_.kick(arc.state, arc.frame.to_local(-(1 + scene_.reduced.vertical_restitution) * approach * n));
  record_.ledger.kinetic = solver_.kinetic_energy(arc.state);
  record_.ledger.contact += before - record_.ledger.kinetic;
  bearing_.v = arc.frame.to_global(arc.state.master_velocity);
}

void DynamicRun::end_contact(Arc &arc) {
  impact_.rebound_speed = -radial_speed();
  const double strained = solver_.share() * (arc.state.energies.elastic + arc.state.energies.plastic);
  const double moving =
      solver_.kinetic_energy(arc.state) - solver_.rigid_kinetic_energy(arc.state.master_velocity);
  const StepReport report = solver_.relax(arc.state);
  record_.n_newton += report.iterations;
  if (!report.converged)
    throw SolverStopped("the parts did not come to rest after the release: " + report.reason);
  record_.ledger.elastic = others_elastic_ + solver_.share() * arc.state.energies.elastic;
  record_.ledger.plastic = others_plastic_ + solver_.share() * arc.state.energies.plastic;
  record_.ledger.impact +=
      moving + strained - solver_.share() * (arc.state.energies.elastic + arc.state.energies.plastic);
  record_.ledger.kinetic = solver_.rigid_kinetic_energy(arc.state.master_velocity);
  arc.yielded = solver_.largest_plastic_strain(arc.state) > 0;
  bearing_.airborne = support_ == Support::airborne;
  const double dish = model_.height(bearing_.u.x(), bearing_.u.y()).z; // the height may have drifted by microns
  if (support_ != Support::held) bearing_.u.z() = support_ == Support::dish ? dish : std::max(dish, bearing_.u.z());
  if (touched_) {
    record_.impacts.push_back(impact_);
    write_fields(solver_, arc.state, arc.frame, bearing_.t, options_, record_);
  }
  in_contact_ = false;
  save();
}

} // namespace rimpact::fe
