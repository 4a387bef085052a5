#include "studies/fleets/sampling.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::fleets;

TEST(LatinHypercube, OnePointInEachStripOfEveryDimension) {
  for (const int n : {1, 7, 100}) {
    const auto points = latin_hypercube(3, n, 5);
    ASSERT_EQ(points.size(), std::size_t(n));
    for (int d = 0; d < 3; ++d) {
      std::vector<int> hits(n, 0);
      for (const auto &p : points) {
        ASSERT_GT(p[d], 0);
        ASSERT_LT(p[d], 1);
        ++hits[int(p[d] * n)];
      }
      EXPECT_EQ(hits, std::vector<int>(n, 1));
    }
  }
}

TEST(LatinHypercube, SeedDecides) {
  EXPECT_EQ(latin_hypercube(2, 10, 1), latin_hypercube(2, 10, 1));
  EXPECT_NE(latin_hypercube(2, 10, 1), latin_hypercube(2, 10, 2));
  // The generator's own standard fixes this: the 10000th number of mt19937_64 is 9981545732273789042.
  const auto p = latin_hypercube(1, 1, 5489);
  EXPECT_NEAR(p[0][0], 14514284786278117030.0 * 0x1p-64, 1e-15); // its first number
}

TEST(LatinHypercube, DimensionsAreNotCorrelated) {
  const auto points = latin_hypercube(2, 2000, 3);
  double sum = 0;
  for (const auto &p : points) sum += (p[0] - 0.5) * (p[1] - 0.5);
  EXPECT_LT(std::abs(sum / 2000 * 12), 4 / std::sqrt(2000.0)); // four standard errors of a correlation
}

TEST(Distribution, Quantiles) {
  const Distribution uniform{.low = 2, .high = 6};
  EXPECT_DOUBLE_EQ(uniform.quantile(0.25), 3);
  const Distribution log{.kind = Distribution::Kind::log_uniform, .low = 1, .high = 100};
  EXPECT_NEAR(log.quantile(0.5), 10, 1e-13);
  // cut off far out: the normal's own quantiles
  const Distribution wide{Distribution::Kind::normal, -100, 100, 1, 2};
  EXPECT_NEAR(wide.quantile(0.975), 1 + 2 * 1.959963984540054, 1e-12);
  EXPECT_NEAR(wide.quantile(0.5), 1, 1e-12);
  // the cut normal's distribution function gives p back
  const Distribution cut{Distribution::Kind::normal, 0.03, 0.07, 0.05, 0.0115};
  const auto normal_cdf = [](double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; };
  const auto F = [&](double x) {
    const double a = normal_cdf((0.03 - 0.05) / 0.0115), b = normal_cdf((0.07 - 0.05) / 0.0115);
    return (normal_cdf((x - 0.05) / 0.0115) - a) / (b - a);
  };
  for (const double p : {1e-9, 0.01, 0.3, 0.9, 1 - 1e-9}) EXPECT_NEAR(F(cut.quantile(p)), p, 1e-12);
  EXPECT_EQ(cut.quantile(0), 0.03);
  EXPECT_NEAR(cut.quantile(1), 0.07, 1e-15);
}
