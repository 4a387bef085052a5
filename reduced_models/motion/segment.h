/// What an integrator hands to those who watch its run.
#pragma once
#include "reduced_models/bearings/dynamics.h"
#include <functional>

namespace rimpact::reduced {

/// A piece of the solution on one branch; `at` interpolates to the integrator's own order.
struct Segment {
  double t0, t1;
  const State &y0, &y1;
  std::function<State(double)> at;
  const Evaluation *end = nullptr; ///< of (t1, y1) on this branch, where it is known
};

} // namespace rimpact::reduced
