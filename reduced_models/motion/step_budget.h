/// How many steps a reduced model may take before it stops with a sentence. A usual run takes some thousands; one that
/// needs a thousand times as many follows something far faster than a bearing moves, and would seem to hang.
#pragma once
#include "io/files/error.h"
#include <string>

namespace rimpact::reduced {

inline constexpr long step_budget = 5'000'000;

class StepCount {
public:
  /// Counts a step that led to t. Throws SolverStopped once there are more than the budget.
  void add(double t) {
    if (++n_ > step_budget)
      throw SolverStopped("the reduced model has taken " + std::to_string(step_budget) +
                          " steps up to t = " + std::to_string(t) +
                          " s: something in the scene is far faster than a bearing moves (a stiffness, an elastic "
                          "slip, a period), or the tolerance too tight");
  }
  long n() const { return n_; }

private:
  long n_ = 0;
};

} // namespace rimpact::reduced
