#include "studies/reliability/normal.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

namespace rimpact::reliability {

double normal_density(double score) {
  return std::exp(-score * score / 2) / std::sqrt(2 * std::numbers::pi);
}

double normal_probability(double score) {
  return std::erfc(-score / std::sqrt(2.0)) / 2;
}

double standard_score(double probability) {
  if (probability <= 0) return -farthest_score;
  if (probability >= 1) return farthest_score;
  return std::max(-farthest_score, boost::math::quantile(boost::math::normal(), probability));
}

} // namespace rimpact::reliability
