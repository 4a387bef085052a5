#include "io/files/error.h"
#include "studies/reliability/level.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace rimpact;
using namespace rimpact::reliability;

// 200,000 runs counted: a quarter collapses, a fifth of the others gives 0, the rest is lognormal.
TEST(LevelDistribution, TotalProbabilityAgreesWithCounting) {
  std::mt19937_64 generator(7);
  std::lognormal_distribution<double> response(std::log(0.3), 0.4);
  std::vector<double> values;
  int collapsed = 0;
  for (int i = 0; i < 200000; ++i) {
    if (i % 4 == 0)
      ++collapsed;
    else
      values.push_back(i % 5 == 1 ? 0 : response(generator));
  }
  const auto level = level_distribution(values, collapsed);
  EXPECT_EQ(level.n_collapsed + level.n_zero + level.n_positive, 200000);
  for (const double limit : {0.1, 0.3, 0.6, 5.0}) {
    int beyond = collapsed;
    for (const double value : values) beyond += value > limit;
    EXPECT_NEAR(level.exceedance(limit), beyond / 200000.0, 4 * std::sqrt(0.25 / 200000)) << limit;
  }
}

TEST(LevelDistribution, AllCollapsedExceedEveryLimit) {
  const auto level = level_distribution({}, 30);
  EXPECT_FALSE(level.fit);
  EXPECT_EQ(level.exceedance(1e9), 1);
}

TEST(LevelDistribution, NoImpactExceedsNoLimit) {
  const auto level = level_distribution({0, 0, 0}, 0);
  EXPECT_EQ(level.exceedance(1e-9), 0);
  EXPECT_EQ(level_distribution({0, 0, 0}, 1).exceedance(1e9), 0.25);
}

TEST(LevelDistribution, OneRunIsAStep) {
  const auto level = level_distribution({0.3}, 0);
  EXPECT_EQ(level.exceedance(0.299999), 1);
  EXPECT_EQ(level.exceedance(0.3), 0);
  EXPECT_EQ(level_distribution({0.3, 0.3, 0.3}, 1).exceedance(0.2), 1);
  EXPECT_EQ(level_distribution({0.3, 0.3, 0.3}, 1).exceedance(0.4), 0.25);
}

TEST(LevelDistribution, ALimitNeverReachedHasNoProbability) {
  EXPECT_LT(level_distribution({0.1, 0.11, 0.12}, 0).exceedance(10), 1e-300);
}

TEST(LevelDistribution, Refusals) {
  EXPECT_THROW(level_distribution({}, 0), InputError);
  EXPECT_THROW(level_distribution({0.1}, -1), InputError);
  EXPECT_THROW(level_distribution({-0.1}, 0), InputError);
  EXPECT_THROW(level_distribution({std::numeric_limits<double>::quiet_NaN()}, 0), InputError);
  EXPECT_THROW(level_distribution({0.1}, 0).exceedance(0), InputError);
}
