#include "fe_contact/drive/step_control.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

Attempt StepControl::assess(double error, double dt, bool may_be_cut, bool growth_hold) const {
  constexpr double longest_cut = 0.7, shortest_next = 0.5;
  if (error > most_error && may_be_cut)
    return {false, dt * std::clamp(0.8 / std::cbrt(error), least_cut, longest_cut),
            "the step's energy error is too large"};
  return {true,
          dt * std::clamp(0.9 / std::cbrt(std::max(error, 1e-3)), shortest_next, growth_hold ? 1.0 : most_growth),
          {}};
}

} // namespace rimpact::fe
