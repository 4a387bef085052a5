// A run that comes to the rim where none is meshed goes on from there on a mesh that has it.
#include "fe_contact/drive/run.h"
#include "fe_contact/planning/plan.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

/// A pulse whose plan meshed the wrong side alone, against one that meshed both from the beginning.
TEST(Replan, APulseGoesOnOnAMeshThatHasTheRimItComesTo) {
  const scene::Scene scene =
      scene::load_scene("ricker-0.78g-1.0s", {"excitation.scale=1.05", "model.rung=\"rigid-dish\"", "model.mesh=0",
                                              "excitation.duration_s=2.5"});
  planning::Plan plan = planning::make_plan(scene);
  ASSERT_TRUE(plan.half);
  ASSERT_EQ(plan.sectors.size(), 1u);
  const double right_side = plan.sectors[0], wrong_side = right_side > 1 ? 0.0 : M_PI;
  RunOptions options;
  options.writes = false;
  plan.sectors = {wrong_side, right_side};
  const Summary both = run(scene, plan, options);
  plan.sectors = {wrong_side};
  const Summary replanned = run(scene, plan, options);
  const auto &warnings = replanned.extra.at("warnings");
  ASSERT_EQ(warnings.size(), both.extra.at("warnings").size() + 1) << warnings.dump(2);
  EXPECT_NE(warnings[0].get<std::string>().find("replanned"), std::string::npos);
  ASSERT_EQ(both.impacts.size(), 1u);
  ASSERT_EQ(replanned.impacts.size(), 1u);
  EXPECT_NEAR(replanned.impacts[0].peak_force, both.impacts[0].peak_force, 0.01 * both.impacts[0].peak_force);
  EXPECT_NEAR(replanned.impacts[0].rebound_speed, both.impacts[0].rebound_speed, 0.01 * both.impacts[0].approach_speed);
  EXPECT_LT(replanned.energy->imbalance_relative(), 1e-3);
}

} // namespace
} // namespace rimpact::fe
