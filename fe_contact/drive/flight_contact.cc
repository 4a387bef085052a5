// A dynamic run of rung rim while slider and rim touch: from the first overlap to the parts at rest after the release.
#include "fe_contact/drive/flight_run.h"
#include "fe_contact/engine/solid_fields.h"

#include "files/error.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr double first_overlap = 1e-5;   ///< the first step moves the slider by this [m]
constexpr double smallest_pull = 1e-3;   ///< of the dish on the mass, over m g: lifted off beyond it
constexpr double deepest_landing = 1e-6; ///< the mass is back on the dish when it has sunk by this [m]
constexpr int checkpoint_every = 25;     ///< contact steps

} // namespace

MassForces FlightRun::forces_now(const Arc &arc, double t, double multiplier) const {
  return loads_.forces(arc.frame.displacement(top_of(arc)), arc.frame.to_global(top_speed_of(arc)), t, support_,
                       multiplier);
}

void FlightRun::begin_contact(Arc &arc) {
  lift_height_ = 0;
  if (support_ != Support::held) support_ = bearing_.airborne ? Support::airborne : Support::dish;
  const auto reduced = model_.forces(bearing_);
  multiplier_ = support_ == Support::dish
                    ? reduced.normal / std::hypot(1.0, model_.height(bearing_.u.x(), bearing_.u.y()).gradient.norm())
                    : 0;
  const MassForces now = loads_.forces(bearing_.u, bearing_.v, bearing_.t, support_, multiplier_);
  Eigen::Vector3d acceleration = now.total() / scene_.load.mass;
  if (support_ == Support::held) acceleration.z() = 0;
  arc.state.v.setZero();
  arc.state.a.setZero();
  system_.place(arc.state, arc.frame.master(bearing_.u), arc.frame.to_local(bearing_.v),
                arc.frame.to_local(acceleration));
  arc.state.R.setZero(); // the parts are at rest in themselves
  const Eigen::Vector3d on_top = arc.frame.to_local(now.total());
  for (int i = 0; i < 3; ++i)
    if (const int equation = system_.top().equation[i]; equation >= 0)
      arc.state.R[equation] = on_top[i] / system_.model().share();
  const Eigen::Vector2d radial = bearing_.u.head<2>().normalized();
  impact_ = {
      bearing_.t, bearing_.t, std::atan2(radial.y(), radial.x()) * 180 / M_PI, bearing_.v.head<2>().dot(radial), 0,
      0,          0};
  others_elastic_ = record_.ledger.elastic - system_.model().share() * arc.state.energies.elastic;
  others_plastic_ = record_.ledger.plastic - system_.model().share() * arc.state.energies.plastic;
  touched_ = false;
  peak_written_ = false;
  dt_ = std::min(0.25 * plan_.step_in_contact, first_overlap / std::max(1e-3, impact_.approach_speed));
  in_contact_ = true;
  if (record_.response.size() == 0) sample(arc, 0, now, 0); // a window starts here
}

void FlightRun::contact() {
  Arc &arc = touched_arc();
  if (!in_contact_) begin_contact(arc);
  const double longest = plan_.step_in_contact;
  const MarchReport report = march(bearing_.t, end_time(), {dt_, longest / 4096, longest},
                                   [&](double t, double dt) { return attempt(arc, t, dt); });
  record_.n_cuts += report.cuts;
  if (report.finished) return;
  save();
  throw SolverStopped(fmt::format(
      "the solver stopped at t = {:.6f} s, in contact, with a step of {:.3g} us: {}; partial results are kept; try "
      "--set model.mesh=2 or a smaller model.step_ms and --resume",
      report.reached, 1e6 * dt_, report.reason));
}

Attempt FlightRun::attempt(Arc &arc, double t, double dt) {
  if (is_interrupted(options_)) {
    dt_ = dt;
    save();
    throw Interrupted();
  }
  const MassForces before = forces_now(arc, t, multiplier_);
  const SystemState kept = arc.state;
  StepTerms terms{Eigen::VectorXd::Zero(system_.equations().n)};
  terms.dt = dt;
  const RemoteTerms remote{system_.top(), loads_.law(arc.frame, t + dt, support_), system_.model().share(),
                           multiplier_};
  terms.remote = &remote;
  const ContactStepReport report = time_step(system_, arc.state, terms, step_options_);
  dt_ = dt / 2;
  if (!report.converged) return {false, dt_, report.reason};
  const double finest = plan_.step_in_contact / 32;
  const MassForces after = forces_now(arc, t + dt, report.multiplier);
  const FlightStep step{system_, arc.frame, kept, arc.state, before, after, report.integrator_loss};
  if (!event_is_sharp(arc, report, dt, finest) || !error_is_small(step, dt)) {
    arc.state = kept;
    ++system_.work.cuts;
    return {false, dt_, "the step's error is too large"};
  }
  accept(arc, step, report, dt);
  const bool ended = after_step(arc, report);
  if (!ended && record_.n_steps - steps_kept_ >= checkpoint_every) save();
  return {true, dt_, {}, ended};
}

bool FlightRun::after_step(Arc &arc, const ContactStepReport &report) {
  if (lifts_off(report)) {
    support_ = Support::airborne;
    multiplier_ = 0;
    lift_height_ = std::min(0.0, height_above_dish(arc));
  } else if (lands(arc)) {
    land(arc);
  }
  const bool bears = arc.state.bearing_points() > 0;
  if (bears) touched_ = true;
  const double radial_speed = top_speed_of(arc).x();
  refuse_passage(radial_speed, bears);
  if (bears || (!touched_ && radial_speed >= 0)) return false;
  end_contact(arc);
  return true;
}

void FlightRun::refuse_passage(double outward_speed, bool bears) {
  const Passage passage{.depth = bearing_.u.head<2>().norm() - capacity(),
                        .outward_speed = outward_speed,
                        .approach_speed = impact_.approach_speed,
                        .let_go = touched_ && !bears,
                        .may_touch = !window()};
  const auto sentence = passes(scene_.bearing.rim, passage, bearing_.t);
  if (!sentence) return;
  save();
  record_.impacts.push_back(left_open(impact_)); // the force may be nil at this instant, so the response does not tell
  throw SolverStopped(*sentence);
}

bool FlightRun::lifts_off(const ContactStepReport &report) const {
  return support_ == Support::dish && report.multiplier < -smallest_pull * scene_.load.mass * scene_.load.gravity;
}

bool FlightRun::lands(const Arc &arc) const {
  return support_ == Support::airborne && height_above_dish(arc) < lift_height_ - deepest_landing;
}

double FlightRun::height_above_dish(const Arc &arc) const {
  return loads_.height_above_dish(arc.frame.displacement(top_of(arc)));
}

bool FlightRun::event_is_sharp(const Arc &arc, const ContactStepReport &report, double dt, double finest) {
  const bool release = touched_ && arc.state.bearing_points() == 0;
  if ((!lifts_off(report) && !lands(arc) && !release) || dt <= finest) return true;
  dt_ = dt / 4;
  return false;
}

bool FlightRun::error_is_small(const FlightStep &step, double dt) {
  constexpr double displacement_tolerance = 2e-6; // [m] a step
  constexpr double energy_tolerance = 1.5e-5;     // of the largest input, a step
  const double displacement = step.displacement_error(scene_.model.rho_inf, dt) / displacement_tolerance;
  const double energy = std::abs(step.unbalanced()) / (energy_tolerance * std::max(1.0, record_.ledger.largest_input));
  const double error = std::max(displacement, energy);
  if (error > 4 && dt > plan_.step_in_contact / 32) {
    dt_ = dt * std::clamp(0.8 / std::cbrt(error), 0.25, 0.7);
    return false;
  }
  dt_ = std::min(plan_.step_in_contact, dt * std::clamp(0.9 / std::cbrt(std::max(error, 1e-3)), 0.5, 1.6));
  return true;
}

void FlightRun::accept(Arc &arc, const FlightStep &step, const ContactStepReport &report, double dt) {
  ++record_.n_steps;
  record_.augmentation_caps += report.capped;
  bearing_.t += dt;
  multiplier_ = report.multiplier;
  const double share = system_.model().share();
  auto &ledger = record_.ledger;
  ledger.external += step.work(step.before.ground, step.after.ground);
  ledger.gravity -= step.work(step.before.weight, step.after.weight);
  ledger.friction -= step.work(step.before.friction, step.after.friction);
  ledger.elastic = others_elastic_ + system_.model().share() * arc.state.energies.elastic;
  ledger.plastic = others_plastic_ + system_.model().share() * arc.state.energies.plastic;
  ledger.contact += share * wall_of(arc).normal_work;
  ledger.friction += share * wall_of(arc).friction_work;
  ledger.integrator += share * report.integrator_loss;
  ledger.kinetic = share * system_.kinetic_energy(arc.state);
  ledger.largest_input = std::max(ledger.largest_input, ledger.initial + std::abs(ledger.external));
  bearing_.u = arc.frame.displacement(top_of(arc));
  bearing_.v = arc.frame.to_global(top_speed_of(arc));
  sample(arc, report.iterations, step.after, dt);

  const double force = system_.force_of(arc.state, Role::wall).head<2>().norm();
  impact_.peak_force = std::max(impact_.peak_force, force);
  impact_.peak_penetration = std::max(impact_.peak_penetration, bearing_.u.head<2>().norm() - capacity());
  if (force > 0) impact_.release_time = bearing_.t;
  if (!peak_written_ && touched_ && top_speed_of(arc).x() < 0) {
    write_fields(arc);
    peak_written_ = true;
  } else if (touched_ && fields_due(bearing_.t, dt, options_)) {
    write_fields(arc);
  }
  if (options_.progress)
    options_.progress({bearing_.t, end_time(), dt, report.iterations, capacity() - bearing_.u.head<2>().norm(), force,
                       Phase::contact});
}

void FlightRun::land(Arc &arc) {
  const Eigen::Vector3d n = loads_.normal(bearing_.u);
  const double approach = bearing_.v.dot(n);
  support_ = Support::dish;
  if (approach >= 0) return;
  const double before = record_.ledger.kinetic;
  system_.kick(arc.state, arc.frame.to_local(-(1 + scene_.reduced.vertical_restitution) * approach * n));
  record_.ledger.kinetic = system_.model().share() * system_.kinetic_energy(arc.state);
  record_.ledger.contact += before - record_.ledger.kinetic;
  bearing_.v = arc.frame.to_global(top_speed_of(arc));
}

void FlightRun::end_contact(Arc &arc) {
  impact_.rebound_speed = -radial_speed();
  const double strained = system_.model().share() * (arc.state.energies.elastic + arc.state.energies.plastic);
  const double moving =
      system_.model().share() * system_.kinetic_energy(arc.state) - system_.rigid_kinetic_energy(top_speed_of(arc));
  const Eigen::Vector3d speed = top_speed_of(arc);
  const ContactStepReport report = system_.relax(arc.state, step_options_);
  if (!report.converged) throw SolverStopped("the parts did not come to rest after the release: " + report.reason);
  record_.ledger.elastic = others_elastic_ + system_.model().share() * arc.state.energies.elastic;
  record_.ledger.plastic = others_plastic_ + system_.model().share() * arc.state.energies.plastic;
  record_.ledger.impact +=
      moving + strained - system_.model().share() * (arc.state.energies.elastic + arc.state.energies.plastic);
  record_.ledger.kinetic = system_.rigid_kinetic_energy(speed);
  arc.yielded = largest_plastic_strain(arc.state.history) > 0;
  bearing_.airborne = support_ == Support::airborne;
  const double dish = model_.height(bearing_.u.x(), bearing_.u.y()).z; // the height may have drifted by microns
  if (support_ != Support::held) bearing_.u.z() = support_ == Support::dish ? dish : std::max(dish, bearing_.u.z());
  if (touched_) {
    record_.impacts.push_back(impact_);
    write_fields(arc);
  }
  in_contact_ = false;
  save();
}

} // namespace rimpact::fe
