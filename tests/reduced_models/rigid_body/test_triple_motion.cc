// The triple pendulum in time: energy, uplift, space, what it becomes where its inner slider sticks, friction's laws.
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/simulate.h"
#include "scene/isolator_catalogue.h"
#include "scenes.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

/// The tested specimen, its rims made high, under a Ricker pulse; 0.4 g takes it into its rims.
scene::Scene driven(double amplitude_g) {
  scene::Scene s;
  s.reduced.model = scene::ModelKind::tfp, s.isolator = scene::builtin_isolator("tfp-fenz-2008");
  s.load.vertical = 112e3, s.load.mass = s.load.vertical / s.load.gravity;
  s.isolator.rim_height = 0.05, s.isolator.inner.rim_height = 0.03;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.reduced.k_i = 5e6, s.reduced.impact_law = &laws::impact_law("hunt-crossley");
  s.reduced.impact_exponent = 1, s.reduced.reference_speed = 0.4;
  s.excitation.amplitude_g = amplitude_g, s.excitation.period = 0.8, s.excitation.centre = 1.6;
  s.excitation.duration = 5;
  return s;
}

double at(const Response &r, const char *name, double t) {
  const auto &time = r.series("time"), &value = r.series(name);
  const std::size_t i = std::upper_bound(time.begin(), time.end() - 1, t) - time.begin();
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + share * (value[i] - value[i - 1]);
}

TEST(TripleMotion, EnergyBalancesBeforeAndAtItsRims) {
  for (const double amplitude : {0.2, 0.45}) {
    const auto run = simulate(driven(amplitude));
    ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4) << amplitude;
    const auto &faces = run.summary.extra["isolator"]["faces"];
    EXPECT_EQ(faces[0]["rim_touched_s"].is_null(), amplitude < 0.3);
    EXPECT_EQ(faces[1]["rim_touched_s"].is_null(), amplitude < 0.3);
  }
}

TEST(TripleMotion, ComesBackFromUplift) {
  auto s = driven(0.1);
  s.excitation.kind = ExcitationKind::record;
  s.excitation.x = {0.01, {}}, s.excitation.z = {0.01, {}};
  for (int i = 0; i < 150; ++i) {
    s.excitation.x.values.push_back(1.0 * std::sin(4 * i * 0.01));
    s.excitation.z.values.push_back(11.5 * std::sin(20 * i * 0.01));
  }
  s.excitation.duration = 1.5, s.isolator.step_tolerance = 1e-6;
  const auto run = simulate(s);
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_EQ(*run.summary.min_normal_force, 0);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-3);
}

TEST(TripleMotion, IsTheSameInEveryDirection) {
  auto s = driven(0.4);
  s.isolator.space = scene::Space::spatial, s.isolator.points = 8, s.excitation.duration = 3;
  const auto along = simulate(s).summary;
  ASSERT_EQ(along.status, RunStatus::done) << along.reason;
  s.excitation.direction_deg = 30;
  const auto turned = simulate(s).summary;
  EXPECT_NEAR(turned.peak_displacement / along.peak_displacement, 1, 0.01);
  EXPECT_NEAR(turned.peak_lateral_force / along.peak_lateral_force, 1, 0.02);
}

/// With an inner slider that sticks, the three sliders are one, as high as all together; but for the springs of its
/// contacts, on which it rocks.
TEST(TripleMotion, WithAStickingInnerSliderIsADoubleConcaveBearing) {
  auto s = driven(0.25);
  auto &b = s.isolator;
  b.mu_of = scene::FrictionOf::faces, b.inner.mu_fast = b.inner.mu_slow = 1, b.contact_stiffness = 2e11;
  b.top_mu_fast = b.top_mu_slow = 0.05;
  b.slider_mass = b.inner.mass = 0.05;
  const auto triple = simulate(s);
  s.reduced.model = scene::ModelKind::dcfp, b.capacity = 0.2, b.slider_mass = 0.15;
  const auto one = simulate(s);
  ASSERT_EQ(one.summary.status, RunStatus::done) << one.summary.reason;
  EXPECT_GT(one.summary.peak_displacement, 0.03);
  EXPECT_NEAR(triple.summary.peak_displacement / one.summary.peak_displacement, 1, 2e-3);
  EXPECT_NEAR(triple.summary.peak_lateral_force / one.summary.peak_lateral_force, 1, 5e-3);
  for (double t = 0.5; t < 5; t += 0.1)
    ASSERT_NEAR(at(triple.response, "displacement_x", t), at(one.response, "displacement_x", t),
                5e-3 * one.summary.peak_displacement)
        << t;
}

/// A linear spring at each rim: its force is k of its own penetration.
scene::Scene on_springs(double k_outer, double k_inner) {
  auto s = driven(0.45);
  s.reduced.impact_law = &laws::impact_law("no-tension"), s.reduced.restitution = 1, s.reduced.k_i = k_outer;
  s.isolator.inner.own_rims = true;
  auto &inner = s.isolator.inner.rims;
  inner.impact_law = s.reduced.impact_law, inner.restitution = 1, inner.k_i = k_inner;
  return s;
}

TEST(TripleMotion, InnerRimsMayHaveALawOfTheirOwn) {
  const double k[] = {5e6, 2e7, 2e7, 5e6};
  const auto run = simulate(on_springs(k[0], k[1]));
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
  for (int i = 0; i < 4; ++i) {
    const auto &face = run.summary.extra["isolator"]["faces"][i];
    const double force = face["rim_peak_force_N"], penetration = face["rim_peak_penetration_m"];
    EXPECT_NEAR(force / penetration / k[i], 1, 1e-6) << i;
  }
  auto alike = on_springs(k[0], k[0]);
  const double own = simulate(alike).summary.peak_lateral_force;
  alike.isolator.inner.own_rims = false;
  EXPECT_EQ(simulate(alike).summary.peak_lateral_force, own) << "the same law, given once or twice";
}

/// Springs in series: each is pressed with a_i = R_eff,i / R_i of the bearing's force. The dashpots are in the
/// proportion of the springs, so that all together return e.
TEST(TripleMotion, UnlikeRimsStandInSeries) {
  auto s = on_springs(5e6, 2e7);
  s.reduced.restitution = s.isolator.inner.rims.restitution = 0.5;
  const rigid::RigidBearing bearing(s);
  double flexibility = 0;
  const auto faces = scene::triple_faces(s.isolator);
  for (int i = 0; i < 4; ++i)
    flexibility += std::pow(faces[i].effective_radius() / faces[i].radius, 2) / (i == 1 || i == 2 ? 2e7 : 5e6);
  EXPECT_NEAR(bearing.parts.stop_stiffness * flexibility, 1, 1e-12);
  const double k = bearing.parts.stop_stiffness, c = laws::damping_coefficient(k, 0.5, s.load.mass);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(bearing.system.rim[i].damping / bearing.system.rim[i].stiffness / (c / k), 1, 1e-12);
  s.isolator.inner.rims.k_i = 0;
  double outer = 0;
  for (const int i : {0, 3}) outer += std::pow(faces[i].effective_radius() / faces[i].radius, 2) / 5e6;
  EXPECT_NEAR(rigid::RigidBearing(s).parts.stop_stiffness * outer, 1, 1e-12) << "of those that are there";
}

TEST(TripleMotion, AnInnerRimBreaksOffByItsOwnFoot) {
  auto s = on_springs(5e6, 2e7);
  s.isolator.inner.rims.foot_force = 1e4, s.isolator.inner.rims.foot_joint = "welds";
  const auto run = simulate(s);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("welds, goes at 10 kN"), std::string::npos) << run.summary.reason;
  EXPECT_GT(run.summary.extra["isolator"]["faces"][0]["rim_peak_force_N"].get<double>(), 1e4)
      << "the foot of the outer rim is another one";
  s.isolator.inner.rims.forget_foot();
  s.reduced.foot_force = 1e4, s.reduced.foot_joint = "bolts";
  const auto outer = simulate(s);
  EXPECT_NE(outer.summary.reason.find("bolts, goes at 10 kN"), std::string::npos) << outer.summary.reason;
  EXPECT_LT(outer.summary.extra["isolator"]["faces"][0]["rim_peak_force_N"].get<double>(), 2e4);
}

TEST(TripleMotion, FrictionFollowsSpeedPressureAndHeatOfEveryFace) {
  auto s = driven(0.2);
  const double constant = simulate(s).summary.peak_displacement;
  s.reduced.mu_slow = 0.025, s.isolator.inner.mu_slow = 0.01, s.isolator.top_mu_slow = 0.05, s.reduced.rate = 50;
  EXPECT_GT(simulate(s).summary.peak_displacement, 1.005 * constant);
  s = driven(0.2);
  s.reduced.measured.reference_pressure = 5e6; // below that of every face: less friction
  EXPECT_GT(simulate(s).summary.peak_displacement, 1.005 * constant);
  s = driven(0.2);
  s.reduced.measured.by_temperature = true;
  const auto warm = simulate(s);
  EXPECT_GT(warm.summary.peak_displacement, constant);
  double inner = 0, bottom = 0;
  for (const double T : warm.response.series("temperature_inner")) inner = std::max(inner, T);
  for (const double T : warm.response.series("temperature")) bottom = std::max(bottom, T);
  EXPECT_GT(inner, 21);
  EXPECT_GT(bottom, 21);
}

} // namespace
} // namespace rimpact::reduced::testing
