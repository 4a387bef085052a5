/// Motion in time of a system under a load that varies in time: its step, the step's error, and runs by the loop.
#pragma once
#include "fe_contact/drive/ledger.h"
#include "fe_contact/drive/step_control.h"
#include "fe_contact/drive/stepper.h"
#include <functional>

namespace rimpact::fe {

struct MotionOptions {
  StepOptions step;
  double largest_step;            ///< [s]
  double smallest_step;           ///< [s]
  double contact_step;            ///< first step after a predicted touch [s]
  double energy_tolerance = 1e-4; ///< unaccounted energy of a step over the largest; beyond it the step is cut
  double gain_tolerance = 1e-4;   ///< likewise, what the integrator adds (it takes, on the whole)
  std::function<GroundStep(double t, double dt)> ground{}; ///< none: it stands still

  bool may_cut(double dt) const { return dt > 1.001 * smallest_step; }
};

/// The energy against which a step's error is measured: the largest that the motion has had [J].
struct EnergyScale {
  double initial = 0, largest = 0;
  double with(const EnergyLedger &before, const StepEnergies &step) const;
};

/// One step from t under the load at its end.
ContactStepReport motion_step(ContactSystem &system, SystemState &state, double t, double dt,
                              const Eigen::VectorXd &load, const MotionOptions &options);
/// Work of a load over the step that led to `now` [J], trapezoidal.
double work(const Eigen::VectorXd &load_before, const Eigen::VectorXd &load_after, const SystemState &before,
            const SystemState &now);
/// Whether a moved step is taken: by what its energies leave out and by what the integrator adds, which is an error
/// where its losses are the damping of waves that the step cannot resolve. Makes the scale the step's.
Attempt assess(const SolvedStep &step, const StepEnergies &energies, const EnergyLedger &ledger, EnergyScale &scale,
               const SystemState &now, const MotionOptions &options);

/// Where a motion stands after an accepted step; with the state it is all a restart needs.
struct MotionPoint {
  double t = 0;         ///< [s]
  double next_step = 0; ///< the step it would try next [s]; 0: the smallest
  EnergyLedger ledger{};
  EnergyScale scale{};
};
struct MotionReport {
  MarchReport march;
  EnergyLedger ledger;
  int iterations = 0;
  double imbalance() const; ///< of the ledger, without its sign
};
/// What sees each accepted step, and where the motion stands after it.
using AfterStep = std::function<void(double t, const SystemState &, const ContactStepReport &)>;
using AfterPoint = std::function<void(const MotionPoint &)>;

/// From `from` (t = 0: a new motion, whose ledger starts from the state) to `end`. Steps are clipped to the predicted
/// touch.
MotionReport run_in_time(ContactSystem &system, SystemState &state, double end,
                         const std::function<Eigen::VectorXd(double)> &load, const MotionOptions &options,
                         const AfterStep &after_step, const MotionPoint &from = {}, const AfterPoint &after_point = {});

} // namespace rimpact::fe
