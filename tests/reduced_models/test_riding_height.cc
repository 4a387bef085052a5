#include "reduced_models/riding_height.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;

TEST(RidingHeight, PointContactIsTheDish) {
  const scene::Bearing bearing;
  const RidingHeight height(bearing, false);
  const reduced::testing::Ellipse ellipse;
  for (const double r : {0.0, 0.1, 0.39, 0.45}) {
    const auto p = height.at(0.6 * r, 0.8 * r);
    EXPECT_NEAR(p.z, ellipse.height(r), 1e-15);
    EXPECT_NEAR(p.gradient.norm(), ellipse.slope(r), 1e-14);
  }
}

TEST(RidingHeight, PadLiftIsTheFormulaOfTheCurvatures) {
  const scene::Bearing bearing;
  const RidingHeight point(bearing, false), pad(bearing, true);
  const reduced::testing::Ellipse e;
  const double c = (std::pow(bearing.pad.outer_radius, 2) + std::pow(bearing.pad.inner_radius, 2)) / 8;
  for (const double r : {0.0, 1e-9, 0.05, 0.2, 0.39, 0.42}) {
    const double lift = c * (e.meridional(r) + e.circumferential(r) - 2 / e.R0);
    EXPECT_NEAR(pad.at(r, 0).z - point.at(r, 0).z, lift, 1e-14) << r;
  }
}

TEST(RidingHeight, DerivativesAgreeWithDifferences) {
  const scene::Bearing bearing;
  const RidingHeight height(bearing, true);
  const double h = 1e-5;
  for (const Eigen::Vector2d &u : {Eigen::Vector2d(0, 0), {0.1, -0.2}, {0.39, 0.0}, {-0.3, 0.28}}) {
    const auto p = height.at(u[0], u[1]);
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector2d d = h * Eigen::Vector2d::Unit(j), up = u + d, down = u - d;
      const auto pu = height.at(up[0], up[1]), pd = height.at(down[0], down[1]);
      EXPECT_NEAR(p.gradient[j], (pu.z - pd.z) / (2 * h), 1e-8);
      EXPECT_NEAR((p.hessian.col(j) - (pu.gradient - pd.gradient) / (2 * h)).norm(), 0, 2e-7);
    }
  }
}

TEST(RidingHeight, AnotherDishNeedsNoOtherNodes) {
  scene::Bearing bearing;
  bearing.surface = {"sphere", 2.25, 0.5625, 0.52};
  const RidingHeight point(bearing, false), pad(bearing, true);
  // a sphere has the same curvature everywhere: no lift, no slope
  EXPECT_NEAR(pad.at(0.4, 0.1).z - point.at(0.4, 0.1).z, 0, 1e-15);
  EXPECT_NEAR((pad.at(0.4, 0.1).hessian - point.at(0.4, 0.1).hessian).norm(), 0, 1e-9);
}

TEST(RidingHeight, PlaneIsFlat) {
  const scene::Bearing bearing;
  const auto plane = RidingHeight::plane(bearing, 0.4);
  EXPECT_EQ(plane.at(3, 4).z, RidingHeight(bearing, false).at(0.4, 0).z);
  EXPECT_EQ(plane.at(3, 4).gradient.norm(), 0);
}
