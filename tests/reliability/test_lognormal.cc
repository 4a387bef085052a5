#include "io/files/error.h"
#include "studies/reliability/lognormal.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

const std::vector<double> eight = {0.12, 0.34, 0.2, 0.51, 0.08, 0.27, 0.19, 0.44};

bool holds(const Interval &interval, double value) {
  return interval.low <= value && value <= interval.high;
}

} // namespace

// SciPy 1.10.1: stats.lognorm.fit(eight, floc=0), lognorm.sf, lognorm.ppf.
TEST(Lognormal, FitAgreesWithSciPy) {
  const auto fit = fit_lognormal(eight);
  EXPECT_EQ(fit.n, 8);
  EXPECT_NEAR(fit.distribution.mean_ln, -1.474828673306673, 1e-12);
  EXPECT_NEAR(fit.distribution.sigma_ln, 0.594534507054287, 1e-12);
  EXPECT_NEAR(fit.distribution.exceedance(0.1), 0.918080656809001, 1e-12);
  EXPECT_NEAR(fit.distribution.exceedance(0.3), 0.324347321463548, 1e-12);
  EXPECT_NEAR(fit.distribution.exceedance(0.6), 0.052461470465463, 1e-12);
  EXPECT_NEAR(fit.distribution.quantile(0.16), 0.126682895510303, 1e-12);
  EXPECT_NEAR(fit.distribution.quantile(0.84), 0.413296863700612, 1e-12);
}

// SciPy 1.10.1: t.interval(0.95, 7, mean, sigma / sqrt(7)) and sigma sqrt(8 / chi2.ppf([0.975, 0.025], 7)).
TEST(Lognormal, IntervalsAgreeWithSciPy) {
  const auto fit = fit_lognormal(eight);
  EXPECT_NEAR(fit.mean_interval(0.95).low, -2.00619029734281, 1e-8);
  EXPECT_NEAR(fit.mean_interval(0.95).high, -0.943467049270536, 1e-8);
  EXPECT_NEAR(fit.sigma_interval(0.95).low, 0.420231791442992, 1e-12);
  EXPECT_NEAR(fit.sigma_interval(0.95).high, 1.29358662660093, 1e-12);
}

// Student's distribution of 7 degrees of freedom in closed form, theta = atan(t / sqrt(7)):
// P(|T| < t) = 2 / pi (theta + sin (cos + 2/3 cos^3 + 8/15 cos^5)). SciPy's quantile is short of it by 6e-10.
TEST(Lognormal, MeanIntervalHoldsItsShareOfStudentsDistribution) {
  const auto fit = fit_lognormal(eight);
  const auto interval = fit.mean_interval(0.95);
  const double t = (interval.high - interval.low) / 2 / (fit.distribution.sigma_ln / std::sqrt(7.0));
  const double theta = std::atan(t / std::sqrt(7.0)), c = std::cos(theta);
  const double inside = 2 / M_PI * (theta + std::sin(theta) * (c + 2 * std::pow(c, 3) / 3 + 8 * std::pow(c, 5) / 15));
  EXPECT_NEAR(inside, 0.95, 1e-13);
  EXPECT_NEAR((interval.high + interval.low) / 2, fit.distribution.mean_ln, 1e-14);
}

// 1,000 sets of 10: the count held is binomial, its deviation sqrt(1000 x 0.9 x 0.1) = 9.5.
TEST(Lognormal, IntervalsHoldTheTruthAsOftenAsTheySay) {
  std::mt19937_64 generator(3);
  std::lognormal_distribution<double> distribution(-1.2, 0.7);
  int mean_held = 0, sigma_held = 0;
  for (int set = 0; set < 1000; ++set) {
    std::vector<double> values(10);
    for (double &value : values) value = distribution(generator);
    const auto fit = fit_lognormal(values);
    mean_held += holds(fit.mean_interval(0.9), -1.2);
    sigma_held += holds(fit.sigma_interval(0.9), 0.7);
  }
  EXPECT_NEAR(mean_held, 900, 3 * 9.5);
  EXPECT_NEAR(sigma_held, 900, 3 * 9.5);
}

TEST(Lognormal, EqualValuesAreAStep) {
  const auto fit = fit_lognormal({0.3, 0.3, 0.3});
  EXPECT_EQ(fit.distribution.sigma_ln, 0);
  EXPECT_EQ(fit.distribution.exceedance(0.299), 1);
  EXPECT_EQ(fit.distribution.exceedance(0.3), 0);
}

TEST(Lognormal, Refusals) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fit_lognormal({}), InputError);
  for (const double bad : {0.0, -1.0, nan, infinite}) EXPECT_THROW(fit_lognormal({0.1, bad}), InputError) << bad;
  EXPECT_THROW(fit_lognormal({0.1}).mean_interval(0.9), InputError);
  EXPECT_THROW(fit_lognormal({0.1, 0.2}).sigma_interval(1), InputError);
}
