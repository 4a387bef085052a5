#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/riding_height.h"
#include "scene/stack_terms.h"
#include "scenes.h"
#include <gtest/gtest.h>
#include <numbers>

using namespace rimpact;
using namespace rimpact::reduced;

TEST(RidingHeight, PointContactIsTheDish) {
  const scene::Bearing bearing;
  const RidingHeight height(bearing);
  const reduced::testing::Ellipse ellipse;
  for (const double r : {0.0, 0.1, 0.39, 0.45}) {
    const auto p = height.at(0.6 * r, 0.8 * r);
    EXPECT_NEAR(p.z, ellipse.height(r), 1e-15);
    EXPECT_NEAR(p.gradient.norm(), ellipse.slope(r), 1e-14);
  }
}

/// A pad shaped to the dish's vertex and pressed on with its whole face rides on the mean of the height over it, and
/// the deeper the steeper the dish: by depth / cos^2, half of which its elastic energy gives back.
TEST(RidingHeight, SoftPadLiftsByTheSumOfTheCurvatures) {
  scene::Bearing bearing;
  bearing.ertalyte.E = 1e7, bearing.pad.shape_radius = 2.25;
  const double depth = 5e-4, modulus = 1e7 * 0.7 / (1.3 * 0.4);
  const RidingHeight point(bearing), pad(bearing, depth * modulus / bearing.pad.thickness * bearing.pad_area());
  const reduced::testing::Ellipse e;
  const double c = (std::pow(bearing.pad.outer_radius, 2) + std::pow(bearing.pad.inner_radius, 2)) / 8;
  for (const double r : {0.0, 1e-9, 0.05, 0.1, 0.15}) {
    const double lift = c * (e.meridional(r) + e.circumferential(r) - 2 / e.R0);
    EXPECT_NEAR(pad.at(r, 0).z - point.at(r, 0).z, lift - depth / 2 * std::pow(e.slope(r), 2), 0.05 * lift + 2e-8) << r;
  }
}

/// Slopes of the lift from another program (tests/reduced_models/pad_on_dish.py: other quadrature, another minimiser).
TEST(RidingHeight, PadLiftAgreesWithAnIndependentMinimum) {
  const scene::Bearing bearing;
  const RidingHeight point(bearing), pad(bearing, 853e3);
  for (const auto &[r, slope] : {std::pair{0.10, 0.000307}, {0.31, 0.002477}, {0.39, 0.007848}})
    EXPECT_NEAR(pad.at(r, 0).gradient[0] - point.at(r, 0).gradient[0], slope, 1e-5) << r;
}

TEST(RidingHeight, DerivativesAgreeWithDifferences) {
  const scene::Bearing bearing;
  const RidingHeight height(bearing, 853e3);
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
  bearing.surface = {.kind = scene::SurfaceKind::sphere, .R0 = 2.25, .a = 0.5625, .planar_radius = 0.52};
  const RidingHeight point(bearing), pad(bearing, 853e3);
  // a sphere has the same curvature everywhere: the pad turns with it, pressed a little deeper by the slope
  EXPECT_NEAR(pad.at(0.4, 0.1).z - point.at(0.4, 0.1).z, 0, 3e-5);
  EXPECT_NEAR((pad.at(0.4, 0.1).gradient - point.at(0.4, 0.1).gradient).norm(), 0, 1.5e-4);
}

TEST(RidingHeight, PlaneIsFlat) {
  const scene::Bearing bearing;
  const auto plane = RidingHeight::plane(bearing, 0.4);
  EXPECT_EQ(plane.at(3, 4).z, RidingHeight(bearing).at(0.4, 0).z);
  EXPECT_EQ(plane.at(3, 4).gradient.norm(), 0);
}

TEST(StackTerms, PadInShearGivesTheElasticSlip) {
  scene::Scene s;
  const double G = 3.2e9 / 2.6, area = std::numbers::pi * (0.07019 * 0.07019 - 0.02 * 0.02);
  EXPECT_NEAR(scene::pad_elastic_slip(s.bearing, 853e3, 0.07), 0.07 * 853e3 * 0.040 / (G * area), 1e-12);
  add_stack_terms(s);
  EXPECT_TRUE(s.reduced.finite_pad && s.reduced.socket_friction);
  EXPECT_EQ(s.reduced.friction, scene::Friction::park_wen);
  EXPECT_NEAR(s.reduced.elastic_slip, 1.365e-4, 1e-6);
  s.reduced.elastic_slip = 2e-4; // chosen: kept
  add_stack_terms(s);
  EXPECT_EQ(s.reduced.elastic_slip, 2e-4);
  scene::Scene smooth;
  smooth.reduced.mu_fast = smooth.reduced.mu_slow = 0;
  add_stack_terms(smooth); // nothing to slip
  EXPECT_EQ(smooth.reduced.friction, scene::Friction::coulomb);
}
