// Which lognormals the runs of a study refuse.
#include "studies/reliability/fit_check.h"
#include "studies/reliability/lognormal.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace rimpact::reliability;

namespace {

/// Fitted against counted of `n` responses at each level: lognormal of median `level`, cut at a stop.
std::vector<LevelEvidence> evidence(std::mt19937 &random, int n, double limit, double stop = 1e9) {
  std::normal_distribution<double> z;
  std::vector<LevelEvidence> levels;
  for (const double median : {0.1, 0.15, 0.2, 0.3, 0.4, 0.5}) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) {
      const double value = median * std::exp(0.3 * z(random));
      values.push_back(value < stop ? value : stop * (1 + 0.005 * std::abs(z(random))));
    }
    const auto beyond = std::count_if(values.begin(), values.end(), [&](double v) { return v > limit; });
    levels.push_back({fit_lognormal(values).distribution.exceedance(limit), double(beyond) / n, double(n), double(n)});
  }
  return levels;
}

int refused(const std::vector<LevelCheck> &checks) {
  return static_cast<int>(std::count_if(checks.begin(), checks.end(), [](const LevelCheck &c) { return c.refused; }));
}

} // namespace

TEST(FitCheck, RightLognormalsAreRarelyRefused) {
  std::mt19937 random(5);
  int n = 0, n_refused = 0;
  for (int study = 0; study < 100; ++study)
    for (const double limit : {0.15, 0.3, 0.6}) {
      const auto checks = check_fits(evidence(random, 20, limit));
      n += static_cast<int>(checks.size()), n_refused += refused(checks);
    }
  EXPECT_LT(n_refused, 0.1 * n) << n_refused << " of " << n;
}

// A slider that a rim stops at 0.35 m: no run passes 0.4 m, whose lognormals do; nor does any where none exceeds.
TEST(FitCheck, ALognormalThroughAStopIsRefused) {
  std::mt19937 random(7);
  int n_refused = 0;
  for (int study = 0; study < 20; ++study) {
    const auto levels = evidence(random, 20, 0.4, 0.35);
    double largest = 0;
    for (const auto &level : levels) {
      EXPECT_EQ(level.counted, 0);
      largest = std::max(largest, level.fitted);
    }
    ASSERT_GT(largest, 0.02) << "the tail runs through the stop";
    const auto checks = check_fits(levels);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double n =
          20.0 * static_cast<double>(levels.size() - i); // runs of this level and those above: none exceeds
      if (std::pow(1 - levels[i].fitted, n) < 0.025 || levels[i].fitted > 0.1) {
        EXPECT_TRUE(checks[i].refused) << study << " level " << i;
      }
    }
    n_refused += refused(checks) > 0;
  }
  EXPECT_GE(n_refused, 18) << "of 20";
}

TEST(FitCheck, CountsAreBoundedByClopperAndPearson) {
  const auto one = check_fits({{0.2, 0.5, 14, 14}}).front(); // 7 of 14
  EXPECT_NEAR(one.low, 0.2304, 1e-4);
  EXPECT_NEAR(one.high, 0.7696, 1e-4);
  EXPECT_TRUE(one.refused);
  EXPECT_FALSE(check_fits({{0.24, 0.5, 14, 14}}).front().refused);
  EXPECT_NEAR(check_fits({{0.1, 0, 14, 14}}).front().high, 1 - std::pow(0.025, 1 / 14.0), 1e-9);
  // None of three levels' 42 exceeds: at the lowest P is below what 42 allow, at the highest what 14 do.
  const auto pooled = check_fits({{0.01, 0, 14, 14}, {0.01, 0, 14, 14}, {0.01, 0, 14, 14}});
  EXPECT_NEAR(pooled[0].high, 1 - std::pow(0.025, 1 / 42.0), 1e-9);
  EXPECT_NEAR(pooled[2].high, 1 - std::pow(0.025, 1 / 14.0), 1e-9);
  EXPECT_EQ(refused(pooled), 0);
}

TEST(FitCheck, FitsThatFallWithIntensityContradictEachOther) {
  const auto falls = check_fits({{0.005, 0, 14, 14}, {0.014, 0, 14, 14}, {1e-9, 0, 14, 14}});
  EXPECT_EQ(refused(falls), 3);
  const auto noise = check_fits({{0.012, 0, 14, 14}, {0.010, 0, 14, 14}, {0.3, 0.3, 14, 14}});
  EXPECT_EQ(refused(noise), 0) << "within their scatter";
}

TEST(FitCheck, BelowARefusedLevelATailIsNoEvidence) {
  const auto checks = check_fits({{0.01, 0, 40, 40}, {0.05, 0.05, 40, 40}, {0.2, 0.6, 40, 40}, {0.9, 0.9, 40, 40}});
  EXPECT_TRUE(checks[0].refused) << "no run exceeds";
  EXPECT_FALSE(checks[1].refused);
  EXPECT_TRUE(checks[2].refused);
  EXPECT_FALSE(checks[3].refused);
}
