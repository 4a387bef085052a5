#include "scene/excitation.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

TEST(Ricker, IsThePulseOfTheThesis) {
  EXPECT_DOUBLE_EQ(ricker_shape(2.0, 2.0, 1.0), 1.0);
  // Zeros at |t - t0| = T/(pi sqrt 2), minima -2 exp(-3/2) at T/pi sqrt(3/2).
  EXPECT_NEAR(ricker_shape(2 + 1 / (M_PI * std::sqrt(2.0)), 2, 1), 0, 1e-15);
  EXPECT_NEAR(ricker_shape(3 + 1.5 * std::sqrt(1.5) / M_PI, 3, 1.5), -2 * std::exp(-1.5), 1e-15);
  EXPECT_LT(std::abs(ricker_shape(0, 2, 1)), 1e-15) << "starts at rest when centred at 2 T_p";
}

TEST(GroundMotion, RickerAlongADirection) {
  Excitation e;
  e.scale = 1.05, e.direction_deg = 120;
  const GroundMotion motion(e, 9.81);
  const auto a = motion.acceleration(e.centre);
  EXPECT_NEAR(a.norm(), 1.05 * 0.78 * 9.81, 1e-12);
  EXPECT_NEAR(std::atan2(a.y(), a.x()) * 180 / M_PI, 120, 1e-10);
  EXPECT_TRUE(motion.breakpoints().empty());
}

TEST(GroundMotion, IsExactlyZeroAcrossAnAxis) {
  Excitation e;
  for (const double angle : {0.0, 180.0, -180.0, 360.0}) {
    e.direction_deg = angle;
    EXPECT_EQ(GroundMotion(e, 9.81).acceleration(2).y(), 0.0) << angle;
  }
  e.direction_deg = -90;
  EXPECT_EQ(e.direction(), Eigen::Vector2d(0, -1));
}

TEST(GroundMotion, WindowMovesTheGroundOnlyWhenAsked) {
  Excitation e;
  e.kind = ExcitationKind::window, e.centre = 0;
  EXPECT_EQ(GroundMotion(e, 9.81).acceleration(0), Eigen::Vector3d::Zero());
  e.with_ground = true;
  EXPECT_NEAR(GroundMotion(e, 9.81).acceleration(0).x(), 0.78 * 9.81, 1e-12);
}

TEST(SampledSignal, IsLinearBetweenSamplesAndZeroOutside) {
  const SampledSignal s{0.1, {1.0, 3.0, -1.0}};
  EXPECT_DOUBLE_EQ(s.duration(), 0.2);
  EXPECT_DOUBLE_EQ(s.at(0.0), 1.0);
  EXPECT_NEAR(s.at(0.025), 1.5, 1e-12);
  EXPECT_NEAR(s.at(0.15), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(s.at(0.2), -1.0);
  EXPECT_EQ(s.at(-1e-9), 0.0);
  EXPECT_EQ(s.at(0.2001), 0.0);
  EXPECT_EQ(SampledSignal{}.at(0), 0.0);
}

TEST(GroundMotion, RecordHasItsSamplingAsBreakpoints) {
  Excitation e;
  e.kind = ExcitationKind::record, e.scale = 0.5;
  e.x = {0.1, {1.0, 2.0, 3.0}}, e.y = {0.05, {4.0, 4.0, 4.0}}, e.z = {0.1, {2.0, 2.0}};
  const GroundMotion motion(e, 9.81);
  EXPECT_TRUE(motion.acceleration(0.05).isApprox(Eigen::Vector3d(0.75, 2.0, 1.0)));
  ASSERT_EQ(motion.breakpoints().size(), 4u); // 0, 0.05, 0.1, 0.2
  EXPECT_DOUBLE_EQ(motion.breakpoints()[3], 0.2);
}

TEST(GroundMotion, ComponentsOfOtherBeginningsAndStepsStayInStep) {
  Excitation e;
  e.kind = ExcitationKind::record;
  const auto motion = [](double t) { return 2 * t; }; // linear: the same whatever the sampling
  e.x = {0.1, {}, 0.0}, e.y = {0.25, {}, 0.5};
  for (int i = 0; i <= 20; ++i) e.x.values.push_back(motion(e.x.instant(i)));
  for (int i = 0; i <= 4; ++i) e.y.values.push_back(motion(e.y.instant(i)));
  const GroundMotion ground(e, 9.81);
  for (const double t : {0.5, 0.51, 0.9, 1.3, 1.5}) {
    EXPECT_NEAR(ground.acceleration(t).x(), motion(t), 1e-14);
    EXPECT_NEAR(ground.acceleration(t).y(), motion(t), 1e-14);
  }
  EXPECT_EQ(ground.acceleration(0.4999).y(), 0);
  EXPECT_EQ(ground.acceleration(1.5001).y(), 0);
  const auto &breaks = ground.breakpoints();
  for (const double t : {0.0, 0.5, 0.75, 1.25, 2.0})
    EXPECT_TRUE(std::any_of(breaks.begin(), breaks.end(), [&](double b) { return std::abs(b - t) < 1e-9; })) << t;
}

TEST(Path, FigureEightReachesOnePointTwoFiveAmplitudes) {
  Excitation e;
  e.kind = ExcitationKind::figure_eight, e.amplitude = 0.31;
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) largest = std::max(largest, prescribed_displacement(e, 0.4, i / 4000.0).norm());
  EXPECT_NEAR(largest, 1.25 * 0.31, 1e-6); // 0.387 m (thesis notes)
}

TEST(Path, CyclicIsASineAlongItsDirection) {
  Excitation e;
  e.kind = ExcitationKind::cyclic, e.amplitude = 0.3, e.cycles = 2, e.direction_deg = 90, e.scale = 1.1;
  EXPECT_NEAR(prescribed_displacement(e, 0.4, 0.125).y(), 0.33, 1e-12);
  EXPECT_NEAR(prescribed_displacement(e, 0.4, 0.375).y(), -0.33, 1e-12);
  EXPECT_EQ(prescribed_displacement(e, 0.4, 0.125).x(), 0.0);
  EXPECT_NEAR(prescribed_displacement(e, 0.4, 1).norm(), 0, 1e-12);
}

TEST(Path, PushGoesPastTouchAndComesBack) {
  Excitation e;
  e.kind = ExcitationKind::push, e.travel = 0.008;
  const auto at = [&](double s) { return prescribed_displacement(e, 0.4, s).x(); };
  const auto kinks = prescribed_breakpoints(e);
  ASSERT_EQ(kinks.size(), 2u);
  EXPECT_DOUBLE_EQ(at(0), 0);
  EXPECT_NEAR(at(kinks[0]), 0.400, 1e-15);
  EXPECT_NEAR(at(kinks[1]), 0.408, 1e-15);
  EXPECT_NEAR(at(1), 0.399, 1e-15);
  e.unload = false;
  EXPECT_NEAR(at(1), 0.408, 1e-15);
  EXPECT_NEAR(at(prescribed_breakpoints(e).front()), 0.400, 1e-15);
}

} // namespace
