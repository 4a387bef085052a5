// The mass on the pad's spring (reduced.normal_force = "pad").
#include "io/files/error.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "scene/stack_terms.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::reduced {
namespace {

scene::Scene sprung(const std::string &scene, std::vector<std::string> more = {}) {
  more.insert(more.end(), {"reduced.normal_force=pad", "reduced.friction=park-wen"});
  return scene::load_scene(scene, more);
}

TEST(PadSpring, AMassRaisedAtTheVertexSwingsAtTheRootOfStiffnessOverMass) {
  scene::Scene s = sprung("ricker-0.78g-1.0s", {"excitation.scale=1e-12", "reduced.output_step_ms=0.1"});
  BearingState start;
  start.u = {0, 0, 2e-4};
  const double omega = std::sqrt(scene::pad_stiffness(s.bearing) / s.load.mass),
               still = s.load.vertical / omega / omega / s.load.mass;
  ASSERT_LT(start.u.z(), still); // it never leaves the pad
  const auto run = simulate_from(s, start, 0.3);
  const auto &t = run.response.series("time"), &z = run.response.series("displacement_z"),
             &normal = run.response.series("normal_force");
  for (std::size_t i = 0; i < t.size(); ++i) {
    EXPECT_NEAR(z[i], 2e-4 * std::cos(omega * t[i]), 1e-9) << t[i];
    EXPECT_NEAR(normal[i] / s.load.vertical, 1 - z[i] / still, 1e-6) << t[i];
  }
}

TEST(PadSpring, AMassThrownOffThePadFlies) {
  scene::Scene s = sprung("ricker-0.78g-1.0s", {"excitation.scale=1e-12", "reduced.output_step_ms=0.1"});
  BearingState start;
  start.v = {0, 0, 0.2};
  const auto run = simulate_from(s, start, 0.05);
  const auto &normal = run.response.series("normal_force"), &z = run.response.series("displacement_z");
  EXPECT_EQ(*std::min_element(normal.begin(), normal.end()), 0);
  const double k = scene::pad_stiffness(s.bearing), m = s.load.mass, g = s.load.gravity, still = m * g / k;
  const double at_leaving = 0.04 - 2 * g * still + k / m * still * still; // v^2 where the spring bears nothing
  EXPECT_NEAR(*std::max_element(z.begin(), z.end()), still + at_leaving / (2 * g), 1e-6);
}

TEST(PadSpring, AStiffOneIsTheMassThatRidesTheDish) {
  const std::vector<std::string> struck{"excitation.scale=1.05", "reduced.friction=park-wen"};
  const auto rigid = simulate(scene::load_scene("ricker-0.78g-1.0s", struck)).summary;
  scene::Scene s = sprung("ricker-0.78g-1.0s", {"excitation.scale=1.05"});
  s.bearing.ertalyte.E *= 300;
  const auto stiff = simulate(s).summary;
  ASSERT_EQ(stiff.impacts.size(), rigid.impacts.size());
  EXPECT_NEAR(stiff.impacts[0].approach_speed, rigid.impacts[0].approach_speed, 2e-3);
  EXPECT_NEAR(stiff.impacts[0].peak_force / rigid.impacts[0].peak_force, 1, 5e-3);
}

TEST(PadSpring, TheLedgerBalancesOverAnImpact) {
  for (const std::string law : {"no-tension", "elastoplastic"}) {
    const auto run = simulate(sprung("ricker-0.78g-1.0s", {"excitation.scale=1.05", "reduced.impact_law=" + law}));
    ASSERT_FALSE(run.summary.impacts.empty());
    EXPECT_LT(std::abs(run.summary.energy.value().imbalance_relative()), 1e-6) << law;
  }
}

TEST(PadSpring, CvodeAgrees) {
  for (const char *loss : {"0", "0.05"}) {
    const auto s =
        sprung("ricker-0.78g-1.0s", {"excitation.scale=1.05", std::string("bearing.pad.loss_factor=") + loss});
    const auto own = simulate(s).summary, other = simulate_with_cvode(s).summary;
    ASSERT_EQ(own.impacts.size(), other.impacts.size());
    EXPECT_NEAR(own.impacts[0].touch_time, other.impacts[0].touch_time, 1e-6);
    EXPECT_NEAR(own.impacts[0].peak_force / other.impacts[0].peak_force, 1, 1e-4);
  }
}

TEST(DampedPad, ASwingDiesByHalfTheLossFactorAndTheLedgerHasIt) {
  constexpr double loss = 0.1, ratio = loss / 2;
  scene::Scene s = sprung("ricker-0.78g-1.0s", {"excitation.scale=1e-12", "reduced.output_step_ms=0.1"});
  s.bearing.pad.loss_factor = loss;
  BearingState start;
  start.u = {0, 0, 2e-4};
  const double omega = std::sqrt(scene::pad_stiffness(s.bearing) / s.load.mass),
               damped = omega * std::sqrt(1 - ratio * ratio), force = omega * omega * s.load.mass;
  const auto run = simulate_from(s, start, 0.3);
  const auto &t = run.response.series("time"), &z = run.response.series("displacement_z"),
             &lost = run.response.series("energy_damping");
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double left = 2e-4 * std::exp(-ratio * omega * t[i]);
    EXPECT_NEAR(z[i], left * (std::cos(damped * t[i]) + ratio * omega / damped * std::sin(damped * t[i])), 1e-9);
  }
  EXPECT_NEAR(lost.back() / (0.5 * force * 2e-4 * 2e-4), 1 - std::exp(-2 * ratio * omega * 0.3), 0.02);
  EXPECT_LT(std::abs(run.summary.energy.value().imbalance_relative()), 1e-5);
}

TEST(DampedPad, AMassThrownOffComesToRest) {
  scene::Scene s = sprung("ricker-0.78g-1.0s", {"excitation.scale=1e-12"});
  BearingState start;
  start.v = {0, 0, 0.2};
  const double put_in = 0.5 * s.load.mass * 0.04;
  for (const double loss : {0.0, 0.1}) {
    s.bearing.pad.loss_factor = loss;
    const auto run = simulate_from(s, start, 3);
    const auto &moving = run.response.series("energy_kinetic"), &t = run.response.series("time");
    double late = 0; // in the last half second
    for (std::size_t i = 0; i < t.size(); ++i)
      if (t[i] > 2.5) late = std::max(late, moving[i]);
    if (loss > 0) {
      EXPECT_LT(late, 1e-3 * put_in);
      EXPECT_NEAR(run.response.series("energy_damping").back() / put_in, 1, 2e-3);
    } else {
      EXPECT_GT(late, 0.9 * put_in); // without any it bounces on
    }
    EXPECT_LT(std::abs(run.summary.energy.value().imbalance_relative()), 2e-4); // what is lost is a quadrature
  }
}

TEST(DampedPad, ItsLedgerBalancesOverAnImpactAndItTakesLittleOfTheRimsForce) {
  const std::string struck = "excitation.scale=1.05";
  const auto without = simulate(sprung("ricker-0.78g-1.0s", {struck})).summary;
  const auto with = simulate(sprung("ricker-0.78g-1.0s", {struck, "bearing.pad.loss_factor=0.05"})).summary;
  ASSERT_FALSE(with.impacts.empty());
  EXPECT_GT(with.energy->damping, 0);
  EXPECT_EQ(without.energy->damping, 0);
  EXPECT_LT(std::abs(with.energy->imbalance_relative()), 1e-6);
  EXPECT_NEAR(with.impacts[0].peak_force / without.impacts[0].peak_force, 1, 0.02);
}

TEST(PadSpring, NeedsFrictionWithAnElasticSlip) {
  try {
    scene::load_scene("ricker-0.78g-1.0s", {"reduced.normal_force=pad"});
    FAIL() << "a sticking slider below a bouncing mass is no branch of the model's";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("park-wen"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace rimpact::reduced
