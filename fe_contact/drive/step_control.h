/// The one rule by which a solved step is taken or made shorter, and how long the next one is.
#pragma once
#include "fe_contact/solver/march.h"

namespace rimpact::fe {

struct StepControl {
  double most_error = 1;     ///< with which a step is taken, in tolerances
  double least_cut = 0.2;    ///< a step that is not taken is tried again with no less of its length
  double most_growth = 2;    ///< of the next step
  double most_of_a_jump = 0; ///< an error up to this that a cut has hardly lowered is taken [tolerances]

  /// A step of length dt with an error in tolerances. The error falls with about the third power of the step. Where the
  /// step may not be cut it is taken whatever its error, and the ledger shows it. `refused`: the error with which the
  /// last longer step from the same start was refused (0: none was); one that hardly changed since is not the step's
  /// but a jump's (multipliers, contact points), which shorter steps only repeat. `growth_hold`: the next step is not
  /// to grow.
  Attempt assess(double error, double dt, bool may_be_cut, bool growth_hold, double refused = 0) const;
};

/// The largest error of a refused step that is kept, in tolerances: none near it counts, and a checkpoint is held to
/// it.
inline constexpr double most_refused_error = 1e15;
/// Iterations after which Newton is given up where its residual creeps and the step may be cut.
inline constexpr int patience_of_newton = 6;

} // namespace rimpact::fe
