#include "io/files/error.h"
#include "studies/fleets/correlation.h"
#include "studies/fleets/sampling.h"
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::fleets;

namespace {

using Points = std::vector<std::vector<double>>;

double correlation(const Points &points, int a, int b) {
  const boost::math::normal normal;
  double aa = 0, bb = 0, ab = 0;
  for (const auto &p : points) {
    const double x = boost::math::quantile(normal, p[a]), y = boost::math::quantile(normal, p[b]);
    aa += x * x, bb += y * y, ab += x * y;
  }
  return ab / std::sqrt(aa * bb);
}

std::vector<double> sorted(const Points &points, int dimension) {
  std::vector<double> values;
  for (const auto &p : points) values.push_back(p[dimension]);
  std::sort(values.begin(), values.end());
  return values;
}

} // namespace

TEST(Correlated, MeetsTheCorrelationsAndKeepsEveryStrip) {
  const Points target = {{1, 0.8, -0.3}, {0.8, 1, 0}, {-0.3, 0, 1}};
  const auto plain = fleets::latin_hypercube(3, 500, 11);
  const auto points = correlated(plain, target);
  for (int a = 0; a < 3; ++a) {
    EXPECT_EQ(sorted(points, a), sorted(plain, a));
    for (int b = 0; b < a; ++b) EXPECT_NEAR(correlation(points, a, b), target[a][b], 0.01) << a << b;
  }
}

TEST(Correlated, FewSamplesAreNearIt) {
  const auto points = correlated(fleets::latin_hypercube(2, 15, 3), {{1, 0.6}, {0.6, 1}});
  EXPECT_NEAR(correlation(points, 0, 1), 0.6, 0.15);
}

TEST(Correlated, Refusals) {
  const auto points = fleets::latin_hypercube(2, 15, 3);
  EXPECT_THROW(correlated(points, {{1}}), InputError);
  EXPECT_THROW(correlated(points, {{1, 0.5}, {0.4, 1}}), InputError);
  EXPECT_THROW(correlated(points, {{1, 1}, {1, 1}}), InputError);
  EXPECT_THROW(correlated(points, {{0.9, 0}, {0, 1}}), InputError);
  EXPECT_THROW(correlated(fleets::latin_hypercube(2, 2, 3), {{1, 0}, {0, 1}}), InputError);
  EXPECT_THROW(correlated({}, {}), InputError);
  // Each pair is possible, the three together are not.
  EXPECT_THROW(correlated(fleets::latin_hypercube(3, 15, 3), {{1, 0.9, -0.9}, {0.9, 1, 0.9}, {-0.9, 0.9, 1}}),
               InputError);
}
