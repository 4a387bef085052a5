#include "io/records/rotated_spectrum.h"
#include "io/records/spectral_acceleration.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rimpact {

std::pair<SampledSignal, SampledSignal> together(const SampledSignal &x, const SampledSignal &y) {
  if (x.dt == y.dt && x.values.size() == y.values.size()) return {x, y};
  const double dt = std::min(x.dt, y.dt), length = std::max(x.duration(), y.duration());
  const auto n = static_cast<std::size_t>(std::floor(length / dt * (1 + 1e-12))) + 1;
  SampledSignal first{dt, std::vector<double>(n)}, second = first;
  for (std::size_t i = 0; i < n; ++i) {
    first.values[i] = x.at(x.start + dt * static_cast<double>(i));
    second.values[i] = y.at(y.start + dt * static_cast<double>(i));
  }
  return {first, second};
}

RotatedAcceleration rotated_acceleration(const SampledSignal &x, const SampledSignal &y, double period,
                                         double damping) {
  const auto [first, second] = together(x, y);
  const auto along = oscillator_travel(first, period, damping), across = oscillator_travel(second, period, damping);
  constexpr int directions = 180;
  std::vector<double> largest(directions, 0.0);
  for (int k = 0; k < directions; ++k) {
    const double angle = k * std::numbers::pi / directions, c = std::cos(angle), s = std::sin(angle);
    for (std::size_t i = 0; i < along.size(); ++i)
      largest[static_cast<std::size_t>(k)] =
          std::max(largest[static_cast<std::size_t>(k)], std::abs(c * along[i] + s * across[i]));
  }
  std::sort(largest.begin(), largest.end());
  const double w = 2 * std::numbers::pi / period, median = (largest[directions / 2 - 1] + largest[directions / 2]) / 2;
  return {w * w * median, w * w * largest.back()};
}

} // namespace rimpact
