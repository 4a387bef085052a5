// What may go wrong in such a bearing, each with its outcome.
#include "scenes.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

scene::Scene shaken(const std::string &model, double amplitude_g) {
  scene::Scene s;
  s.reduced.model = model;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.load.mass = 2e5, s.load.vertical = s.load.mass * s.load.gravity;
  s.excitation.amplitude_g = amplitude_g, s.excitation.period = 1.5, s.excitation.centre = 3;
  return s;
}

double largest(const scene::Response &r, const char *name) {
  double value = 0;
  for (const double x : r.series(name)) value = std::max(value, std::abs(x));
  return value;
}

TEST(DoubleConcaveHardCases, AGapUsedUpIsStopped) {
  auto scene = shaken("lir-dcfp", 0.6);
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, "done") << run.summary.reason;
  EXPECT_GT(largest(run.response, "interface_slip_x"), scene.isolator.gap());
  EXPECT_LT(largest(run.response, "interface_slip_x"),
            scene.isolator.gap() + 1.2 * run.summary.peak_lateral_force / scene.reduced.k_i);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

TEST(DoubleConcaveHardCases, AnEdgeMayLift) {
  auto scene = shaken("dcfp", 0.8);
  scene.isolator.slider_diameter = 0.15, scene.isolator.top_height = scene.isolator.bottom_height = 0.12;
  scene.isolator.rim_height = 0.1;
  const auto run = simulate(scene);
  double smallest = 1e300;
  for (const auto &point : run.summary.extra["isolator"]["point_forces"])
    smallest = std::min(smallest, point["min_N"].get<double>());
  EXPECT_EQ(smallest, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

TEST(DoubleConcaveHardCases, ALowRimIsLeftAndSaidSo) {
  auto scene = shaken("dcfp", 1.5);
  scene.isolator.rim_height = 1e-4;
  scene.isolator.slider_diameter = 0.15, scene.isolator.top_height = scene.isolator.bottom_height = 0.12;
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, "stopped");
  EXPECT_NE(run.summary.reason.find("the slider has"), std::string::npos) << run.summary.reason;
}

TEST(DoubleConcaveHardCases, FrictionOfTheInterfaceNearThatOfTheDishes) {
  for (const double above : {-1e-3, 0.0, 1e-3}) {
    auto scene = shaken("lir-dcfp", 0.4);
    scene.isolator.mu_interface = 0.0528 + above;
    const auto run = simulate(scene);
    EXPECT_EQ(run.summary.status, "done");
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4) << above;
  }
}

TEST(DoubleConcaveHardCases, VerticalMotionLiftsTheMass) {
  auto scene = shaken("lir-dcfp", 0.3);
  scene.excitation.kind = ExcitationKind::record;
  scene.excitation.x = {0.01, {}}, scene.excitation.z = {0.01, {}};
  for (int i = 0; i < 150; ++i) {
    scene.excitation.x.values.push_back(1.0 * std::sin(4 * i * 0.01));
    scene.excitation.z.values.push_back(11.5 * std::sin(20 * i * 0.01));
  }
  scene.excitation.duration = 1.5;
  scene.isolator.step_tolerance = 1e-6; // landings
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, "done") << run.summary.reason;
  EXPECT_EQ(*run.summary.min_normal_force, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

} // namespace
} // namespace rimpact::reduced::testing
