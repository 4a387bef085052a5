/// Steps of a ContactSystem: static and in time, each with its augmentations. A step that fails leaves the state
/// as it was.
#pragma once
#include "fe_contact/engine/contact_system.h"
#include "fe_contact/solver/march.h"

namespace rimpact::fe {

struct StepOptions {
  NewtonOptions newton;
  double gap_tolerance = 1e-6;  ///< penetration augmentation is to leave, in the multipliers' sense [m]
  double slip_tolerance = 1e-6; ///< likewise, slip of sticking points [m]
  int max_augmentations = 10;   ///< a cap, reported when reached; 0: pure penalty
  /// Newton's tolerance before multipliers are renewed, but for a last time: solving better than they are known is
  /// wasted. The last solution meets newton.tolerance. 0: all do.
  double tolerance_between = 0;
  double rho_inf = 0.8;
  bool smooth = false;  ///< steps in time: no wall in reach, the motion has an acceleration
  bool expects = false; ///< steps in time begin with the pressures' last change repeated (see SurfaceContact::expect)
};

struct ContactStepReport {
  bool converged = false, capped = false; ///< capped: the augmentations' cap was reached
  bool stiffened = false;                 ///< augmentation was slow, the penalties were raised
  int iterations = 0, augmentations = 0;
  std::vector<double> residuals;      ///< of the last Newton solution
  double gap_left = 0, slip_left = 0; ///< at the end [m]
  double integrator_loss = 0;         ///< [J], steps in time only
  double multiplier = 0;              ///< of the remote displacement's constraint [N], whole bearing
  std::string reason;
};

/// Equilibrium under the terms' loads and driven equations, started at `guess` (empty: at the state).
ContactStepReport static_step(ContactSystem &system, SystemState &state, const StepTerms &terms,
                              const StepOptions &options, const Eigen::VectorXd &guess = {});
/// One implicit step in time of length terms.dt.
ContactStepReport time_step(ContactSystem &system, SystemState &state, const StepTerms &terms,
                            const StepOptions &options);

/// Static preload of bodies that contact alone holds: springs to the last state, weakened tenfold a round, by less
/// where that does not converge, until what they carry is below `share` of the forces in play. The last round's share
/// is reported.
struct PreloadReport {
  bool converged = false;
  int rounds = 0, iterations = 0;
  double stabilisation_share = 0;
  std::string reason;
};
PreloadReport preload(ContactSystem &system, SystemState &state, const Eigen::VectorXd &load, double stiffness,
                      const StepOptions &options, double share = 1e-6);

/// Energies of a run in time [J]. `imbalance` is what nothing accounts for, over the largest energy seen.
struct SystemLedger {
  double initial = 0, external = 0, kinetic = 0, elastic = 0, plastic = 0, friction = 0, contact = 0, integrator = 0;
  double largest = 0; ///< largest energy put in so far
  double imbalance() const;
};

/// Where a run in time stands after an accepted step; with the state it is all a restart needs.
struct TransientPoint {
  double t = 0;         ///< [s]
  double next_step = 0; ///< the step it would try next [s]; 0: the smallest
  SystemLedger ledger{};
};

struct TransientOptions {
  StepOptions step;
  double largest_step;            ///< [s]
  double smallest_step;           ///< [s]
  double contact_step;            ///< first step after a predicted touch [s]
  double energy_tolerance = 1e-4; ///< unaccounted energy of a step over the largest; beyond it the step is cut
  double gain_tolerance = 1e-4;   ///< likewise, what the integrator adds (it takes, on the whole)
  std::function<GroundStep(double t, double dt)> ground{};   ///< none: it stands still
  TransientPoint from{};                                     ///< t = 0: a new run, whose ledger starts from the state
  std::function<void(const TransientPoint &)> after_point{}; ///< sees where the run stands, to keep it
};

struct TransientReport {
  MarchReport march;
  SystemLedger ledger;
  int iterations = 0, capped_steps = 0;
};

using AfterStep = std::function<void(double t, const SystemState &, const ContactStepReport &)>;
/// One step from t: rejected, with everything as it was, when it does not converge or its energy error is too large.
Attempt checked_step(ContactSystem &system, SystemState &state, double t, double dt,
                     const std::function<Eigen::VectorXd(double)> &load, const TransientOptions &options,
                     TransientReport &report, const AfterStep &after_step);
/// From `options.from` to `end` under a load that may vary in time; `after_step(t, state, step)` sees every accepted
/// state.
TransientReport run_in_time(ContactSystem &system, SystemState &state, double end,
                            const std::function<Eigen::VectorXd(double)> &load, const TransientOptions &options,
                            const AfterStep &after_step);

} // namespace rimpact::fe
