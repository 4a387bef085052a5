// A run in time: steps clipped to the predicted touch and cut by their energy error, with its ledger.
#include "fe_contact/engine/contact_steps.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {
namespace {

constexpr int patience = 6;   ///< of Newton, where the step may be cut
constexpr int calm_steps = 3; ///< do not grow after one that Newton could not take: growth alone led there

struct Run {
  ContactSystem &system;
  SystemState &state;
  const std::function<Eigen::VectorXd(double)> &load;
  const TransientOptions &options;
  const AfterStep &after_step;
  TransientReport report{};

  Attempt attempt(double t, double dt);
};

Attempt Run::attempt(double t, double dt) {
  const bool was_in_contact = state.bearing_points() > 0;
  const double until_touch = was_in_contact ? 0 : system.time_to_touch(state);
  // Arrive at the touch, then go on with the short step.
  if (!was_in_contact && until_touch < dt && until_touch > 1e-3 * options.contact_step &&
      dt > 1.001 * options.smallest_step)
    return {false, std::max(until_touch * (1 + 1e-9), options.smallest_step), "the walls are about to touch"};
  if (!was_in_contact && until_touch < dt && dt > 1.001 * options.contact_step)
    return {false, options.contact_step, "the walls touch"};
  return checked_step(system, state, t, dt, load, options, report, after_step);
}

} // namespace

Attempt checked_step(ContactSystem &system, SystemState &state, double t, double dt,
                     const std::function<Eigen::VectorXd(double)> &load, const TransientOptions &options,
                     TransientReport &report, const AfterStep &after_step) {
  const SystemState kept = state;
  StepTerms terms{load(t + dt)};
  terms.dt = dt;
  if (options.ground) terms.ground = options.ground(t, dt);
  const Eigen::VectorXd load_before = load(t);
  StepOptions step_options = options.step;
  const bool may_be_cut = dt > 1.001 * options.smallest_step;
  step_options.newton.patience = may_be_cut ? patience : 0;
  if (t == 0) step_options.rho_inf = 1; // the first, shortest step: its end's accelerations balance the forces
  const ContactStepReport step = time_step(system, state, terms, step_options);
  report.iterations += step.iterations;
  if (!step.converged) {
    state = kept;
    state.calm = calm_steps;
    return {false, 0, step.reason};
  }
  const double external = 0.5 * (load_before + terms.load).dot(state.u - kept.u);
  const double kinetic = system.kinetic_energy(state);
  double friction = 0, contact = 0;
  for (const auto &r : state.reports) {
    friction += r.friction_work;
    contact += r.normal_work;
  }
  auto &ledger = report.ledger;
  const double unbalanced = external - (kinetic - ledger.kinetic) - (state.energies.elastic - ledger.elastic) -
                            (state.energies.plastic - ledger.plastic) - friction - contact - step.integrator_loss;
  const double largest =
      std::max({ledger.largest, std::abs(ledger.initial + ledger.external + external), kinetic, 1e-300});
  // A loss is the integrator's damping of waves the step cannot resolve; a gain is an error.
  const double error = std::abs(unbalanced) / (options.energy_tolerance * largest) +
                       std::max(0.0, -step.integrator_loss) / (options.gain_tolerance * largest);
  // Halving buys a factor of about eight; the smallest step is taken whatever its error, and the ledger shows it.
  if (error > 1 && may_be_cut) {
    state = kept;
    ++system.work.cuts;
    return {false, dt * std::clamp(0.8 / std::cbrt(error), 0.2, 0.7), "the step's energy error is too large"};
  }
  ledger.external += external;
  ledger.kinetic = kinetic;
  ledger.elastic = state.energies.elastic;
  ledger.plastic = state.energies.plastic;
  ledger.friction += friction;
  ledger.contact += contact;
  ledger.integrator += step.integrator_loss;
  ledger.largest = largest;
  report.capped_steps += step.capped;
  const double growth = state.calm > 0 ? 1.0 : 2.0;
  state.calm = std::max(0, state.calm - 1);
  after_step(t + dt, state, step);
  const double next = dt * std::clamp(0.9 / std::cbrt(std::max(error, 1e-3)), 0.5, growth);
  if (options.after_point) options.after_point({t + dt, next, ledger});
  return {true, next, {}};
}

double SystemLedger::imbalance() const {
  const double left = initial + external - kinetic - elastic - plastic - friction - contact - integrator;
  return largest > 0 ? std::abs(left) / largest : 0.0;
}

TransientReport run_in_time(ContactSystem &system, SystemState &state, double end,
                            const std::function<Eigen::VectorXd(double)> &load, const TransientOptions &options,
                            const AfterStep &after_step) {
  Run run{system, state, load, options, after_step};
  auto &ledger = run.report.ledger;
  if (options.from.t > 0) {
    ledger = options.from.ledger;
  } else {
    ledger.kinetic = system.kinetic_energy(state);
    ledger.elastic = state.energies.elastic;
    ledger.plastic = state.energies.plastic;
    ledger.initial = ledger.largest = ledger.kinetic + ledger.elastic + ledger.plastic;
  }
  const double first = options.from.next_step > 0 ? options.from.next_step : options.smallest_step;
  run.report.march = march(options.from.t, end, {first, options.smallest_step, options.largest_step},
                           [&](double t, double dt) { return run.attempt(t, dt); });
  return run.report;
}

} // namespace rimpact::fe
