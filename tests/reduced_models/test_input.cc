// Catalogues, refusals, and inputs that must not matter.
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/catalogue.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

TEST(Input, UnknownNamesListTheKnown) {
  try {
    laws::impact_law("sign");
    ADD_FAILURE() << "accepted";
  } catch (const InputError &e) {
    EXPECT_STREQ(e.what(), "reduced.impact_law \"sign\" is unknown; known: signed, no-tension, printed, hunt-crossley, "
                           "elastoplastic, bilinear, curve");
  }
  for (const auto &model : reduced_models()) EXPECT_FALSE(model.description.empty());
  EXPECT_EQ(laws::impact_laws().size(), 7u);
}

TEST(Input, TheRimBeginsBetweenTheMiddleAndTheDishsEdge) {
  const auto load = [](double offset) { // L_c is 95 mm, the edge at 135 mm
    return scene::load_scene("ricker-0.78g-1.0s", {"bearing.name=\"shfps-appendix-a\"",
                                                   "reduced.capacity_offset_mm=" + std::to_string(offset)});
  };
  EXPECT_THROW(load(-95), InputError);
  EXPECT_THROW(load(40), InputError);
  EXPECT_NO_THROW(load(-94));
}

/// Corners of what is allowed end as results, not as faults.
TEST(Input, CornersOfWhatIsAllowedAreRun) {
  const auto next_to_nothing = scene::load_scene("frame-four-dof", {"superstructure.mass_ratio=0.99999"});
  EXPECT_EQ(simulate_summary(next_to_nothing).status, RunStatus::done); // a base of 1e-5 of the mass
  scene::Scene s = free_motion({1e-4, 0}, {0, 0});
  set_friction(s, 0);
  s.reduced.finite_pad = true; // at 0.1 mm its ring lies lower than at rest
  const auto run = simulate_summary(s);
  EXPECT_EQ(run.status, RunStatus::done) << run.reason;
}

TEST(Input, PoisonInUnusedInputsDoesNotMatter) {
  const double nan = std::nan("");
  scene::Scene s = ricker(1.05);
  const auto clean = simulate_summary(s);
  s.reduced.elastic_slip = s.reduced.rate = nan;
  s.reduced.impact_exponent = s.reduced.reference_speed = s.reduced.yield_force = nan;
  s.reduced.hardening = s.reduced.hardening_exponent = s.reduced.unloading_gain = s.reduced.unloading_exponent = nan;
  s.bearing.contact = {nan, nan, nan, nan, nan, nan, nan, nan, scene::PadFoot::tied};
  s.bearing.pad = {nan, nan, nan, nan, nan};
  s.bearing.foot = {nan, nan, nan, nan};
  s.bearing.steel.E = s.bearing.rim.height = s.bearing.rim.thickness = nan;
  s.excitation.amplitude = s.excitation.cycles = s.excitation.travel = s.excitation.speed = nan;
  s.excitation.initial_displacement.setConstant(nan);
  s.excitation.initial_velocity.setConstant(nan);
  s.model.step = s.model.rho_inf = nan;
  s.reduced.vertical_restitution = nan; // no uplift at this scale
  const auto poisoned = simulate_summary(s);
  EXPECT_EQ(poisoned.peak_displacement, clean.peak_displacement);
  EXPECT_EQ(*poisoned.peak_impact_force, *clean.peak_impact_force);

  scene::Scene no_rim = ricker(0.9);
  const double travel = simulate_summary(no_rim).peak_displacement;
  no_rim.reduced.k_i = 0;
  no_rim.reduced.restitution = nan;
  EXPECT_NEAR(simulate_summary(no_rim).peak_displacement, travel, 1e-9);
}

TEST(Input, LeavingTheDishStopsWithASentence) {
  scene::Scene s = ricker(3);
  s.reduced.k_i = 0;
  const auto run = simulate(s);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("left the dish"), std::string::npos) << run.summary.reason;
  run.response.check();
  EXPECT_GT(run.response.size(), 100u);
}

TEST(Input, StiffAndSoftRimsRun) {
  for (const double k : {1e6, 1e7, 1e10, 1e12}) {
    scene::Scene s = ricker(1.05, 4);
    s.reduced.k_i = k;
    const auto summary = simulate_summary(s);
    EXPECT_EQ(summary.status, RunStatus::done) << k << summary.reason;
    EXPECT_LT(std::abs(summary.energy->imbalance_relative()), 1e-6) << k;
    EXPECT_FALSE(summary.impacts.empty());
  }
}
