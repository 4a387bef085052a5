#include "responses/crossing.h"

#include <algorithm>
#include <cmath>

namespace rimpact {

double Crossing::of(std::span<const double> values) const {
  return right == 0 ? values.front() : std::lerp(values[right - 1], values[right], share);
}

std::optional<Crossing> first_crossing(std::span<const double> values, double level) {
  const auto beyond = std::ranges::find_if(values, [=](double value) { return value > level; });
  if (beyond == values.end()) return {};
  const auto right = static_cast<std::size_t>(beyond - values.begin());
  if (right == 0) return Crossing{};
  return Crossing{right, (level - values[right - 1]) / (values[right] - values[right - 1])};
}

} // namespace rimpact
