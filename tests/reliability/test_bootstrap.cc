#include "io/files/error.h"
#include "studies/reliability/bootstrap.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

Statistic mean_of(const std::vector<double> &values) {
  return [values](const std::vector<int> &drawn) {
    double sum = 0;
    for (const int d : drawn) sum += values[d];
    return std::vector<double>{sum / static_cast<double>(drawn.size())};
  };
}

} // namespace

// The bootstrap's deviation of a mean is the sample's (over n) by the square root of n; 90 %: 1.645 of it.
TEST(Bootstrap, BandOfAMeanIsItsStandardError) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal(3, 2);
  std::vector<double> values(400);
  double mean = 0, squares = 0;
  for (double &v : values) mean += (v = normal(generator)) / 400;
  for (const double v : values) squares += (v - mean) * (v - mean) / 400;
  const auto band = bootstrap_band(400, mean_of(values), {.replicates = 4000});
  const double half = 1.6449 * std::sqrt(squares / 400);
  EXPECT_NEAR(band.low[0], mean - half, 0.06 * half);
  EXPECT_NEAR(band.high[0], mean + half, 0.06 * half);
}

TEST(Bootstrap, SeedDecidesAndOneRecordHasNoWidth) {
  const auto statistic = mean_of({1, 2, 4, 8});
  const Bootstrap one{.replicates = 50, .seed = 1}, two{.replicates = 50, .seed = 2};
  EXPECT_EQ(bootstrap_band(4, statistic, one).low, bootstrap_band(4, statistic, one).low);
  EXPECT_NE(bootstrap_band(4, statistic, one).high, bootstrap_band(4, statistic, two).high);
  const auto alone = bootstrap_band(1, statistic, one);
  EXPECT_EQ(alone.low[0], 1);
  EXPECT_EQ(alone.high[0], 1);
}

TEST(Bootstrap, Refusals) {
  EXPECT_THROW(bootstrap_band(0, mean_of({}), {}), InputError);
  EXPECT_THROW(bootstrap_band(1, mean_of({1}), {.replicates = 1}), InputError);
  EXPECT_THROW(bootstrap_band(1, mean_of({1}), {.confidence = 1}), InputError);
}
