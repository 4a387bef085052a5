/// Where a series first passes a level, on straight lines between its points.
#pragma once
#include <cstddef>
#include <optional>
#include <span>

namespace rimpact {

/// Between point `right - 1` and point `right` of a series; at its first point where `right` is 0.
struct Crossing {
  std::size_t right = 0;
  double share = 0; ///< of the way from the left point to the right one, 0 <= share < 1
  /// What another series of the same points is there; it has more than `right` of them.
  double of(std::span<const double> values) const;
};
/// A level is passed where a value exceeds it: one that is only met up to the end is borne, and of values that stay at
/// the level before they exceed it the last one counts. None: no value exceeds it. Values are finite.
std::optional<Crossing> first_crossing(std::span<const double> values, double level);

} // namespace rimpact
