#include "studies/reliability/fit_check.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace rimpact::reliability {
namespace {

/// Exact bounds of a probability of which `n_beyond` of n trials are known; neither need be whole.
double lower_bound_of(double n_beyond, double n, double tail) {
  if (n_beyond <= 0) return 0;
  return boost::math::quantile(boost::math::beta_distribution<>(n_beyond, n - n_beyond + 1), tail);
}

double upper_bound_of(double n_beyond, double n, double tail) {
  if (n_beyond >= n) return 1;
  return boost::math::quantile(
      boost::math::complement(boost::math::beta_distribution<>(n_beyond + 1, n - n_beyond), tail));
}

/// Standard score of a fitted P and its variance: of a normal sample, 1/n (1 + z^2 / 2).
struct Score {
  double z, variance;
};
Score score_of(const LevelEvidence &level) {
  const double z = standard_score(level.fitted);
  return {z, (1 + z * z / 2) / std::max(1.0, level.n_fitted)};
}

void refuse_what_falls(const std::vector<LevelEvidence> &levels, double sigmas, std::vector<LevelCheck> &checks) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      const Score a = score_of(levels[i]), b = score_of(levels[j]);
      if (a.z - b.z > sigmas * std::sqrt(a.variance + b.variance)) checks[i].refused = checks[j].refused = true;
    }
}

} // namespace

std::vector<LevelCheck> check_fits(const std::vector<LevelEvidence> &levels, double confidence) {
  const double tail = (1 - confidence) / 2;
  std::vector<LevelCheck> checks(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    double n_beyond = 0, n = 0;
    const auto pool = [&](const LevelEvidence &level) {
      n_beyond += level.counted * level.n_records, n += level.n_records;
    };
    for (std::size_t j = i; j < levels.size(); ++j)
      pool(levels[j]), checks[i].high = std::min(checks[i].high, upper_bound_of(n_beyond, n, tail));
    n_beyond = n = 0;
    for (std::size_t j = i + 1; j-- > 0;)
      pool(levels[j]), checks[i].low = std::max(checks[i].low, lower_bound_of(n_beyond, n, tail));
    checks[i].refused = levels[i].fitted < checks[i].low || levels[i].fitted > checks[i].high;
  }
  refuse_what_falls(levels, boost::math::quantile(boost::math::complement(boost::math::normal(), tail)), checks);
  bool higher_refused = false;
  for (std::size_t i = levels.size(); i-- > 0;) {
    higher_refused |= checks[i].refused;
    checks[i].refused |= higher_refused && levels[i].counted == 0;
    // Counts that fall with intensity by more than chance cross the pooled bounds: each then keeps its own share.
    checks[i].low = std::min(checks[i].low, levels[i].counted);
    checks[i].high = std::max(checks[i].high, levels[i].counted);
  }
  return checks;
}

} // namespace rimpact::reliability
