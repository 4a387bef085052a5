/// The counts of a SolverWork by name: what the response stores, the summary sums and the checkpoint keeps.
#pragma once
#include "fe_contact/solver/solver_work.h"

namespace rimpact::fe {

struct SolverCount {
  const char *signal; ///< of the response, since the row before; null: stored by the step as newton_iterations
  const char *sum;    ///< in the summary
  long SolverWork::*of;
};
inline constexpr SolverCount solver_counts[] = {
    {nullptr, "newton_iterations", &SolverWork::iterations},
    {"backtracks", "backtracks", &SolverWork::backtracks},
    {"eliminations", "eliminations", &SolverWork::eliminations},
    {"linear_iterations", "linear_iterations", &SolverWork::linear_iterations},
    {"factorisations", "factorisations", &SolverWork::factorisations},
    {"augmentations", "augmentations", &SolverWork::augmentations},
    {"cuts", "steps_not_taken", &SolverWork::cuts}};

} // namespace rimpact::fe
