/// How many steps a reduced model may take before it stops with a sentence. A usual run takes some thousands; one that
/// needs a thousand times as many follows something far faster than a bearing moves, and would seem to hang.
#pragma once
#include "files/error.h"
#include <string>

namespace rimpact::reduced {

inline constexpr long step_budget = 5'000'000;

/// Throws SolverStopped once `n_steps` is beyond the budget.
inline void keep_to_budget(long n_steps, double t) {
  if (n_steps > step_budget)
    throw SolverStopped("the reduced model has taken " + std::to_string(step_budget) +
                        " steps up to t = " + std::to_string(t) +
                        " s: something in the scene is far faster than a bearing moves (a stiffness, an elastic slip, "
                        "a period), or the tolerance too tight");
}

} // namespace rimpact::reduced
