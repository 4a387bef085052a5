/// A uniformly sampled signal, as records are.
#pragma once
#include <cstddef>
#include <vector>

namespace rimpact {

/// Uniformly sampled signal from `start` to `end()`; linear between samples, zero outside.
struct SampledSignal {
  double dt = 0.0;
  std::vector<double> values;
  double start = 0.0; ///< instant of the first sample [s], >= 0
  double at(double t) const;
  double instant(std::size_t i) const { return start + dt * static_cast<double>(i); } ///< of sample i [s]
  double duration() const { return values.empty() ? 0.0 : dt * (values.size() - 1); } ///< first to last sample [s]
  double end() const { return start + duration(); }
  bool operator==(const SampledSignal &) const = default;
};

/// Of a signal that is an acceleration: calls visit(i, velocity, displacement) at each sample i, exactly integrated
/// from rest at the first one.
template <class Visit> void integrate_from_rest(const SampledSignal &acceleration, const Visit &visit) {
  const double dt = acceleration.dt;
  double v = 0, u = 0;
  for (std::size_t i = 0; i < acceleration.values.size(); ++i) {
    visit(i, v, u);
    if (i + 1 == acceleration.values.size()) break;
    const double a = acceleration.values[i], b = acceleration.values[i + 1];
    u += v * dt + dt * dt * (2 * a + b) / 6;
    v += dt * (a + b) / 2;
  }
}

/// Largest absolute value; 0 of none.
double peak_of(const std::vector<double> &values);

} // namespace rimpact
