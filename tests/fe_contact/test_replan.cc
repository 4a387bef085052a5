// A run that comes to the rim where none is meshed goes on from there on a mesh that has it.
#include "fe_contact/drive/run.h"
#include "planning/plan.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

/// A window whose plan meshed the wrong side, against the right one.
TEST(Replan, AWindowGoesOnOnAMeshThatHasTheRimItComesTo) {
  const scene::Scene scene =
      scene::load_scene("impact-window", {"excitation.with=[\"weight\",\"friction\"]", "excitation.speed_m_per_s=0.1",
                                          "model.rung=\"rigid-dish\"", "model.mesh=0", "excitation.duration_s=0.03"});
  planning::Plan plan = planning::make_plan(scene);
  ASSERT_TRUE(plan.half);
  RunOptions options;
  options.writes = false;
  const Summary right = run(scene, plan, options);
  plan.sectors = {M_PI};
  const Summary replanned = run(scene, plan, options);
  ASSERT_EQ(replanned.extra.at("warnings").size(), 1u);
  EXPECT_NE(replanned.extra.at("warnings")[0].get<std::string>().find("replanned"), std::string::npos);
  ASSERT_EQ(right.impacts.size(), 1u);
  ASSERT_EQ(replanned.impacts.size(), 1u);
  EXPECT_NEAR(replanned.impacts[0].peak_force, right.impacts[0].peak_force, 0.01 * right.impacts[0].peak_force);
  EXPECT_NEAR(replanned.impacts[0].rebound_speed, right.impacts[0].rebound_speed,
              0.01 * right.impacts[0].approach_speed);
  EXPECT_LT(replanned.energy->imbalance_relative(), 1e-3);
}

} // namespace
} // namespace rimpact::fe
