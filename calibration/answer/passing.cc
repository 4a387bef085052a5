#include "calibration/answer/passing.h"

#include "responses/crossing.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {

Passing passing(const BySpeed &values, double limit) {
  std::vector<double> speeds, reached;
  for (const auto &[speed, value] : values) speeds.push_back(speed), reached.push_back(value);
  const auto passed = first_crossing(reached, limit);
  Passing result;
  const std::size_t right = passed ? passed->right : values.size();
  if (right > 0) result.below = speeds[right - 1];
  if (!passed) return result;
  result.beyond = speeds[right];
  if (right > 0) result.expected = passed->of(speeds);
  return result;
}

std::string in_words(const Passing &p) {
  if (!p.beyond) return "not reached";
  if (!p.below) return fmt::format("passed by every run, from {:.3g} m/s on", *p.beyond);
  return fmt::format("passed at about {:.2g} m/s (runs at {:.3g} and {:.3g})", *p.expected, *p.below, *p.beyond);
}

} // namespace rimpact::calibration
