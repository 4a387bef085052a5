/// How long the steps of a sliding bearing may be: at rest, at a turn, before the rim joins and before the walls touch.
#pragma once
#include "fe_contact/drive/sliding_stack.h"

namespace rimpact::fe {

/// Away from the rim, sliding [s].
constexpr double longest_sliding_step = 0.02;
/// A slower slider rests, if the scout has done sliding too; the stack rings with half of it [m/s].
constexpr double sliding_speed = 1e-2;
constexpr double joining_gap = 2e-3; ///< left of the capacity where the rim's solids join [m]

class SlidingPace {
public:
  SlidingPace(const planning::Plan &plan, double contact_step) : plan_(plan), contact_step_(contact_step) {}

  /// Whether the reduced model has the slider at rest from t on, or before it first moves, and it is slow here too.
  bool rests_at(double t, const SlidingStack &stack) const;
  double longest(const SlidingStack &stack, bool resting) const; ///< step [s]
  /// Length instead of a step that would overshoot a turn, the rim's joining or the touch; 0: the step may be tried.
  /// `surface_gap`: left between the walls [m].
  double clipped(double t, double dt, const SlidingStack &stack, bool resting, double surface_gap) const;

private:
  double longest_at_turn(const SlidingStack &stack) const;

  const planning::Plan &plan_;
  double contact_step_; ///< with which the walls touch [s]
};

} // namespace rimpact::fe
