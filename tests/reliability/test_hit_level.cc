// Runs that hit a stop and runs that do not, apart.
#include "../scene/expect_error.h"
#include "studies/reliability/censored_lognormal.h"
#include "studies/reliability/hit_level.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

double beyond(double y, double median, double sigma) {
  return std::erfc(std::log(y / median) / sigma / std::sqrt(2.0)) / 2;
}

/// Travel of a made-up slider: lognormal up to a stop at 0.4 m, which it presses in by a lognormal of 2 mm.
struct Travels {
  std::vector<double> free, hit;
};
Travels travels(int n, double median, double sigma) {
  std::mt19937 random(11);
  std::normal_distribution<double> z;
  Travels result;
  for (int i = 0; i < n; ++i) {
    const double wanted = median * std::exp(sigma * z(random));
    if (wanted < 0.4)
      result.free.push_back(wanted);
    else
      result.hit.push_back(0.4 + 0.002 * std::exp(0.5 * z(random)));
  }
  return result;
}

} // namespace

TEST(CensoredLognormal, FindsWhatLiesBeyondTheStop) {
  const auto [free, hit] = travels(200'000, 0.3, 0.5);
  CensoredSums sums;
  for (const double y : free) ++sums.n, sums.sum_ln += std::log(y), sums.sum_ln2 += std::pow(std::log(y), 2);
  sums.n_beyond = static_cast<double>(hit.size());
  const auto fit = fit_censored(sums, 0.4);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(std::exp(fit->mean_ln), 0.3, 0.002);
  EXPECT_NEAR(fit->sigma_ln, 0.5, 0.005);
  sums.n_beyond = 0; // nothing is censored: the plain fit
  EXPECT_NEAR(fit_censored(sums, 1e9)->mean_ln, sums.sum_ln / sums.n, 1e-12);
  EXPECT_FALSE(fit_censored({1, -1, 1, 5}, 0.4)) << "one value has no scatter";
  EXPECT_FALSE(fit_censored({0, 0, 0, 5}, 0.4));
}

TEST(HitLevel, RecoversATrueFragilityThroughTheStop) {
  for (const double median : {0.15, 0.3, 0.5}) {
    const auto [free, hit] = travels(20'000, median, 0.5);
    const auto stop = stop_between(*std::max_element(free.begin(), free.end()), hit);
    ASSERT_TRUE(stop);
    EXPECT_NEAR(*stop, 0.4, 2e-4);
    std::vector<double> pressed;
    for (const double y : hit) pressed.push_back(y - *stop);
    const auto level = hit_level(0, level_distribution(pressed, 0), level_distribution(free, 0), stop);
    const double p_hit = beyond(0.4, median, 0.5);
    for (const double y : {0.1, 0.2, 0.3, 0.38})
      EXPECT_NEAR(level.exceedance(y), beyond(y, median, 0.5), 0.012) << median << " " << y;
    for (const double y : {0.4015, 0.403, 0.406})
      EXPECT_NEAR(level.exceedance(y), p_hit * beyond(y - 0.4, 0.002, 0.5), 0.02) << median << " " << y;
    EXPECT_LT(level.exceedance(0.45), 1e-4) << "no tail runs through the stop";
  }
}

TEST(HitLevel, AStopLiesBetweenFreeRunsAndHits) {
  EXPECT_FALSE(stop_between(0.3, {}));
  EXPECT_FALSE(stop_between(0.41, {0.405, 0.42})) << "a run passes it that does not hit";
  EXPECT_DOUBLE_EQ(*stop_between(0.3, {0.4}), 0.3);
  EXPECT_DOUBLE_EQ(*stop_between(0.3, {0.4, 0.4, 0.4}), 0.3);
  for (const auto &hits : {std::vector{0.41, 0.42, 0.5}, {0.41, 0.49, 0.5}}) {
    EXPECT_GE(*stop_between(0.3, hits), 0.3);
    EXPECT_LT(*stop_between(0.3, hits), 0.41);
  }
}

TEST(HitLevel, WithoutHitsIsThePlainLevelAndCollapsesCount) {
  const std::vector<double> values{0.1, 0.2, 0.25, 0.4};
  const auto plain = level_distribution(values, 1);
  const auto apart = hit_level(1, {}, level_distribution(values, 0), std::nullopt);
  for (const double y : {0.05, 0.2, 0.5}) EXPECT_NEAR(apart.exceedance(y), plain.exceedance(y), 1e-15);
  const auto mixed = hit_level(2, level_distribution({3e6, 5e6}, 0), level_distribution({0.0, 0.0, 0.0, 0.0}, 0), {});
  EXPECT_DOUBLE_EQ(mixed.hit_share, 1 / 3.0);
  EXPECT_NEAR(mixed.exceedance(1.0), 2 / 8.0 + 6 / 8.0 / 3, 1e-12);
  EXPECT_EQ(hit_level(3, {}, {}, std::nullopt).exceedance(1e9), 1);
  expect_error<InputError>([&] { mixed.exceedance(0); }, {"limit 0", "> 0"});
  expect_error<InputError>([] { hit_level(0, {}, {}, std::nullopt); }, {"without runs"});
}
