// A rate is a range: what levels of intensity leave open, against closed forms.
#include "studies/reliability/level_weights.h"
#include "studies/reliability/lognormal.h"
#include "studies/reliability/rate_range.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact::reliability;

namespace {

/// The ten levels of thesis 2.6.6 [g].
const std::vector<double> ten_levels{0.0150, 0.0465, 0.0811, 0.1129, 0.1660, 0.2086, 0.2623, 0.3145, 0.3965, 0.4362};

/// A lognormal fragility over the power law k0 x^-k, of which the rate is k0 theta^-k exp(k^2 beta^2 / 2).
struct PowerLaw {
  double k, theta, beta = 0.4, k0 = 1e-4;
  double exact() const { return k0 * std::pow(theta, -k) * std::exp(k * k * beta * beta / 2); }
  HazardCurve hazard() const { return HazardCurve({{0.01, std::pow(0.01, k) / k0}, {2.0, std::pow(2.0, k) / k0}}); }
  std::vector<double> at(const std::vector<double> &levels) const {
    std::vector<double> p;
    for (const double x : levels) p.push_back(1 - Lognormal{std::log(theta), beta}.exceedance(x));
    return p;
  }
};

bool within_a_tenth(const RateRange &range, double rate) {
  return range.least >= 0.9 * rate && range.most && *range.most <= 1.1 * rate;
}

} // namespace

// The rate with the fragility held flat above the last level is 3 to 7 % of the true one at a median of 1.2 g.
TEST(RateRange, HoldsTheClosedFormWhateverTheLevelsReach) {
  for (const double k : {1.5, 2.5, 4.0})
    for (const double theta : {0.012, 0.02, 0.05, 0.15, 0.5, 0.8, 1.2, 3.0}) {
      const PowerLaw law{k, theta};
      const auto p = law.at(ten_levels);
      const double flat = level_weights(law.hazard(), ten_levels).rate(p), exact = law.exact();
      const auto range = rate_range(law.hazard(), ten_levels, {p, p});
      EXPECT_LE(range.least, exact * (1 + 1e-6)) << k << " " << theta;
      EXPECT_LE(range.least, flat * (1 + 1e-9));
      ASSERT_TRUE(range.most || theta < ten_levels.front()) << k << " " << theta;
      EXPECT_GE(range.most.value_or(1e300), exact * (1 - 1e-6)) << k << " " << theta;
      EXPECT_GE(range.most.value_or(1e300), flat * (1 - 1e-9));
      if (std::abs(flat / exact - 1) > 0.1) {
        EXPECT_FALSE(within_a_tenth(range, flat)) << "silently off by " << flat / exact << " at " << k << " " << theta;
      }
      if (range.most) {
        EXPECT_NEAR(range.above + range.between + *range.below, *range.most - range.least, 1e-9 * *range.most);
      }
    }
}

TEST(RateRange, SaysWhereTheRateIsOpen) {
  const PowerLaw rare{2.5, 1.2}, frequent{2.5, 0.015};
  const auto p = rare.at(ten_levels), q = frequent.at(ten_levels);
  const auto high = rate_range(rare.hazard(), ten_levels, {p, p}),
             low = rate_range(frequent.hazard(), ten_levels, {q, q});
  EXPECT_GT(high.above, 10 * (high.between + *high.below));
  EXPECT_GT(*low.below, 10 * (low.between + low.above));
  EXPECT_LT(level_weights(rare.hazard(), ten_levels).rate(p) / rare.exact(), 0.1) << "the flat end is far too low";
}

TEST(RateRange, IsNarrowWhereLevelsReachAndAreClose) {
  const PowerLaw law{2.5, 0.2};
  std::vector<double> levels;
  for (int i = 0; i <= 60; ++i) levels.push_back(0.03 * std::pow(60.0, i / 60.0));
  const auto p = law.at(levels);
  const auto range = rate_range(law.hazard(), levels, {p, p});
  EXPECT_NEAR(range.least / law.exact(), 1, 0.01);
  EXPECT_NEAR(*range.most / law.exact(), 1, 0.01);
}

TEST(RateRange, BoundsOfTheProbabilitiesBoundTheRate) {
  const PowerLaw law{2.5, 0.2};
  const auto p = law.at(ten_levels);
  auto wide = p, narrow = p;
  wide[5] = 1, narrow[4] = 0;
  const auto range = rate_range(law.hazard(), ten_levels, {narrow, wide}),
             own = rate_range(law.hazard(), ten_levels, {p, p});
  EXPECT_LT(range.least, own.least);
  EXPECT_GT(*range.most, *own.most);
  const auto never = rate_range(law.hazard(), {0.1, 0.2}, {{0, 0}, {0, 0}});
  EXPECT_EQ(never.least, 0);
  EXPECT_NEAR(*never.most, law.hazard().rate(0.2), 1e-15) << "above the last level all may fail";
  const auto alone = rate_range(law.hazard(), {0.2}, {{0.5}, {0.5}});
  EXPECT_NEAR(alone.least, law.hazard().rate(0.2) / 2, 1e-15);
  EXPECT_GT(*alone.most, law.hazard().rate(0.2));
}

TEST(RateRange, WithoutAnUpperEndItIsNotKnown) {
  const HazardCurve steep({{0.1, 100}, {0.11, 100 * std::pow(1.1, 60)}});
  EXPECT_FALSE(rate_range(steep, {0.2, 0.3}, {{1, 1}, {1, 1}}).most);
}
