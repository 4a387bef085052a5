#include "io/files/error.h"
#include "studies/reliability/failure_rate.h"
#include "studies/reliability/lognormal.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

/// rate = k0 x^-k through points at the given intensities.
HazardCurve power_law(double k0, double k, const std::vector<double> &intensities) {
  std::vector<HazardPoint> points;
  for (const double x : intensities) points.push_back({x, std::pow(x, k) / k0});
  return HazardCurve(points);
}

/// Lognormal fragility of median `theta` and dispersion `beta`.
Fragility lognormal_fragility(double theta, double beta) {
  return [=](double x) { return 1 - Lognormal{std::log(theta), beta}.exceedance(x); };
}

} // namespace

// Cornell et al. 2002: k0 theta^-k exp(k^2 beta^2 / 2).
TEST(FailureRate, ClosedFormOfPowerLawAndLognormal) {
  for (const double k : {1.0, 2.5, 4.0})
    for (const double beta : {0.2, 0.6}) {
      const auto hazard = power_law(1e-4, k, {0.05, 0.11, 0.3, 0.8});
      const double theta = 0.4, expected = 1e-4 * std::pow(theta, -k) * std::exp(k * k * beta * beta / 2);
      // The rate's density peaks at theta exp(-k beta^2): ten deviations to each side of it and of theta.
      const double low = theta * std::exp(-k * beta * beta - 10 * beta), high = theta * std::exp(10 * beta);
      const auto result = failure_rate(hazard, lognormal_fragility(theta, beta), {low, 0.2, 0.4, high});
      EXPECT_NEAR(result.rate / expected, 1, 1e-9) << k << " " << beta;
    }
}

TEST(FailureRate, CertainFailureIsTheHazardItself) {
  const auto hazard = HazardCurve({{0.05, 43}, {0.2, 475}, {0.4, 10000}});
  const auto result = failure_rate(hazard, [](double) { return 1.0; }, {0.05, 0.1, 0.4});
  EXPECT_NEAR(result.rate * 43, 1, 1e-12);
  EXPECT_NEAR(result.above * 10000, 1, 1e-12);
  EXPECT_NEAR(result.shares[0].rate, hazard.rate(0.05) - hazard.rate(0.1), 1e-14);
  EXPECT_NEAR(result.shares[1].rate, hazard.rate(0.1) - hazard.rate(0.4), 1e-14);
}

TEST(FailureRate, SharesAddUp) {
  const auto hazard = power_law(1e-4, 2.5, {0.05, 0.3});
  const auto result = failure_rate(hazard, lognormal_fragility(0.4, 0.5), {0.05, 0.1, 0.2, 0.4, 0.8});
  const double sum = std::accumulate(result.shares.begin(), result.shares.end(), result.above,
                                     [](double s, const RateShare &share) { return s + share.rate; });
  EXPECT_EQ(result.shares.size(), 4u);
  EXPECT_NEAR(sum / result.rate, 1, 1e-14);
  EXPECT_GT(result.above, 0);
}

// P = ln(x / a) / ln(b / a) up to 1 at b, on a rate k0 x^-k: by parts, (rate(a) - rate(b)) / (k ln(b / a)).
TEST(FailureRate, InterpolatedLevelsHaveAClosedForm) {
  const double a = 0.1, b = 0.4, k = 3;
  const auto hazard = power_law(2e-4, k, {a, b});
  const auto result = failure_rate(hazard, interpolated({{a, 0}, {b, 1}}), {a, b});
  EXPECT_NEAR(result.rate, (hazard.rate(a) - hazard.rate(b)) / (k * std::log(b / a)), 1e-13);
}

TEST(FailureRate, ALimitNeverReachedHasNoRate) {
  const auto hazard = power_law(1e-4, 2, {0.1, 1});
  EXPECT_EQ(failure_rate(hazard, interpolated({{0.1, 0}, {1, 0}}), {0.1, 1}).rate, 0);
}

TEST(Interpolated, EndsAndRefusals) {
  const auto curve = interpolated({{0.1, 0.2}, {0.4, 0.6}});
  EXPECT_EQ(curve(0.099), 0);
  EXPECT_EQ(curve(0.1), 0.2);
  EXPECT_NEAR(curve(0.2), 0.4, 1e-15);
  EXPECT_EQ(curve(9), 0.6);
  EXPECT_EQ(interpolated({{0.1, 0.2}})(5), 0.2);
  EXPECT_THROW(interpolated({}), InputError);
  EXPECT_THROW(interpolated({{0.1, 1.2}}), InputError);
  EXPECT_THROW(interpolated({{0.1, 0.2}, {0.1, 0.3}}), InputError);
  const auto hazard = power_law(1e-4, 2, {0.1, 1});
  EXPECT_THROW(failure_rate(hazard, curve, {0.1}), InputError);
  EXPECT_THROW(failure_rate(hazard, curve, {0.2, 0.1}), InputError);
  EXPECT_THROW(failure_rate(hazard, curve, {0, 0.1}), InputError);
}

TEST(ProbabilityIn, Poisson) {
  EXPECT_NEAR(probability_in(50, 1 / 475.0), 1 - std::exp(-50 / 475.0),
              1e-15);                                       // the 10 % in 50 years of codes
  EXPECT_NEAR(probability_in(50, 1e-18) / 5e-17, 1, 1e-15); // where 1 - exp() would be 0
  EXPECT_EQ(probability_in(50, 0), 0);
  EXPECT_THROW(probability_in(50, -1e-9), InputError);
  EXPECT_THROW(probability_in(-1, 1e-3), InputError);
}
