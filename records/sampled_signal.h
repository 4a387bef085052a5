/// A uniformly sampled signal, as records are.
#pragma once
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

} // namespace rimpact
