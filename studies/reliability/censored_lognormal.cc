#include "studies/reliability/censored_lognormal.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reliability {
namespace {

/// phi(z) / (1 - Phi(z)); beyond z = 30 by its first terms.
double hazard_of_normal(double z) {
  constexpr double far = 30;
  if (z > far) return z + 1 / z;
  return normal_density(z) / normal_probability(-z);
}

} // namespace

std::optional<Lognormal> fit_censored(const CensoredSums &sums, double stop) {
  if (!(sums.n > 0)) return std::nullopt;
  const double mean = sums.sum_ln / sums.n, spread = sums.sum_ln2 / sums.n - mean * mean;
  if (!(spread > 1e-13 * std::max(1.0, sums.sum_ln2 / sums.n))) return std::nullopt;
  const double limit = std::log(stop), all = sums.n + sums.n_beyond;
  double mu = mean, sigma = std::sqrt(spread);
  constexpr int most_steps = 20'000;
  for (int i = 0; i < most_steps; ++i) {
    const double z = (limit - mu) / sigma, h = hazard_of_normal(z);
    // Expected first and second moment about mu of a value beyond the limit.
    const double first = sigma * h, second = sigma * sigma * (1 + z * h);
    const double next = (sums.n * (mean - mu) + sums.n_beyond * first) / all; // shift of mu
    const double below = spread + (mean - mu) * (mean - mu);
    const double variance = (sums.n * below + sums.n_beyond * second) / all - next * next;
    const double before = sigma;
    mu += next, sigma = std::sqrt(variance);
    if (!(sigma > 0) || !std::isfinite(mu) || !std::isfinite(sigma)) return std::nullopt;
    if (std::max(std::abs(next), std::abs(sigma - before)) < 1e-13 * std::max(1.0, sigma)) return Lognormal{mu, sigma};
  }
  return std::nullopt;
}

} // namespace rimpact::reliability
