// Failure rates of fragilities known at levels, against quadrature and closed forms.
#include "../scene/expect_error.h"
#include "studies/reliability/failure_rate.h"
#include "studies/reliability/level_weights.h"
#include "studies/reliability/record_sums.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

const HazardCurve riverside(
    {{0.01502, 43}, {0.04652, 144}, {0.08109, 289}, {0.1129, 475}, {0.16601, 949}, {0.26227, 2475}, {0.4362, 10000}});

/// The same by quadrature: the foot as a point of its own.
FailureRate by_quadrature(const HazardCurve &hazard, const std::vector<double> &x, const std::vector<double> &p) {
  std::vector<FragilityPoint> points{{x[0] * x[0] / x[1], 0}};
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], p[i]});
  std::vector<double> edges;
  for (const auto &point : points) edges.push_back(point.intensity);
  return failure_rate(hazard, interpolated(points), edges);
}

} // namespace

TEST(LevelWeights, MeetTheConvolutionByQuadrature) {
  const std::vector<double> levels{0.02, 0.05, 0.12, 0.2, 0.3, 0.6}; // between, on and beyond the hazard's points
  for (const auto &p :
       {std::vector<double>{0, 0, 0.01, 0.2, 0.6, 0.95}, {0.3, 0.5, 0.4, 0.9, 1, 1}, {0, 0, 0, 0, 0, 0.1}}) {
    const auto weights = level_weights(riverside, levels);
    const auto exact = by_quadrature(riverside, levels, p);
    EXPECT_NEAR(weights.rate(p) / exact.rate, 1, 1e-9);
    EXPECT_NEAR(weights.below * p[0], exact.shares[0].rate, 1e-9 * exact.rate);
    EXPECT_NEAR(weights.above * p.back(), exact.above, 1e-9 * exact.rate);
  }
}

// A power law times a lognormal fragility, known at many levels: k0 theta^-k exp(k^2 beta^2 / 2).
TEST(LevelWeights, ManyLevelsMeetTheClosedForm) {
  const double k = 2.5, k0 = 1e-4, theta = 0.4, beta = 0.4;
  const HazardCurve hazard({{0.05, std::pow(0.05, k) / k0}, {0.8, std::pow(0.8, k) / k0}});
  std::vector<double> levels, p;
  for (int i = 0; i <= 20000; ++i) {
    levels.push_back(0.002 * std::pow(1e4, i / 20000.0));
    p.push_back(1 - Lognormal{std::log(theta), beta}.exceedance(levels.back()));
  }
  const double exact = k0 * std::pow(theta, -k) * std::exp(k * k * beta * beta / 2);
  EXPECT_NEAR(level_weights(hazard, levels).rate(p) / exact, 1, 1e-6);
}

TEST(LevelWeights, CertainFailureIsTheHazardAndItsFoot) {
  const auto weights = level_weights(riverside, {0.05, 0.2});
  EXPECT_NEAR(weights.rate({1, 1}) - weights.below, riverside.rate(0.05), 1e-15);
  EXPECT_NEAR(weights.most({0, 0}), riverside.rate(0.2), 1e-15);
  const auto alone = level_weights(riverside, {0.2});
  EXPECT_EQ(alone.below, 0);
  EXPECT_NEAR(alone.rate({0.5}), riverside.rate(0.2) / 2, 1e-15);
}

TEST(LevelWeights, RefusesLevelsThatDoNotGrow) {
  expect_error<InputError>([] { level_weights(riverside, {}); }, {"at least one level"});
  expect_error<InputError>([] { level_weights(riverside, {0.1, 0.1}); }, {"must grow", "0.1"});
}

TEST(RecordSums, PoolToTheFitOfAllRuns) {
  std::vector<RecordSums> records(2);
  const std::vector<double> first{0.1, 0.25, 0}, second{0.4, 0.31};
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  for (const double y : first) records[0].add(y);
  for (const double y : second) records[1].add(y);
  records[1].n_collapsed = 3;
  const auto sums = pooled(records, {1, 1}), runs = level_distribution(all, 3);
  for (const double limit : {0.05, 0.2, 0.5}) EXPECT_NEAR(sums.exceedance(limit), runs.exceedance(limit), 1e-12);
  all = first;
  all.insert(all.end(), first.begin(), first.end());
  EXPECT_NEAR(pooled(records, {2, 0}).exceedance(0.2), level_distribution(all, 0).exceedance(0.2), 1e-12);
}

TEST(RecordSums, EqualResponsesAreAStepAndNoRunsCountNothing) {
  std::vector<RecordSums> records(1);
  for (int i = 0; i < 3; ++i) records[0].add(0.3);
  EXPECT_EQ(pooled(records, {7}).fit->distribution.sigma_ln, 0);
  EXPECT_EQ(pooled(records, {1}).exceedance(0.31), 0);
  EXPECT_EQ(pooled(records, {1}).exceedance(0.29), 1);
  const auto none = pooled(records, {0});
  EXPECT_EQ(none.n_positive + none.n_zero + none.n_collapsed, 0);
  EXPECT_FALSE(none.fit);
}
