#include "studies/reliability/lognormal.h"
#include "io/files/error.h"
#include "studies/reliability/normal.h"
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reliability {
namespace {

void require_interval(int n, double confidence) {
  if (n < 2) throw InputError(fmt::format("a lognormal fit of {} value has no interval: at least 2 are needed", n));
  if (!(confidence > 0 && confidence < 1))
    throw InputError(fmt::format("confidence {} is not between 0 and 1", confidence));
}

} // namespace

double Lognormal::exceedance(double y) const {
  if (y <= 0) return 1;
  const double distance = std::log(y) - mean_ln;
  if (sigma_ln == 0) return distance < 0 ? 1 : 0;
  return normal_probability(-distance / sigma_ln);
}

double Lognormal::quantile(double p) const {
  return std::exp(mean_ln + sigma_ln * boost::math::quantile(boost::math::normal(), p));
}

LognormalFit fit_lognormal(const std::vector<double> &values) {
  if (values.empty()) throw InputError("a lognormal fit needs at least one value");
  for (const double value : values)
    if (!std::isfinite(value) || value <= 0)
      throw InputError(fmt::format("a lognormal fit takes finite values > 0, not {}", value));
  const auto n = static_cast<double>(values.size());
  // Equal values give a deviation of exactly 0: the logarithms are taken from the first.
  const double origin = std::log(values.front());
  double mean = 0, squares = 0;
  for (const double value : values) mean += (std::log(value) - origin) / n;
  for (const double value : values) squares += std::pow(std::log(value) - origin - mean, 2);
  return {.distribution = {.mean_ln = origin + mean, .sigma_ln = std::sqrt(squares / n)},
          .n = static_cast<int>(values.size())};
}

Interval LognormalFit::mean_interval(double confidence) const {
  require_interval(n, confidence);
  const boost::math::students_t t(n - 1);
  const double half = boost::math::quantile(t, (1 + confidence) / 2) * distribution.sigma_ln / std::sqrt(n - 1.0);
  return {distribution.mean_ln - half, distribution.mean_ln + half};
}

Interval LognormalFit::sigma_interval(double confidence) const {
  require_interval(n, confidence);
  const boost::math::chi_squared chi_square(n - 1);
  const double root = distribution.sigma_ln * std::sqrt(static_cast<double>(n));
  return {root / std::sqrt(boost::math::quantile(chi_square, (1 + confidence) / 2)),
          root / std::sqrt(boost::math::quantile(chi_square, (1 - confidence) / 2))};
}

} // namespace rimpact::reliability
