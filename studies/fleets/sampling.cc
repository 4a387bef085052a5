#include "studies/fleets/sampling.h"
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace rimpact::fleets {
namespace {

double normal_cdf(double x) {
  return std::erfc(-x / std::sqrt(2.0)) / 2;
}

/// Inverse by bisection between the cut-offs, where it is bracketed by construction.
double cut_normal_quantile(const Distribution &d, double p) {
  const auto standard = [&](double x) { return (x - d.mean) / d.deviation; };
  const double at_low = normal_cdf(standard(d.low)), at_high = normal_cdf(standard(d.high));
  const double target = at_low + p * (at_high - at_low);
  double low = d.low, high = d.high;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (normal_cdf(standard(middle)) < target ? low : high) = middle;
  }
  return p <= 0 ? d.low : high;
}

/// The library's distributions differ from one C++ library to the next; the generator does not.
class Random {
public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; } // in (0, 1)
  int below(int n) { return static_cast<int>(uniform() * n); }

private:
  std::mt19937_64 generator_;
};

} // namespace

double Distribution::quantile(double p) const {
  switch (kind) {
  case Kind::uniform:
    return low + p * (high - low);
  case Kind::log_uniform:
    return low * std::pow(high / low, p);
  case Kind::normal:
    return cut_normal_quantile(*this, p);
  }
  return low;
}

std::vector<std::vector<double>> latin_hypercube(int dimensions, int samples, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<double>> points(samples, std::vector<double>(dimensions));
  std::vector<int> strips(samples);
  for (int d = 0; d < dimensions; ++d) {
    std::iota(strips.begin(), strips.end(), 0);
    for (int i = samples - 1; i > 0; --i) std::swap(strips[i], strips[random.below(i + 1)]);
    for (int i = 0; i < samples; ++i) points[i][d] = (strips[i] + random.uniform()) / samples;
  }
  return points;
}

} // namespace rimpact::fleets
