// Where the joint at the rim's foot goes, every reduced model stops: against closed forms, and alike in all of them.
#include "../scene/temporary_folder.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/rim_curve_file.h"
#include "reduced_models/record/run_doubts.h"
#include "reduced_models/simulate.h"
#include "rigid_body/scenes.h"
#include "scene/rim_identity.h"
#include "scenes.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

/// Welds whose use passes 1 at this force of the rim [N].
void weld(scene::Scene &s, std::optional<double> force) {
  s.bearing.rim.connection.kind = scene::ConnectionKind::fillet, s.bearing.rim.connection.throat = 0.010;
  s.reduced.foot_joint = scene::strength_in_words(s.bearing.rim.connection), s.reduced.foot_force = force;
}

/// A spring without a dashpot: F = v sqrt(k m) sin(w t), w = sqrt(k / m).
scene::Scene spring(double speed) {
  scene::Scene s = window(speed);
  s.reduced.restitution = 1;
  return s;
}

bool broke_off(const Summary &s) {
  return s.status == RunStatus::stopped && s.reason.find("the rim breaks off its plate") != std::string::npos;
}

} // namespace

TEST(FootLimit, ASpringsRunStopsWhereItsForceIsThere) {
  scene::Scene s = spring(0.3);
  const double k = s.reduced.k_i, m = s.load.mass, peak = 0.3 * std::sqrt(k * m), rate = std::sqrt(k / m);
  const auto whole = simulate(s);
  weld(s, 0.6 * peak);
  for (const bool by_cvode : {false, true}) {
    const auto run = by_cvode ? simulate_with_cvode(s) : simulate(s);
    ASSERT_TRUE(broke_off(run.summary)) << run.summary.reason;
    EXPECT_NE(run.summary.reason.find("two fillet welds with a throat of 10 mm"), std::string::npos);
    EXPECT_NE(run.summary.reason.find(fmt::format("{:.4g} kN", 0.6 * peak / 1e3)), std::string::npos);
    // A step of a twentieth of the contact ends it: at most that late.
    const double touch = run.summary.impacts.at(0).touch_time, late = M_PI / rate / 20;
    EXPECT_GE(run.response.series("time").back(), touch + std::asin(0.6) / rate - late);
    EXPECT_LE(run.response.series("time").back(), touch + std::asin(0.6) / rate + late);
    EXPECT_LT(*run.summary.peak_impact_force, (0.6 + std::sin(M_PI / 20)) * peak);
  }
  weld(s, 1.001 * peak); // borne: as if there were no joint, to the last digit
  const auto borne = simulate(s);
  EXPECT_EQ(borne.summary.status, RunStatus::done);
  EXPECT_EQ(borne.response.series("displacement_x"), whole.response.series("displacement_x"));
}

TEST(FootLimit, IsOfTheScenesOwnJointAlone) {
  scene::Scene s = spring(0.3);
  weld(s, 1e5);
  const auto doubted = [](const scene::Scene &scene) {
    auto run = simulate(scene);
    add_doubts(scene, run.response, run.summary);
    return run.summary.extra["warnings"].dump().find("bears these impacts is not known") != std::string::npos;
  };
  EXPECT_TRUE(broke_off(simulate_summary(s))) << "the sentence stands in the reason";
  EXPECT_FALSE(doubted(s));
  s.bearing.rim.connection.throat = 0.012; // thicker than what was run
  EXPECT_EQ(simulate_summary(s).status, RunStatus::done);
  EXPECT_TRUE(doubted(s));
  s.reduced.forget_foot(); // numbers of nobody's runs
  EXPECT_TRUE(doubted(s));
  s.bearing.rim.connection = {};
  EXPECT_FALSE(doubted(s)) << "one piece with the plate";
  weld(s, {});
  EXPECT_FALSE(doubted(s)) << "borne as far as was run";
  weld(s, 1e5);
  EXPECT_EQ(simulate_summary(in_one_piece(s)).status, RunStatus::done) << "a scout";
}

TEST(FootLimit, APushedCurveHasItsOwn) {
  const TemporaryFolder folder;
  scene::Scene s = window(0.3);
  weld(s, {});
  s.reduced.forget_foot();
  const double k = 4e8;
  RimCurveFile file{.dish = linear_curve(k, 1.6e9, 8e-3),
                    .held = linear_curve(k, 1.6e9, 8e-3),
                    .strain = {},
                    .foot = {{0, 2e-3, 4e-3}, {0, 0.8, 1.6}}, // 1 at 2.5 mm
                    .joint = scene::strength_in_words(s.bearing.rim.connection),
                    .bearing = s.bearing.name,
                    .rim_identity = scene::rim_identity(s.bearing),
                    .rim_values = scene::rim_values(s.bearing),
                    .mesh = "made up",
                    .made_by = "test",
                    .errors = {0.01, 0.02}};
  s.reduced.impact_law = &laws::impact_law("curve"), s.reduced.impact_curve = folder / "welded.h5";
  write_rim_curve(file, s.reduced.impact_curve);
  EXPECT_NEAR(foot_limit(s).force / (k * 2.5e-3), 1, 1e-6);
  EXPECT_TRUE(broke_off(simulate_summary(s)));
  s.excitation.speed = 0.9 * 2.5e-3 * std::sqrt(k / s.load.mass); // stops at nine tenths of it
  EXPECT_EQ(simulate_summary(s).status, RunStatus::done);
  s.bearing.rim.connection.throat = 0.012;
  EXPECT_NE(doubt_of_foot(s).find("the law's numbers are of two fillet welds with a throat of 10 mm"),
            std::string::npos);
  file.foot = {{0, 2e-3}, {0, 0.8}}, s.bearing.rim.connection.throat = 0.010;
  s.reduced.impact_curve = folder / "borne.h5";
  write_rim_curve(file, s.reduced.impact_curve);
  EXPECT_FALSE(std::isfinite(foot_limit(s).force));
  EXPECT_TRUE(doubt_of_foot(s).empty());
}

TEST(FootLimit, APushEndsBeforeIt) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::push, s.excitation.travel = 4e-3;
  weld(s, 0.5 * s.reduced.k_i * 4e-3);
  const auto run = simulate(s);
  ASSERT_TRUE(broke_off(run.summary)) << run.summary.reason;
  EXPECT_LE(*run.summary.peak_impact_force, *s.reduced.foot_force);
  EXPECT_GT(*run.summary.peak_impact_force, 0.9 * *s.reduced.foot_force);
}

TEST(FootLimit, RigidBodiesHaveThatOfTheCalibration) {
  scene::Scene s = shaken(scene::ModelKind::dcfp, 0.5);
  const double peak = simulate_summary(s).peak_impact_force.value_or(0);
  ASSERT_GT(peak, 0);
  s.reduced.foot_joint = "two fillet welds", s.reduced.foot_force = 0.5 * peak;
  EXPECT_TRUE(broke_off(simulate_summary(s)));
  s.reduced.foot_force = 1.01 * peak;
  EXPECT_EQ(simulate_summary(s).status, RunStatus::done);
}
