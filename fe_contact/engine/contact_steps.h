/// Steps of a ContactSystem: static and in time, each with its augmentations. A step that fails leaves the state
/// as it was.
#pragma once
#include "fe_contact/engine/contact_system.h"

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
  bool smooth = false; ///< steps in time: no wall in reach, the motion has an acceleration
  bool expects =
      false; ///< steps in time begin with the pressures' last change repeated (see SurfaceContactState::expect)
  /// Shorter steps in time carry multipliers on, and renew them for the next step, by their share of it [s]; 0: all do
  /// so wholly. Multipliers renewed wholly in ever shorter steps add up the gap without end: contact then feeds its own
  /// ringing. Within a step they are renewed as ever, where more than gap_tolerance is left.
  double renewal_time = 0;
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

} // namespace rimpact::fe
