/// The one place where steps are cut, retried and grown.
#pragma once
#include <functional>
#include <string>

namespace rimpact::fe {

struct StepLimits {
  double first, smallest, largest; ///< [s], or of the load parameter
  double growth = 1.5;             ///< after an accepted step that suggests no other
};

/// What came of one attempt at a step. A rejected one may suggest a shorter step (else it is halved), an accepted one
/// the next step's length (else it grows).
struct Attempt {
  bool accepted = false;
  double suggested_step = 0; ///< 0: none
  std::string reason;
  double error = 0;  ///< for which it was not accepted [tolerances]; 0: for something else
  bool last = false; ///< accepted, and the march is to end here
};

struct MarchReport {
  bool finished = false; ///< the end, or a last step, was reached
  double reached = 0;    ///< where it stopped
  double wanted = 0;     ///< length the next step would have had
  int steps = 0, cuts = 0;
  std::string reason; ///< when not finished: why the smallest step failed
};

/// From `start` to `end`. `attempt(t, dt)` must leave everything as it was when it does not accept.
MarchReport march(double start, double end, const StepLimits &limits,
                  const std::function<Attempt(double t, double dt)> &attempt);

} // namespace rimpact::fe
