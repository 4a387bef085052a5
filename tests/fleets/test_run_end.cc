#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "studies/fleets/run_end.h"
#include "tests/reduced_models/rigid_body/scenes.h"
#include <gtest/gtest.h>

namespace rimpact::fleets {
namespace {

RunEnd end_of(const scene::Scene &scene) {
  const Summary s = reduced::simulate_summary(scene);
  EXPECT_EQ(s.status, RunStatus::stopped) << s.reason;
  return run_end(parse<RowStatus>(word(s.status)), s.reason);
}

/// Models say in their own words that a bearing or a frame is at its end; statistics count such a run above all others.
TEST(RunEnd, OfWhatModelsSay) {
  scene::Scene off_the_dish = scene::load_scene("ricker-0.78g-1.0s", {"excitation.scale=3", "reduced.k_i_kN_per_m=0"});
  EXPECT_EQ(end_of(off_the_dish), RunEnd::beyond);
  EXPECT_EQ(end_of(scene::load_scene("ricker-0.78g-1.0s", {"excitation.scale=3"})), RunEnd::beyond); // over the rim
  EXPECT_EQ(end_of(reduced::testing::slender(0.8, 0.1)), RunEnd::beyond);                            // overturns
  EXPECT_EQ(end_of(reduced::testing::slender(1.5, 1e-4)), RunEnd::beyond); // leaves over a low rim
  scene::Scene softening = reduced::testing::shaken(scene::ModelKind::lir_dcfp, 0.5);
  softening.superstructure.kind = scene::StructureKind::bouc_wen, softening.superstructure.mass_ratio = 0.7;
  softening.superstructure.post_yield = -0.1, softening.superstructure.yield = 0.005;
  EXPECT_EQ(end_of(softening), RunEnd::beyond);
  scene::Scene welded = scene::load_scene(
      "ricker-0.78g-1.0s", {"bearing.rim.connection.kind=\"fillet\"", "bearing.rim.connection.throat_mm=8"});
  welded.reduced.foot_joint = scene::strength_in_words(welded.bearing.rim.connection), welded.reduced.foot_force = 1e5;
  EXPECT_EQ(end_of(welded), RunEnd::beyond); // breaks off
}

TEST(RunEnd, OfWhatIsNoEndOfTheStructure) {
  EXPECT_EQ(run_end(RowStatus::done, "left the dish"), RunEnd::done);
  EXPECT_EQ(run_end(RowStatus::stopped, "the time step became too small"), RunEnd::without_result);
  EXPECT_EQ(run_end(RowStatus::failed, "collapsed"), RunEnd::without_result);
  EXPECT_EQ(run_end(std::nullopt, ""), RunEnd::without_result);
}

} // namespace
} // namespace rimpact::fleets
