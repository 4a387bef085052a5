#include "fe_contact/drive/motion.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

double EnergyScale::with(const EnergyLedger &before, const StepEnergies &step) const {
  const double put_in = initial + before.external - before.gravity + step.external - step.gravity;
  return std::max({largest, std::abs(put_in), step.kinetic, 1e-300});
}

ContactStepReport motion_step(ContactSystem &system, SystemState &state, double t, double dt,
                              const Eigen::VectorXd &load, const MotionOptions &options) {
  StepTerms terms{load};
  terms.dt = dt;
  if (options.ground) terms.ground = options.ground(t, dt);
  StepOptions step = options.step;
  step.newton.patience = options.may_cut(dt) ? patience_of_newton : 0;
  if (t == 0) step.rho_inf = 1; // the first, shortest step: its end's accelerations balance the forces
  return time_step(system, state, terms, step);
}

double work(const Eigen::VectorXd &load_before, const Eigen::VectorXd &load_after, const SystemState &before,
            const SystemState &now) {
  return 0.5 * (load_before + load_after).dot(now.u - before.u);
}

Attempt assess(const SolvedStep &step, const StepEnergies &energies, const EnergyLedger &ledger, EnergyScale &scale,
               const SystemState &now, const MotionOptions &options) {
  const double largest = scale.with(ledger, energies);
  const double error = std::abs(energies.unbalanced(ledger)) / (options.energy_tolerance * largest) +
                       std::max(0.0, -energies.integrator) / (options.gain_tolerance * largest);
  Attempt result = StepControl{}.assess(error, step.dt, options.may_cut(step.dt), now.growth_hold > 0);
  if (result.accepted) scale.largest = largest;
  return result;
}

namespace {

class LoadedMotion : public Stepper {
public:
  LoadedMotion(ContactSystem &system, SystemState &state, const std::function<Eigen::VectorXd(double)> &load,
               const MotionOptions &options, const AfterStep &after_step, const AfterPoint &after_point)
      : system_(system), state_(state), load_(load), options_(options), after_step_(after_step),
        after_point_(after_point) {}

  MotionReport run(const MotionPoint &from, double end) {
    at_ = from;
    if (from.t == 0) {
      at_.ledger = ledger_at(system_, state_);
      at_.scale.initial = at_.scale.largest = at_.ledger.initial;
    }
    const double first = from.next_step > 0 ? from.next_step : options_.smallest_step;
    report_.march = march_to(from.t, end, {first, options_.smallest_step, options_.largest_step});
    report_.ledger = at_.ledger;
    return report_;
  }

private:
  ContactSystem &system() override { return system_; }
  SystemState &state() override { return state_; }

  /// Arrives at the touch, then goes on with the short step.
  double clipped(double, double dt) const override {
    if (state_.bearing_points() > 0) return 0;
    const double until = system_.time_to_touch(state_);
    if (until >= dt) return 0;
    if (until > 1e-3 * options_.contact_step && options_.may_cut(dt))
      return std::max(until * (1 + 1e-9), options_.smallest_step);
    return dt > 1.001 * options_.contact_step ? options_.contact_step : 0;
  }
  ContactStepReport solve(double t, double dt) override {
    load_before_ = load_(t), load_after_ = load_(t + dt);
    ContactStepReport report = motion_step(system_, state_, t, dt, load_after_, options_);
    report_.iterations += report.iterations;
    return report;
  }
  Attempt assess(const SolvedStep &step) override {
    energies_ = energies_of(system_, state_, step.report, 1);
    energies_.external = work(load_before_, load_after_, step.before, state_);
    return fe::assess(step, energies_, at_.ledger, at_.scale, state_, options_);
  }
  void accept(const SolvedStep &step) override {
    book(at_.ledger, energies_);
    at_.t = step.end();
    after_step_(at_.t, state_, step.report);
  }
  void keep(double next) override {
    at_.next_step = next;
    if (after_point_) after_point_(at_);
  }

  ContactSystem &system_;
  SystemState &state_;
  const std::function<Eigen::VectorXd(double)> &load_;
  const MotionOptions &options_;
  const AfterStep &after_step_;
  const AfterPoint &after_point_;
  MotionPoint at_;
  MotionReport report_;
  StepEnergies energies_;
  Eigen::VectorXd load_before_, load_after_;
};

} // namespace

double MotionReport::imbalance() const {
  return std::abs(ledger.imbalance_relative());
}

MotionReport run_in_time(ContactSystem &system, SystemState &state, double end,
                         const std::function<Eigen::VectorXd(double)> &load, const MotionOptions &options,
                         const AfterStep &after_step, const MotionPoint &from, const AfterPoint &after_point) {
  return LoadedMotion(system, state, load, options, after_step, after_point).run(from, end);
}

} // namespace rimpact::fe
