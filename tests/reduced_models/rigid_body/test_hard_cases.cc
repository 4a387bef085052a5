// What may go wrong in such a bearing, each with its outcome.
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

double largest(const Response &r, const char *name) {
  double value = 0;
  for (const double x : r.series(name)) value = std::max(value, std::abs(x));
  return value;
}

TEST(DoubleConcaveHardCases, AGapUsedUpIsStopped) {
  auto scene = shaken(scene::ModelKind::lir_dcfp, 0.6);
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_GT(largest(run.response, "interface_slip_x"), scene.isolator.gap());
  EXPECT_LT(largest(run.response, "interface_slip_x"),
            scene.isolator.gap() + 1.2 * run.summary.peak_lateral_force / scene.reduced.k_i);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

TEST(DoubleConcaveHardCases, AnEdgeMayLift) {
  const auto run = simulate(slender(0.8, 0.1));
  double smallest = 1e300;
  for (const auto &point : run.summary.extra["isolator"]["point_forces"])
    smallest = std::min(smallest, point["min_N"].get<double>());
  EXPECT_EQ(smallest, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

TEST(DoubleConcaveHardCases, ALowRimIsLeftAndSaidSo) {
  const auto run = simulate(slender(1.5, 1e-4));
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("the slider has"), std::string::npos) << run.summary.reason;
}

TEST(DoubleConcaveHardCases, FrictionOfTheInterfaceNearThatOfTheDishes) {
  for (const double above : {-1e-3, 0.0, 1e-3}) {
    auto scene = shaken(scene::ModelKind::lir_dcfp, 0.4);
    scene.isolator.mu_interface = 0.0528 + above;
    const auto run = simulate(scene);
    EXPECT_EQ(run.summary.status, RunStatus::done);
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4) << above;
  }
}

TEST(DoubleConcaveHardCases, VerticalMotionLiftsTheMass) {
  const auto run = simulate(lifted());
  EXPECT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_EQ(*run.summary.min_normal_force, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
}

} // namespace
} // namespace rimpact::reduced::testing
