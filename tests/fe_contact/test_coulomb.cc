// The point law of frictional contact and the exact surfaces it is used with.
#include "fe_contact/laws/coulomb.h"
#include "fe_contact/laws/master_surface.h"
#include "scene/bearing.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const CoulombContact law{2e9, 1e9, FrictionCoefficient::constant(0.3)};

TEST(Coulomb, OpenPointCarriesNothing) {
  const auto r = law.at<double>(1e-6, Vector3d::UnitZ(), Vector3d(1e-3, 0, 0), 1e3, Vector3d(100, 0, 0), 0.1);
  EXPECT_EQ(r.status, ContactStatus::open);
  EXPECT_EQ(r.traction.norm(), 0);
}

TEST(Coulomb, SticksBelowTheLimitAsASpring) {
  const auto r = law.at<double>(-1e-6, Vector3d::UnitZ(), Vector3d(3e-7, -1e-7, 5.0), 500, Vector3d(20, 30, 0), 0.1);
  EXPECT_EQ(r.status, ContactStatus::stick);
  EXPECT_DOUBLE_EQ(r.pressure, 2500);
  EXPECT_TRUE(r.friction.isApprox(Vector3d(20 - 300, 30 + 100, 0), 1e-12)); // 309 Pa below 0.3 x 2500
}

TEST(Coulomb, SlipsAtTheLimitAgainstTheSlip) {
  const auto r = law.at<double>(-1e-6, Vector3d::UnitZ(), Vector3d(3e-3, 4e-3, 0), 0, Vector3d::Zero(), 0.1);
  EXPECT_EQ(r.status, ContactStatus::slip);
  EXPECT_TRUE(r.friction.isApprox(-0.3 * 2000 * Vector3d(0.6, 0.8, 0), 1e-12));
}

TEST(Coulomb, FrictionlessIsACaseOfIt) {
  const CoulombContact smooth{2e9, 1e9};
  const auto r = smooth.at<double>(-1e-6, Vector3d::UnitZ(), Vector3d(3e-3, 0, 0), 0, Vector3d::Zero(), 0.1);
  EXPECT_TRUE(r.traction.isApprox(Vector3d(0, 0, 2000), 1e-14));
}

TEST(Coulomb, DoesNotDependOnTheFrame) {
  const Matrix3d Q = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vector3d slip(2e-6, -1e-6, 1e-7), multiplier(40, 70, 0);
  const auto a = law.at<double>(-1e-6, Vector3d::UnitZ(), slip, 10, multiplier, 0.1);
  const auto b = law.at<double>(-1e-6, Vector3d(Q.col(2)), Vector3d(Q * slip), 10, Vector3d(Q * multiplier), 0.1);
  EXPECT_TRUE((Q * a.traction).isApprox(b.traction, 1e-12));
}

/// 0.7^(0.02 (p - p0)) at the point's own pressure; the slipping traction's derivative by the gap is that of mu(p) p.
TEST(Coulomb, FrictionFollowsThePressureAtThePoint) {
  const CoulombContact pad{2e9, 1e9, {0.10, 0.10, 0, 20e6}};
  const auto limit = [&](double pressure) {
    const auto r = pad.at<double>(-pressure / 2e9, Vector3d::UnitZ(), Vector3d(1, 0, 0), 0, Vector3d::Zero(), 0.1);
    EXPECT_EQ(r.status, ContactStatus::slip);
    return r.friction.norm();
  };
  for (const double p : {1e6, 20e6, 80e6}) EXPECT_NEAR(limit(p) / p, 0.10 * std::pow(0.7, 0.02e-6 * (p - 20e6)), 1e-12);
  EXPECT_NEAR((limit(40e6 + 1) - limit(40e6 - 1)) / 2, (1 + 0.8 * std::log(0.7)) * 0.10 * std::pow(0.7, 0.4), 1e-8);
}

TEST(Coulomb, FrictionFollowsTheSpeedOfSlip) {
  const CoulombContact teflon{2e9, 1e9, {0.10, 0.04, 20}};
  for (const double speed : {0.0, 0.01, 0.1, 1.0}) {
    const double dt = 1e-3;
    const auto r =
        teflon.at<double>(-1e-3, Vector3d::UnitZ(), Vector3d(speed * dt + 1e-30, 0, 0), 0, Vector3d(-1e6, 0, 0), dt);
    EXPECT_NEAR(r.friction.norm() / r.pressure, 0.10 - 0.06 * std::exp(-20 * speed), 1e-9) << speed;
  }
  const auto still = teflon.at<double>(-1e-3, Vector3d::UnitZ(), Vector3d(1, 0, 0), 0, Vector3d::Zero(), 0.0);
  EXPECT_NEAR(still.friction.norm() / still.pressure, 0.04, 1e-12); // no speed in a static step
}

struct Surfaces : ::testing::TestWithParam<int> {
  static MasterSurface make(int kind) {
    switch (kind) {
    case 0:
      return plane({0.1, 0, 0.2}, {1, 2, 3});
    case 1:
      return sphere({0, 0, 1}, 1.0, Side::inside);
    case 2:
      return sphere({0, 0, -1}, 1.0, Side::outside);
    case 3:
      return cylinder({0, 0, 1.0}, {1, 0.5, 0}, 1.2, Side::inside);
    default:
      return dish(scene::make_surface(scene::Bearing{}.surface), 0.5);
    }
  }
};

TEST_P(Surfaces, NormalIsTheGapsGradientAndCurvatureItsHessian) {
  const MasterSurface surface = make(GetParam());
  for (const Vector3d &x : {Vector3d(0.12, -0.05, 0.03), Vector3d(-0.3, 0.2, 0.08), Vector3d(0.31, 0.02, 0.02)}) {
    const Distance d = surface.distance(x);
    EXPECT_NEAR(d.normal.norm(), 1, 1e-12);
    EXPECT_LT((d.curvature - d.curvature.transpose()).norm(), 1e-9 * (1 + d.curvature.norm()));
    const double h = 1e-5;
    for (int i = 0; i < 3; ++i) {
      const Distance up = surface.distance(x + h * Vector3d::Unit(i)),
                     down = surface.distance(x - h * Vector3d::Unit(i));
      EXPECT_NEAR((up.gap - down.gap) / (2 * h), d.normal[i], 1e-8);
      EXPECT_LT(((up.normal - down.normal) / (2 * h) - d.curvature.col(i)).norm(), 1e-6);
    }
    // The foot of the perpendicular lies on the surface.
    EXPECT_NEAR(surface.distance(x - d.gap * d.normal).gap, 0, 1e-12);
  }
}
INSTANTIATE_TEST_SUITE_P(Kinds, Surfaces, ::testing::Range(0, 5));

} // namespace
} // namespace rimpact::fe
