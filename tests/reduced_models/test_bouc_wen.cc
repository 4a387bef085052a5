// The storey's hysteretic law by itself.
#include "reduced_models/structures/bouc_wen.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using Eigen::Matrix2d, Eigen::Vector2d;

namespace {

/// Force over k u_y after a straight path from rest to `drift`, by many small steps of the midpoint rule.
Vector2d along(const BoucWen &law, Vector2d z, const Vector2d &drift) {
  constexpr int n = 20000;
  const Vector2d v = drift / n;
  for (int i = 0; i < n; ++i) z += law.rate(z + law.rate(z, v) / 2, v);
  return z;
}

} // namespace

// n = 1, beta = gamma = 1/2: z' = (1 - z) / u_y on loading, z = 1 - exp(-d / u_y); unloading is a straight
// line.
TEST(BoucWen, ClosedFormOfExponentOne) {
  const BoucWen law{.yield = 0.02, .exponent = 1};
  const Vector2d z = along(law, {0, 0}, {0.03, 0});
  EXPECT_NEAR(z[0], 1 - std::exp(-1.5), 1e-8);
  EXPECT_NEAR(along(law, z, {-0.01, 0})[0], z[0] - 0.5, 1e-8);
}

// n = 2: z = tanh(d / u_y) on loading.
TEST(BoucWen, ClosedFormOfExponentTwo) {
  const BoucWen law{.yield = 0.02, .exponent = 2};
  EXPECT_NEAR(along(law, {0, 0}, {0.05, 0})[0], std::tanh(2.5), 1e-8);
  const BoucWen sharp{.yield = 0.02, .exponent = 40};
  EXPECT_NEAR(along(sharp, {0, 0}, {0.018, 0})[0], 0.9, 2e-3); // elastic-plastic in the limit
  EXPECT_NEAR(along(sharp, {0, 0}, {0.06, 0})[0], 1, 1e-8);
}

TEST(BoucWen, TheSameInEveryDirection) {
  const BoucWen law{.yield = 0.01, .exponent = 1.6, .beta = 0.7};
  const double c = std::cos(0.9), s = std::sin(0.9);
  Matrix2d turn;
  turn << c, -s, s, c;
  const Vector2d z{0.3, -0.5}, v{0.4, 0.2};
  EXPECT_LT((turn * law.rate(z, v) - law.rate(turn * z, turn * v)).norm(), 1e-12);
  const Vector2d edge = Vector2d(0.6, 0.8); // |z| = 1 moving outwards: it turns and does not grow
  EXPECT_NEAR(edge.dot(law.rate(edge, {1, 0.3})), 0, 1e-12);
}

TEST(BoucWen, SlopesAgainstDifferences) {
  for (const double exponent : {1.0, 1.6, 2.0, 7.0})
    for (const Vector2d &v : {Vector2d(0.4, 0.2), Vector2d(-0.4, 0.1)}) {
      const BoucWen law{.yield = 0.01, .exponent = exponent, .beta = 0.7};
      const Vector2d z{0.6, -0.35};
      const auto r = law.rate_and_slopes(z, v);
      const auto step = law.implicit_step(z, v, 0.02);
      EXPECT_LT((step.z - z - 0.02 * law.rate(step.z, v)).norm(), 1e-12);
      for (int i = 0; i < 2; ++i) {
        const Vector2d d = 1e-6 * Vector2d::Unit(i);
        EXPECT_LT((r.d_z.col(i) - (law.rate(z + d, v) - law.rate(z - d, v)) / 2e-6).norm(), 1e-5);
        EXPECT_LT((r.d_rate.col(i) - (law.rate(z, v + d) - law.rate(z, v - d)) / 2e-6).norm(), 1e-5);
        const Vector2d difference = (law.implicit_step(z, v + d, 0.02).z - law.implicit_step(z, v - d, 0.02).z) / 2e-6;
        EXPECT_LT((step.d_rate.col(i) - difference).norm(), 1e-6);
      }
    }
}

// Thesis Fig. 4-3c: the post-yield line r k d + (1 - r) k u_y falls to zero.
TEST(BoucWen, CollapseWhereTheStrengthIsGone) {
  EXPECT_DOUBLE_EQ((BoucWen{.yield = 0.02, .post_yield = -0.05}).collapse_drift(), 0.42);
  EXPECT_DOUBLE_EQ((BoucWen{.yield = 0.02, .post_yield = -0.1}).collapse_drift(), 0.22);
  EXPECT_TRUE(std::isinf((BoucWen{.yield = 0.02, .post_yield = 0.05}).collapse_drift()));
}
