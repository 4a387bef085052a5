#include "fe_contact/drive/step_control.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

Attempt StepControl::assess(double error, double dt, bool may_be_cut, bool growth_hold, double refused) const {
  constexpr double longest_cut = 0.7, shortest_next = 0.5;
  constexpr double fallen = 0.8, grown = 1.25; // against the error before a cut to 0.7 at most: by its third power 0.35
  const bool jump = error > fallen * refused && error < grown * refused && error <= most_of_a_jump;
  if (error > most_error && may_be_cut && !jump)
    return {false, dt * std::clamp(0.8 / std::cbrt(error), least_cut, longest_cut),
            "the step's energy error is too large", error};
  return {true,
          dt * std::clamp(0.9 / std::cbrt(std::max(error, 1e-3)), shortest_next, growth_hold ? 1.0 : most_growth),
          {}};
}

} // namespace rimpact::fe
