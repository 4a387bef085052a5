// Rates of fragilities that are known at levels, against closed forms.
#include "studies/reliability/level_rate.h"
#include "ten_levels.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace rimpact::reliability;
using ten_levels::lognormal;

namespace {

/// k_0 x^-k through 475 years at 0.1129 g, as a hazard of two points.
HazardCurve power_law(double k) {
  return HazardCurve({{0.1129, 475}, {0.4362, 475 * std::pow(0.4362 / 0.1129, k)}});
}
struct Rates {
  LevelRate flat, fitted;
  double exact;
};
Rates rates(double median, double k, double beta = 0.4) {
  const auto hazard = power_law(k);
  const auto weights = level_weights(hazard, ten_levels::all);
  std::vector<double> p;
  std::vector<ShareAt> shares;
  for (const double x : ten_levels::all) p.push_back(lognormal(x, median, beta)), shares.push_back({x, p.back(), 30});
  return {flat_rate(weights, p), fitted_rate(hazard, weights, ten_levels::all, p, fit_binomial(shares, Link::probit)),
          hazard.rate(median) * std::exp(k * k * beta * beta / 2)};
}

} // namespace

TEST(LevelRate, MeetsTheClosedFormAtEveryMedian) {
  for (const double median : {0.15, 0.3, 0.5, 0.8, 1.2})
    for (const double k : {1.5, 2.0, 2.5, 3.0}) {
      const auto [flat, fitted, exact] = rates(median, k);
      EXPECT_NEAR(fitted.rate / exact, 1, 1e-6) << median << " " << k;
      EXPECT_NEAR(std::accumulate(fitted.of_levels.begin(), fitted.of_levels.end(), 0.0) / fitted.rate, 1, 1e-12);
      EXPECT_GE(fitted.above, flat.above);
      if (median > 1) {
        EXPECT_LT(flat.rate / exact, 0.1) << "held flat it is up to thirty times low";
        EXPECT_GT(fitted.above / fitted.rate, 0.9);
      }
    }
}

TEST(LevelRate, WithoutACurveIsTheFlatOneBeyondTheLevels) {
  const auto hazard = power_law(2.5);
  const auto weights = level_weights(hazard, {0.1, 0.2, 0.4});
  const std::vector<double> p{0, 0, 0.3};
  const auto flat = flat_rate(weights, p), fitted = fitted_rate(hazard, weights, {0.1, 0.2, 0.4}, p, std::nullopt);
  EXPECT_NEAR(fitted.rate / flat.rate, 1, 1e-14);
  EXPECT_NEAR(flat.rate, weights.rate(p), 1e-18);
  EXPECT_EQ(flat.below, 0);
}

TEST(LevelRate, NeverFallsBelowTheLastLevelsProbability) {
  const auto hazard = power_law(2.5);
  const std::vector<double> x{0.1, 0.2, 0.4}, p{0.01, 0.1, 0.9}; // the curve through the lower two reaches it late
  const auto weights = level_weights(hazard, x);
  const BinomialFit slow{Link::probit, 0.5, 1.0};
  const auto fitted = fitted_rate(hazard, weights, x, p, slow);
  EXPECT_GE(fitted.above, 0.9 * hazard.rate(0.4) * (1 - 1e-12));
  EXPECT_LE(fitted.above, hazard.rate(0.4));
}
