// Laws as pure values: forces against formulas, derivatives against differences.
#include "reduced_models/friction_law.h"
#include "reduced_models/impact_law.h"
#include "scene/error.h"
#include "scenes.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;

namespace {

void expect_consistent_tangent(const ImpactLaw &law, double d, double rate, double speed) {
  const double k = 4.5e8, c = 1.7e6, h = 1e-7;
  const auto at = law.at(k, c, d, rate, speed);
  EXPECT_NEAR(at.d_penetration,
              (law.at(k, c, d + h, rate, speed).force - law.at(k, c, d - h, rate, speed).force) / (2 * h),
              1e-5 * k);
  EXPECT_NEAR(at.d_rate,
              (law.at(k, c, d, rate + h, speed).force - law.at(k, c, d, rate - h, speed).force) / (2 * h),
              1e-5 * c);
  EXPECT_NEAR(at.d_speed,
              (law.at(k, c, d, rate, speed + h).force - law.at(k, c, d, rate, speed - h).force) / (2 * h),
              1e-5 * c);
}

} // namespace

TEST(ImpactLaws, TangentsAgreeWithDifferences) {
  for (const auto &law : impact_laws())
    for (const double rate : {0.3, 0.0, -0.1, -0.9})
      expect_consistent_tangent(law, 1e-3, rate, std::abs(rate) + 0.05);
}

TEST(ImpactLaws, SignsInSeparation) {
  const double k = 4.5e8, c = 1.7e6, d = 1e-3, rate = -0.5;
  EXPECT_DOUBLE_EQ(impact_law("signed").at(k, c, d, rate, 0.5).force, k * d + c * rate);
  EXPECT_LT(impact_law("signed").at(k, c, d, rate, 0.5).force, 0);
  EXPECT_EQ(impact_law("no-tension").at(k, c, d, rate, 0.5).force, 0);
  EXPECT_DOUBLE_EQ(impact_law("printed").at(k, c, d, rate, 0.5).force, k * d + c * 0.5);
}

TEST(ImpactLaws, DampingOfTheThesis) {
  EXPECT_NEAR(damping_ratio(0.65), 0.13585, 5e-6); // notes, item 7
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_NEAR(damping_coefficient(4.5e8, 0.65, 86952), 2 * 0.13585 * std::sqrt(4.5e8 * 86952), 200);
  EXPECT_THROW(damping_ratio(0), InputError);
  EXPECT_THROW(damping_ratio(1.01), InputError);
  EXPECT_THROW(damping_ratio(std::nan("")), InputError);
}

TEST(FrictionCoefficient, VelocityLawAndSlope) {
  const FrictionCoefficient law{0.03, 0.08, 20};
  EXPECT_DOUBLE_EQ(law.at(0).value, 0.03);
  EXPECT_NEAR(law.at(0.1).value, 0.08 - 0.05 * std::exp(-2.0), 1e-15);
  EXPECT_NEAR(law.at(10).value, 0.08, 1e-12);
  EXPECT_NEAR(law.at(0.1).slope, (law.at(0.1 + 1e-6).value - law.at(0.1 - 1e-6).value) / 2e-6, 1e-8);
  const FrictionCoefficient constant{0.07, 0.07, std::nan("")}; // the rate must not matter
  EXPECT_EQ(constant.at(0.3).value, 0.07);
  EXPECT_NO_THROW(constant.validate());
}

TEST(FrictionCoefficient, RefusesWithNumbers) {
  try {
    FrictionCoefficient{0.12, 0.08, 20}.validate();
    FAIL();
  } catch (const InputError &e) {
    EXPECT_NE(std::string(e.what()).find("mu_slow 0.120000 exceeds mu_fast 0.080000"), std::string::npos);
  }
  EXPECT_THROW((FrictionCoefficient{-0.1, 0.08, 20}.validate()), InputError);
  EXPECT_THROW((FrictionCoefficient{0.05, 0.08, 0}.validate()), InputError);
}

TEST(ParkWen, StaysInTheUnitDiscAndIsRotationInvariant) {
  Eigen::Vector2d eta = Eigen::Vector2d::Zero();
  const double q = 1e-4, dt = 1e-6;
  for (int i = 0; i < 20000; ++i) {
    const double t = i * dt;
    eta += dt * park_wen_rate(eta, {0.3 * std::cos(300 * t), 0.2 * std::sin(500 * t)}, q);
    ASSERT_LE(eta.norm(), 1 + 1e-3); // explicit Euler overshoots
  }
  const Eigen::Rotation2D<double> turn(0.7);
  const Eigen::Vector2d v(0.2, -0.1), e(0.3, 0.5);
  EXPECT_NEAR((park_wen_rate(turn * e, turn * v, q) - turn * park_wen_rate(e, v, q)).norm(), 0, 1e-10);
  // steady sliding: along the velocity
  for (int i = 0; i < 20000; ++i) eta += dt * park_wen_rate(eta, v, q);
  EXPECT_NEAR((eta - v.normalized()).norm(), 0, 1e-9);
}

TEST(SmoothedFriction, DerivativeAgreesWithDifferencesAndTendsToCoulomb) {
  for (const bool socket : {false, true}) {
    scene::Scene s = reduced::testing::ricker();
    s.reduced.socket_friction = s.reduced.finite_pad = socket;
    s.reduced.mu_slow = 0.03, s.reduced.rate = 20;
    const PhysicalModel model(s);
    const auto p = model.height(0.3, 0.2);
    const Eigen::Vector3d u(0.3, 0.2, p.z), v(0.02, -0.05, p.gradient.dot(Eigen::Vector2d(0.02, -0.05)));
    const auto f = model.smoothed_friction(u, v, 8e5, 1e-2);
    for (int j = 0; j < 3; ++j) {
      const double h = 1e-6;
      const Eigen::Vector3d dv = h * Eigen::Vector3d::Unit(j);
      const Eigen::Vector3d slope = (model.smoothed_friction(u, v + dv, 8e5, 1e-2).force -
                                     model.smoothed_friction(u, v - dv, 8e5, 1e-2).force) /
                                    (2 * h);
      EXPECT_NEAR((f.d_velocity.col(j) - slope).norm(), 0, 1e-3 * f.d_velocity.norm()) << j;
      EXPECT_NEAR((f.d_velocity.col(j) - slope).norm(), 0, 2.0) << j;
    }
    EXPECT_LT(f.force.dot(v), 0);
    // sharp: the sliding force of the model itself
    BearingState state;
    state.u = u, state.v = v;
    const auto exact = model.forces(state);
    const auto sharp = model.smoothed_friction(u, v, exact.normal, 1e-9).force;
    EXPECT_NEAR((sharp - exact.friction).norm(), 0, 1e-6 * exact.friction.norm());
  }
}
