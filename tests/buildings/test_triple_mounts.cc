// Triple pendulums under a building: against one bearing alone, beside dishes and double concave ones, and by name.
#include "buildings/frame_source.h"
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "scene/isolator_catalogue.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

/// On the specimen of Fenz and Constantinou under 160 kN; `scale` 1 presses all its rims.
scene::Scene triple_pulse(double scale) {
  return scene::load_scene("tfp-stages",
                           {"load.vertical_kN=160.0", "load.mass_kg=16309.888", "excitation.kind=\"ricker\"",
                            "excitation.amplitude_g=0.45", "excitation.period_s=0.8", "excitation.centre_s=1.6",
                            "excitation.duration_s=3.0", "excitation.scale=" + std::to_string(scale),
                            "isolator.space=\"spatial\"", "isolator.points=4", "isolator.step_tolerance=1e-4",
                            "reduced.friction=\"park-wen\"", "reduced.elastic_slip_mm=0.5", "reduced.k_i_kN_per_m=4e4",
                            "reduced.impact_law=\"hunt-crossley\"", "reduced.impact_exponent=1.0",
                            "reduced.reference_speed_m_per_s=0.4"});
}

Frame four_alike() {
  RegularBuilding b;
  b.x = {0, 8}, b.y = {0, 8};
  return make_frame(b);
}

} // namespace

TEST(TripleMounts, ARigidBlockOnFourAlikeIsOneBearing) {
  for (const double scale : {0.4, 1.0}) {
    const auto s = triple_pulse(scale);
    const auto whole = simulate(four_alike(), s).summary, one = reduced::simulate(s).summary;
    ASSERT_EQ(whole.status, RunStatus::done) << whole.reason;
    const double gap = one.peak_displacement - s.lateral_capacity();
    EXPECT_EQ(gap > 0, scale == 1.0);
    EXPECT_GT(one.peak_displacement, 0.03);
    EXPECT_NEAR(whole.peak_displacement, one.peak_displacement, 2e-3 * one.peak_displacement);
    EXPECT_NEAR(whole.peak_lateral_force / 4, one.peak_lateral_force, 0.01 * one.peak_lateral_force);
    EXPECT_LT(std::abs(whole.energy->imbalance_relative()), 1e-2);
  }
}

TEST(TripleMounts, StandBesideDishesAndDoubleConcaveOnes) {
  Frame f = four_alike();
  f.nodes[0].bearing = "tfp", f.nodes[1].bearing = "tfp-kim-2023", f.nodes[2].bearing = "dcfp";
  scene::Scene dish = triple_pulse(0.4);
  dish.reduced.model = scene::ModelKind::physical, dish.isolator.name.clear();
  dish.isolator.inner.own_rims = true, dish.isolator.inner.rims.k_i = 3e8;
  const auto bearings = bearings_of(f, dish);
  ASSERT_EQ(bearings.size(), 4U);
  EXPECT_EQ(bearings[0].isolator.name, scene::default_triple);
  EXPECT_EQ(bearings[1].isolator.name, "tfp-kim-2023");
  EXPECT_EQ(bearings[2].reduced.model, scene::ModelKind::dcfp);
  EXPECT_FALSE(bearings[3].rigid_bodies());
  for (const auto &s : bearings) EXPECT_EQ(s.isolator.space, scene::Space::spatial);
  for (const int i : {0, 1})
    EXPECT_EQ(bearings[i].inner_element().k_i, 3e8) << "as the scene's [reduced], its inner rims";
  const auto run = simulate(f, dish, bearings);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-2);
}
