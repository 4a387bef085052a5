// Friction that is smooth at rest, with its tangent, and Park and Wen's state.
#include "laws/friction/regularised.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::friction;
using Eigen::Vector2d, Eigen::Vector3d;

TEST(Regularised, TangentAgreesWithDifferences) {
  FrictionLaw law{.mu_slow = 0.04, .mu_fast = 0.08, .rate = 30, .reference_pressure = 20e6};
  law.area = 0.012;
  const Vector3d n = Vector3d(-0.1, 0.2, 1).normalized();
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Vector3d v(0.03, -0.06, 0.01);
  const double N = 5e5, scale = 1e-2, h = 1e-6;
  const auto force = [&](const Vector3d &velocity, double normal) {
    return regularised(law, tangent, velocity, normal, 20, scale).force;
  };
  const auto f = regularised(law, tangent, v, N, 20, scale);
  for (int j = 0; j < 3; ++j) {
    const Vector3d dv = h * Vector3d::Unit(j), slope = (force(v + dv, N) - force(v - dv, N)) / (2 * h);
    EXPECT_NEAR((f.d_velocity.col(j) - slope).norm(), 0, 1e-6 * f.d_velocity.norm()) << j;
  }
  EXPECT_NEAR((f.d_normal - (force(v, N + 1) - force(v, N - 1)) / 2).norm(), 0, 1e-8);
  EXPECT_NEAR((force(v, N) / N + law.under(N, (tangent * v).norm(), 20).value * (tangent * v).normalized()).norm(), 0,
              0.03 * 0.08); // Coulomb's, less what the scale takes
  EXPECT_EQ(force(Vector3d::Zero(), N).norm(), 0);
}

TEST(ParkWen, StaysInTheUnitDiscAndIsRotationInvariant) {
  Vector2d eta = Vector2d::Zero();
  const double q = 1e-4, dt = 1e-6;
  for (int i = 0; i < 20000; ++i) {
    const double t = i * dt;
    eta += dt * park_wen_rate(eta, {0.3 * std::cos(300 * t), 0.2 * std::sin(500 * t)}, q);
    ASSERT_LE(eta.norm(), 1 + 1e-3); // explicit Euler overshoots
  }
  const Eigen::Rotation2D<double> turn(0.7);
  const Vector2d v(0.2, -0.1), e(0.3, 0.5);
  EXPECT_NEAR((park_wen_rate(turn * e, turn * v, q) - turn * park_wen_rate(e, v, q)).norm(), 0, 1e-10);
  // steady sliding: along the velocity
  for (int i = 0; i < 20000; ++i) eta += dt * park_wen_rate(eta, v, q);
  EXPECT_NEAR((eta - v.normalized()).norm(), 0, 1e-9);
}
