#include "io/records/fault_rotation.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact {

FaultComponents fault_components(const SampledSignal &first, const Direction &first_direction,
                                 const SampledSignal &second, const Direction &second_direction, double strike) {
  for (const auto *direction : {&first_direction, &second_direction})
    if (!direction->azimuth_deg)
      throw DataError(fmt::format("the azimuth of the direction \"{}\" is not known", direction->spelling));
  if (std::abs(first.dt - second.dt) > 1e-9 * first.dt || first.start != second.start)
    throw DataError(fmt::format("the components have steps of {:g} and {:g} s, or begin at different instants",
                                first.dt, second.dt));
  const double degree = std::numbers::pi / 180;
  const double a = *first_direction.azimuth_deg * degree, b = *second_direction.azimuth_deg * degree;
  const double determinant = std::sin(b - a); // of the two directions, north and east
  constexpr double least_angle = 20;
  if (std::abs(determinant) < std::sin(least_angle * degree))
    throw DataError(fmt::format("the components lie along {:g} and {:g} degrees, less than {:g} apart",
                                *first_direction.azimuth_deg, *second_direction.azimuth_deg, least_angle));
  const std::size_t n = std::min(first.values.size(), second.values.size());
  FaultComponents turned{{first.dt, std::vector<double>(n), first.start},
                         {first.dt, std::vector<double>(n), first.start}};
  const double along = strike * degree;
  for (std::size_t i = 0; i < n; ++i) {
    // What an instrument along an azimuth shows is the motion's projection on it: two of them give the motion.
    const double one = first.values[i], two = second.values[i];
    const double north = (one * std::sin(b) - two * std::sin(a)) / determinant;
    const double east = (two * std::cos(a) - one * std::cos(b)) / determinant;
    turned.parallel.values[i] = north * std::cos(along) + east * std::sin(along);
    turned.normal.values[i] = -north * std::sin(along) + east * std::cos(along);
  }
  return turned;
}

} // namespace rimpact
