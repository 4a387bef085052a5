#include "fe_contact/engine/contact_steps.h"

#include "fe_contact/solver/march.h"
#include <algorithm>
#include <cmath>
#include <string>

namespace rimpact::fe {
namespace {

constexpr double slow = 0.5;    ///< left after an augmentation over left before
constexpr double suffices = 10; ///< tolerances left, of which one augmentation mostly leaves less than one

/// Newton inside Uzawa's loop, from u; the system's trial then holds the solution.
ContactStepReport solve(ContactSystem &system, const SystemState &state, const StepTerms &terms,
                        const StepOptions &options, Eigen::VectorXd &u) {
  ContactStepReport report;
  system.prepare(state, terms);
  NewtonOptions newton_options = options.newton;
  if (options.max_augmentations > 0)
    newton_options.tolerance = std::max(options.newton.tolerance, options.tolerance_between);
  for (double worst = 0;;) {
    const NewtonReport newton_report = newton(system, u, newton_options);
    report.iterations += newton_report.iterations;
    report.residuals = newton_report.residuals;
    if (!newton_report.converged()) {
      report.reason = newton_report.reason();
      ++system.work.cuts;
      return report;
    }
    const double before = worst;
    const auto left = system.augmentation_residual();
    report.gap_left = left.gap;
    report.slip_left = left.slip;
    worst = std::max(left.gap / options.gap_tolerance, left.slip / options.slip_tolerance);
    const bool augmented = worst <= 1, capped = !augmented && report.augmentations >= options.max_augmentations;
    if ((augmented || capped) && newton_report.residuals.back() > options.newton.tolerance) {
      newton_options.tolerance = options.newton.tolerance; // now to the end
      newton_options.evaluated = true;
      continue;
    }
    newton_options.evaluated = false;
    if (augmented || capped) {
      report.capped = capped && options.max_augmentations > 0;
      break;
    }
    // Uzawa's loop is as slow as the penalty is soft beside the body: then the penalty grows (Bertsekas 1982).
    if (report.augmentations > 0 && worst > slow * before && system.stiffen(4)) report.stiffened = true;
    ++report.augmentations;
    ++system.work.augmentations;
    system.augment();
    if (worst <= suffices) newton_options.tolerance = options.newton.tolerance;
  }
  const int lost = system.lost_points();
  if (lost > 0)
    report.reason = std::to_string(lost) + " contact points moved past the faces opposite them within the step";
  report.converged = lost == 0;
  if (lost > 0) ++system.work.cuts;
  return report;
}

/// By how much the way of a mass that nothing stops at once grows or shrinks against its last one.
double change_of_pace(const SystemState &state, const RemoteFace &face, double dt) {
  constexpr double slowest = 0.5, fastest = 1.5; // beyond it turns, and says nothing of what is pushed
  const Eigen::Vector3d as_before = dt / state.last_dt * face.of(state.last_change),
                        now = dt * face.of(state.v) + 0.5 * dt * dt * face.of(state.a);
  const double squared = as_before.squaredNorm();
  return squared > 0 ? std::clamp(now.dot(as_before) / squared, slowest, fastest) : 1;
}

/// The last increment repeated: loading goes on mostly as it did, where the velocities ring from cell to cell. A mass
/// on top says at which pace. Smooth motion is continued by a parabola through the last three states.
Eigen::VectorXd first_guess(const SystemState &state, const StepTerms &terms, bool smooth) {
  const double dt = terms.dt;
  if (!(state.last_dt > 0)) return state.u + dt * state.v;
  const double pace = terms.remote ? change_of_pace(state, terms.remote->face, dt) : 1;
  const Eigen::VectorXd rate = pace * state.last_change / state.last_dt;
  if (!smooth || !(state.dt_before > 0)) return state.u + dt * rate;
  const Eigen::VectorXd bend = (rate - state.change_before / state.dt_before) / (state.last_dt + state.dt_before);
  return state.u + dt * (rate + (dt + state.last_dt) * bend);
}

/// Displacements are of a frame that rides on the ground: the scheme is of the absolute motion, so that its error is
/// that of the forces between the bodies, not of the shaking.
void follow_ground(Inertia &inertia, const ContactSystem &system, const GroundStep &ground) {
  const double dt = inertia.dt, beta = inertia.scheme.beta, gamma = inertia.scheme.gamma;
  inertia.u_predicted +=
      system.translation(dt * dt * ((0.5 - beta) * ground.a_old + beta * ground.a_new) - ground.displacement);
  inertia.v_predicted += system.translation(dt * ((1 - gamma) * ground.a_old + gamma * ground.a_new) - ground.velocity);
  inertia.a_old -= system.translation(ground.a_new - ground.a_old);
}

/// By the scheme's own formula, which is of the absolute motion: seen from a frame that goes on as the ground went at
/// the step's start, and taken back to the ground's frame. There the forces at the start drop out of it.
double integrator_loss(const ContactSystem &system, const StepTerms &terms, const GeneralizedAlpha &scheme,
                       const Eigen::VectorXd &du, const Eigen::VectorXd &da, const Eigen::VectorXd &R_old,
                       const SystemState &now) {
  if (!terms.ground) return scheme.loss(terms.dt, du, da, system.mass_times(da), R_old, now.R);
  const GroundStep &ground = *terms.ground;
  const Eigen::VectorXd du_absolute = du + system.translation(ground.displacement),
                        da_absolute = da + system.translation(ground.a_new - ground.a_old),
                        F = now.R + system.gravity(ground.a_new), carried = system.translation(ground.velocity),
                        momentum = system.mass_times(carried);
  return scheme.loss(terms.dt, du_absolute, da_absolute, system.mass_times(da_absolute), F, F) +
         0.5 * (R_old + now.R).dot(du) - F.dot(du_absolute) + momentum.dot(now.v + 0.5 * carried);
}

/// Of the multipliers' renewal that a step of this length takes.
double renewed_share(const StepOptions &options, double dt) {
  return options.renewal_time > 0 ? std::min(1.0, dt / options.renewal_time) : 1.0;
}

Renewal renewal(const StepOptions &options, const ContactStepReport &report, double share) {
  if (options.max_augmentations == 0) return {NextMultipliers::none};
  return {report.capped ? NextMultipliers::same : NextMultipliers::augmented, share};
}

} // namespace

ContactStepReport static_step(ContactSystem &system, SystemState &state, const StepTerms &terms,
                              const StepOptions &options, const Eigen::VectorXd &guess) {
  Eigen::VectorXd u = guess.size() ? guess : state.u;
  ContactStepReport report = solve(system, state, terms, options, u);
  if (report.converged) system.commit(u, state, renewal(options, report, 1));
  return report;
}

ContactStepReport time_step(ContactSystem &system, SystemState &state, const StepTerms &terms,
                            const StepOptions &options) {
  Inertia inertia(GeneralizedAlpha::from(options.rho_inf), terms.dt, state);
  if (terms.ground) follow_ground(inertia, system, *terms.ground);
  StepTerms in_time = terms;
  in_time.inertia = &inertia;
  const double share = renewed_share(options, terms.dt);
  if (options.expects && state.last_dt > 0) in_time.expected = share * terms.dt / state.last_dt;
  Eigen::VectorXd u = first_guess(state, terms, options.smooth);
  ContactStepReport report = solve(system, state, in_time, options, u);
  if (!report.converged) return report;
  report.multiplier = system.multiplier();
  const Eigen::VectorXd a = inertia.acceleration(u), du = u - state.u, da = a - state.a, R_old = state.R;
  system.commit(u, state, renewal(options, report, share));
  state.change_before = std::move(state.last_change);
  state.dt_before = state.last_dt;
  state.last_change = du;
  state.last_dt = terms.dt;
  state.v = inertia.velocity(a);
  state.a = a;
  report.integrator_loss = integrator_loss(system, terms, inertia.scheme, du, da, R_old, state);
  return report;
}

PreloadReport preload(ContactSystem &system, SystemState &state, const Eigen::VectorXd &load, double stiffness,
                      const StepOptions &options, double share) {
  constexpr double most_decades = 29;
  PreloadReport report;
  StepTerms terms{load};
  double springs = 10 * stiffness; // a decade before the first round's
  const auto weaken = [&](double, double decades) -> Attempt {
    terms.stabilisation = springs * std::pow(0.1, decades);
    const ContactStepReport step = static_step(system, state, terms, options);
    report.iterations += step.iterations;
    if (!step.converged) return {.reason = step.reason};
    springs = terms.stabilisation;
    report.stabilisation_share = system.stabilisation_share();
    return {.accepted = true, .reason = {}, .last = report.stabilisation_share < share};
  };
  const MarchReport weakened =
      march(-1, most_decades, {.first = 1, .smallest = 1.0 / 16, .largest = 1, .growth = 2}, weaken);
  report.rounds = weakened.steps;
  report.converged = report.stabilisation_share < share && weakened.finished;
  if (!weakened.finished)
    report.reason = weakened.reason;
  else if (!report.converged)
    report.reason = "the stabilising springs still carry " + std::to_string(report.stabilisation_share) +
                    " of the forces: contact does not hold the bodies";
  return report;
}

} // namespace rimpact::fe
