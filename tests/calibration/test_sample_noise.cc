#include "calibration/data/sample_noise.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace rimpact::calibration {
namespace {

std::vector<double> white(int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(n);
  for (double &v : values) v = normal(generator);
  return values;
}

// a running mean of k independent errors has tau = k: an average of n of them knows as much as n / k
TEST(SampleNoise, OfARunningMeanIsItsLength) {
  for (const std::size_t k : {1, 3, 5}) {
    double sum = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto raw = white(2000, seed);
      std::vector<double> mean(raw.size() - k);
      for (std::size_t i = 0; i < mean.size(); ++i)
        for (std::size_t j = 0; j < k; ++j) mean[i] += 7 + raw[i + j];
      sum += correlation_of(mean, std::vector<bool>(mean.size(), true)) / 20;
    }
    EXPECT_NEAR(sum, k, 0.1 * static_cast<double>(k)) << k;
  }
}

TEST(SampleNoise, CountsWhatIsCounted) {
  auto values = white(400, 3);
  std::vector<bool> counted(values.size(), true);
  for (std::size_t i = 100; i < 200; ++i) values[i] = 50, counted[i] = false;
  EXPECT_EQ(correlation_of(values, counted), 1);
  EXPECT_GT(correlation_of(values, std::vector<bool>(values.size(), true)), 10);
  EXPECT_EQ(correlation_of({1, 2, 3}, {true, true, true}), 1);
}

TEST(SampleNoise, DigitsLeaveTheirRounding) {
  auto values = white(300, 5);
  EXPECT_EQ(noise_of_digits(values), 0); // no common step
  for (double &v : values) v = 0.07 * std::round(v / 0.07);
  EXPECT_NEAR(noise_of_digits(values), 0.07 / std::sqrt(12.0), 1e-12);
  for (double &v : values) v = std::round(100 * (4.0 / 3) * std::round(v / 0.07)) / 100; // a step that its text rounds
  EXPECT_NEAR(noise_of_digits(values), 4.0 / 3 / std::sqrt(12.0), 1e-3);
  EXPECT_EQ(noise_of_digits({}), 0);
  EXPECT_EQ(noise_of_digits({0, 0, 0}), 0);
  EXPECT_EQ(noise_of_digits({0, 0, 5, 0}), 0);
}

} // namespace
} // namespace rimpact::calibration
