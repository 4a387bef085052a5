#include "calibration/answer/passing.h"

#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

Passing passing(const BySpeed &values, double limit) {
  const auto beyond = std::find_if(values.begin(), values.end(), [&](const auto &at) { return at.second > limit; });
  Passing result;
  if (beyond != values.begin()) result.below = beyond[-1].first;
  if (beyond == values.end()) return result;
  result.beyond = beyond->first;
  if (beyond == values.begin()) return result;
  const double share = (limit - beyond[-1].second) / (beyond->second - beyond[-1].second);
  result.expected = beyond[-1].first + share * (beyond->first - beyond[-1].first);
  return result;
}

std::string in_words(const Passing &p) {
  if (!p.beyond) return "not reached";
  if (!p.below) return fmt::format("passed by every run, from {:.3g} m/s on", *p.beyond);
  return fmt::format("passed at about {:.2g} m/s (runs at {:.3g} and {:.3g})", *p.expected, *p.below, *p.beyond);
}

} // namespace rimpact::calibration
