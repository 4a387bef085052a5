/// Where runs by their speed pass a limit.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rimpact::calibration {

/// A value by the speed of its run [m/s].
using BySpeed = std::vector<std::pair<double, double>>;

/// The slowest run beyond the limit, the next slower one, and between the two a straight line.
struct Passing {
  std::optional<double> below;    ///< [m/s]; none: no run is below it
  std::optional<double> beyond;   ///< [m/s]; none: no run reaches it
  std::optional<double> expected; ///< between them [m/s]
};
/// `values` rise in speed.
Passing passing(const BySpeed &values, double limit);
/// "passed at about 0.42 m/s (runs at 0.35 and 0.5)", "not reached".
std::string in_words(const Passing &passing);

} // namespace rimpact::calibration
