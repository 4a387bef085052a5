/// Samples of uncertain parameters.
#pragma once
#include <cstdint>
#include <vector>

namespace rimpact::fleets {

/// Distribution of one parameter over [low, high]: uniform, uniform in the logarithm (0 < low), or a normal
/// one of `mean` and `deviation` cut off at both ends.
struct Distribution {
  enum class Kind { uniform, log_uniform, normal } kind = Kind::uniform;
  double low = 0, high = 1, mean = 0, deviation = 1;
  /// Inverse of the cumulative distribution, p in [0, 1].
  double quantile(double p) const;
};

/// `samples` points in (0, 1)^dimensions: in every dimension one point in each of `samples` strips of equal
/// width, at a random place in it (McKay, Beckman, Conover 1979). The same seed gives the same points on
/// every machine. Result: [sample][dimension].
std::vector<std::vector<double>> latin_hypercube(int dimensions, int samples, std::uint64_t seed);

} // namespace rimpact::fleets
