// The own stepper against SUNDIALS CVODE: other integrator, other event location, same branches.
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "scene/toml_writer.h"
#include "scenes.h"
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

void expect_same(scene::Scene s) {
  s.reduced.tolerance = 1e-10;
  const auto own = simulate(s), other = simulate_with_cvode(s);
  EXPECT_NEAR(own.summary.peak_displacement, other.summary.peak_displacement, 1e-6 * own.summary.peak_displacement);
  EXPECT_NEAR(own.summary.residual_displacement, other.summary.residual_displacement, 1e-6);
  ASSERT_EQ(own.summary.impacts.size(), other.summary.impacts.size());
  for (std::size_t i = 0; i < own.summary.impacts.size(); ++i) {
    EXPECT_NEAR(own.summary.impacts[i].touch_time, other.summary.impacts[i].touch_time, 1e-6);
    EXPECT_NEAR(own.summary.impacts[i].peak_force / other.summary.impacts[i].peak_force, 1, 1e-6);
    EXPECT_NEAR(own.summary.impacts[i].rebound_speed, other.summary.impacts[i].rebound_speed, 1e-6);
  }
  EXPECT_LT(std::abs(other.summary.energy->imbalance_relative()), 1e-6);
}

} // namespace

TEST(Cvode, Coulomb) {
  expect_same(ricker(1.05));
}
TEST(Cvode, UpliftAndTwoImpacts) {
  expect_same(ricker(1.4));
}
TEST(Cvode, NoTension) {
  scene::Scene s = ricker(1.4);
  s.reduced.impact_law = &laws::impact_law("no-tension");
  expect_same(s);
}
TEST(Cvode, LawsOfAYieldingRim) {
  for (const char *law : {"hunt-crossley", "elastoplastic"}) {
    SCOPED_TRACE(law);
    scene::Scene s = ricker(1.4);
    s.reduced.impact_law = &laws::impact_law(law);
    expect_same(s);
  }
}
TEST(Cvode, ParkWen) {
  scene::Scene s = ricker(1.05);
  s.reduced.friction = scene::Friction::park_wen;
  expect_same(s);
}
TEST(Cvode, TwoDirections) {
  expect_same(free_motion({0.35, 0}, {0.5, 2}));
}
TEST(Cvode, BidirectionalPulseWithManyStops) {
  scene::Scene s = scene::load_scene("pulse-bidirectional");
  expect_same(s);
  s.excitation.scale = 0.6;
  expect_same(s);
}
TEST(Cvode, ObliquePulse) {
  scene::Scene s = ricker(1.05);
  s.excitation.direction_deg = 37;
  expect_same(s);
}
TEST(Cvode, TwoDimensionalStopWithSocket) {
  // turns by more than a right angle while it comes to rest
  scene::Scene s = free_motion({0.00699383, -0.000866734}, {-0.251706, 0.584094}, 5);
  set_friction(s, 0.0813039);
  s.reduced.normal_force = scene::NormalForce::constant;
  s.reduced.finite_pad = s.reduced.socket_friction = true;
  expect_same(s);
}
TEST(Cvode, RecordsInThreeDirections) {
  const char *given = std::getenv("RIMPACT_RECORDS");
  const std::string folder = given ? given : RIMPACT_SHARED_RECORDS;
  if (!std::filesystem::exists(folder + "/RSN1086_NORTHR_SYL360.AT2"))
    GTEST_SKIP() << "no records in " << folder << " (set RIMPACT_RECORDS)";
  for (const char *scale : {"0.5", "0.86"}) {
    const scene::Scene s =
        scene::parse_scene(std::string("[excitation]\nkind = 'record'\nduration_s = 30\nscale = ") + scale +
                               "\nx = 'RSN1086_NORTHR_SYL360.AT2'\ny = 'RSN1086_NORTHR_SYL090.AT2'\n"
                               "z = 'RSN1086_NORTHR_SYL-UP.AT2'\n",
                           "test", {}, folder);
    expect_same(s);
  }
}
TEST(Cvode, PadAndSocket) {
  scene::Scene s = ricker(1.1);
  s.reduced.finite_pad = s.reduced.socket_friction = true;
  expect_same(s);
}
TEST(Cvode, RefusesQuasiStaticScenes) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::cyclic;
  EXPECT_THROW(simulate_with_cvode(s), InputError);
}

/// As a user asks for it: the run is CVODE's, and says by how much the own steps differ.
TEST(Cvode, IsAskedForByTheScene) {
  for (const char *law : {"signed", "hunt-crossley", "elastoplastic"}) {
    const auto scene = scene::load_scene("ricker-0.78g-1.0s", {"excitation.scale=1.05", "reduced.integrator=\"cvode\"",
                                                               std::string("reduced.impact_law=\"") + law + "\""});
    const auto run = reduced::simulate(scene);
    EXPECT_EQ(run.summary.peak_displacement, reduced::simulate_with_cvode(scene).summary.peak_displacement);
    const auto &check = run.summary.extra.at("integrator");
    ASSERT_GE(run.summary.impacts.size(), 1U) << law;
    EXPECT_LT(check.at("peak_displacement_difference_m").get<double>(), 1e-7) << law;
    EXPECT_LT(check.at("touch_time_difference_s").get<double>(), 1e-6) << law;
    EXPECT_LT(check.at("impact_force_difference").get<double>(), 1e-4) << law;
    EXPECT_EQ(scene::parse_scene(to_toml(scene), "again").reduced.integrator, scene::Integrator::cvode);
  }
  const auto refused = scene::load_scene("lir-dcfp-stages", {"reduced.integrator=\"cvode\""});
  EXPECT_THROW(reduced::simulate(refused), InputError);
  EXPECT_THROW(reduced::simulate(scene::load_scene("static-unidirectional", {"reduced.integrator=\"cvode\""})),
               InputError);
}
