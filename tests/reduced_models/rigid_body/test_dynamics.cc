// Whole histories: against the physical model on a sphere of radius R_eff, energy, space, number of points.
#include "quasi_static_loop.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

/// A pulse on the default double concave bearing; its slider as good as weightless.
scene::Scene pulse(scene::ModelKind model, double amplitude_g) {
  scene::Scene s;
  s.reduced.model = model;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.load.vertical = 2e5 * s.load.gravity, s.load.mass = 2e5;
  s.isolator.slider_mass = 0.1;
  s.excitation.amplitude_g = amplitude_g, s.excitation.period = 1.5, s.excitation.centre = 3;
  return s;
}

scene::Scene spatial(scene::Scene s, int points, double direction_deg) {
  s.isolator.space = scene::Space::spatial, s.isolator.points = points;
  s.excitation.direction_deg = direction_deg;
  s.excitation.duration = 4.5; // past the second impact
  return s;
}

/// The same as a mass on a sphere: u = R_eff sin(theta) whatever the slider does, friction at mu_e.
scene::Scene as_sphere(const scene::Scene &given, double mu) {
  scene::Scene s = given;
  const auto &b = given.isolator;
  s.reduced.model = scene::ModelKind::physical;
  s.bearing.surface = {.kind = scene::SurfaceKind::sphere, .R0 = b.effective_radius()};
  s.bearing.surface.planar_radius = b.capacity + s.bearing.slider.diameter / 2;
  s.reduced.mu_fast = s.reduced.mu_slow = effective_friction(b, mu);
  // Two rims in series, each penetrated by R cos(theta + phi) / (R_eff cos(theta)) of the travel beyond C_t.
  const double share =
      b.radius * std::cos(b.rim_tilt() + b.edge_angle()) / (b.effective_radius() * std::cos(b.rim_tilt()));
  s.reduced.k_i = 2 * given.reduced.k_i * share * share;
  return s;
}

double value_at(const Response &r, const char *name, double t) {
  const auto &time = r.series("time"), &value = r.series(name);
  const std::size_t i = std::upper_bound(time.begin(), time.end() - 1, t) - time.begin();
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return value[i - 1] + share * (value[i] - value[i - 1]);
}

TEST(DoubleConcaveMotion, FollowsTheSphereOfItsEffectiveRadius) {
  for (const double amplitude : {0.15, 0.2}) {
    auto scene = pulse(scene::ModelKind::dcfp, amplitude);
    scene.isolator.contact_stiffness = 1e11; // as good as rigid
    const auto run = simulate(scene), sphere = simulate(as_sphere(scene, 0.05));
    ASSERT_TRUE(sphere.summary.impacts.empty());
    EXPECT_NEAR(run.summary.peak_displacement, sphere.summary.peak_displacement,
                2e-3 * sphere.summary.peak_displacement);
    EXPECT_NEAR(run.summary.peak_lateral_force, sphere.summary.peak_lateral_force,
                5e-3 * sphere.summary.peak_lateral_force);
    for (double t = 0.1; t < 7.9; t += 0.1)
      ASSERT_NEAR(value_at(run.response, "displacement_x", t), value_at(sphere.response, "displacement_x", t),
                  5e-3 * sphere.summary.peak_displacement)
          << t;
  }
}

TEST(DoubleConcaveMotion, AnImpactIsThatOfOneRimWithTheStiffnessOfBoth) {
  const auto scene = pulse(scene::ModelKind::dcfp, 0.6);
  const auto run = simulate(scene), sphere = simulate(as_sphere(scene, 0.05));
  ASSERT_FALSE(sphere.summary.impacts.empty());
  ASSERT_FALSE(run.summary.impacts.empty());
  const auto &first = run.summary.impacts[0], &expected = sphere.summary.impacts[0];
  EXPECT_NEAR(first.touch_time, expected.touch_time, 2e-3);
  EXPECT_NEAR(first.approach_speed, expected.approach_speed, 0.01 * expected.approach_speed);
  EXPECT_NEAR(first.rebound_speed, expected.rebound_speed, 0.05 * expected.approach_speed);
  EXPECT_NEAR(run.summary.peak_displacement, sphere.summary.peak_displacement, 2e-3);
}

TEST(DoubleConcaveMotion, ADashpotOfTheBearingsOwnMassReturnsNearlyAll) {
  auto scene = pulse(scene::ModelKind::dcfp, 0.6);
  scene.isolator.slider_mass = 100;
  const auto returned = [&] {
    const auto run = simulate(scene);
    const auto &first = run.summary.impacts.at(0);
    return first.rebound_speed / first.approach_speed;
  };
  const double supported = returned();
  scene.isolator.damped_mass = scene::DampedMass::bearing; // a thousandth of the supported mass: xi is 30 times smaller
  EXPECT_GT(returned(), supported + 0.2);
}

TEST(DoubleConcaveMotion, EnergyBalances) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp})
    for (const double amplitude : {0.3, 0.6}) {
      auto scene = pulse(model, amplitude);
      scene.isolator.slider_mass = 100;
      EXPECT_LT(std::abs(simulate(scene).summary.energy->imbalance_relative()), 1e-4) << word(model) << amplitude;
    }
}

TEST(DoubleConcaveMotion, TheStepToleranceGovernsTheError) {
  auto scene = pulse(scene::ModelKind::lir_dcfp, 0.6);
  const auto at = [&](double tolerance) {
    scene.isolator.step_tolerance = tolerance;
    return simulate(scene).summary;
  };
  const auto reference = at(1e-6), fine = at(1e-5), coarse = at(1e-4);
  EXPECT_NEAR(coarse.peak_lateral_force, reference.peak_lateral_force, 0.01 * reference.peak_lateral_force);
  EXPECT_NEAR(fine.peak_lateral_force, reference.peak_lateral_force, 0.002 * reference.peak_lateral_force);
  EXPECT_LT(coarse.n_steps, fine.n_steps);
}

/// Where a dashpot's force begins, its peak is c v at the touch: at the tolerance a scene file has by default every
/// later peak is met as well.
TEST(DoubleConcaveMotion, ADashpotsPeakAtTheTouchIsMetAtTheUsualTolerance) {
  scene::Scene scene;
  scene.reduced.model = scene::ModelKind::lir_dcfp, scene.reduced.mu_fast = scene.reduced.mu_slow = 0.06,
  scene.reduced.k_i = 4e7;
  scene.load.vertical = 4905e3, scene.load.mass = 5e5;
  scene.excitation.amplitude_g = 0.45, scene.excitation.period = 1.5, scene.excitation.centre = 3,
  scene.excitation.duration = 6;
  auto &b = scene.isolator;
  b.radius = 1.175, b.capacity = 0.25, b.slider_diameter = 0.3, b.top_height = b.bottom_height = 0.05;
  b.top_wall = 0.06, b.bottom_wall = 0.01, b.mu_interface = 0.14, b.space = scene::Space::spatial, b.points = 8;
  const auto at = [&](double tolerance) {
    b.step_tolerance = tolerance;
    return simulate(scene).summary;
  };
  const double by_default = scene::parse_scene("[reduced]\nmodel = \"lir-dcfp\"\n", "s.toml").isolator.step_tolerance;
  const auto usual = at(by_default), fine = at(1e-7);
  ASSERT_EQ(usual.impacts.size(), 2u);
  ASSERT_EQ(fine.impacts.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(usual.impacts[i].peak_force, fine.impacts[i].peak_force, 0.005 * fine.impacts[i].peak_force) << i;
    EXPECT_NEAR(usual.impacts[i].touch_time, fine.impacts[i].touch_time, 1e-4);
  }
}

/// Samples far apart miss the farthest travel, steps do not.
TEST(DoubleConcaveMotion, ThePeaksAreThoseOfStepsNotOfSamples) {
  auto scene = pulse(scene::ModelKind::dcfp, 0.5);
  const auto dense = simulate(scene).summary;
  for (const double step : {0.3, 10.0}) { // the last is longer than the scene
    scene.reduced.output_step = step;
    const auto run = simulate(scene);
    const auto &sparse = run.summary;
    EXPECT_NEAR(sparse.peak_displacement, dense.peak_displacement, 1e-3 * dense.peak_displacement);
    EXPECT_NEAR(sparse.peak_lateral_force, dense.peak_lateral_force, 5e-3 * dense.peak_lateral_force);
    EXPECT_NEAR(*sparse.min_normal_force, *dense.min_normal_force, 1e-3 * scene.load.vertical);
    EXPECT_NEAR(sparse.peak_vertical_displacement, dense.peak_vertical_displacement,
                1e-3 * dense.peak_vertical_displacement);
    EXPECT_NEAR(run.response.series("time").back(), scene.excitation.duration, 1e-9);
    EXPECT_LT(sparse.n_steps, dense.n_steps);
  }
}

/// Of the mass: the dashpot's jump at touch may throw the light slider back for some microseconds first.
int n_impacts(const Summary &summary) {
  return std::count_if(summary.impacts.begin(), summary.impacts.end(),
                       [](const Impact &i) { return i.release_time - i.touch_time > 1e-3; });
}

TEST(DoubleConcaveMotion, SpaceDoesNotPreferADirection) {
  const auto along = simulate(spatial(pulse(scene::ModelKind::lir_dcfp, 0.5), 8, 0)).summary;
  ASSERT_GT(n_impacts(along), 0);
  for (const double degrees : {45.0, 200.0}) {
    const auto turned = simulate(spatial(pulse(scene::ModelKind::lir_dcfp, 0.5), 8, degrees)).summary;
    EXPECT_NEAR(turned.peak_displacement, along.peak_displacement, 0.01 * along.peak_displacement);
    EXPECT_NEAR(turned.peak_lateral_force, along.peak_lateral_force, 0.015 * along.peak_lateral_force);
    EXPECT_EQ(n_impacts(turned), n_impacts(along));
  }
}

TEST(DoubleConcaveMotion, EightPointsAreEnough) {
  const auto at = [](int points) {
    return simulate(spatial(pulse(scene::ModelKind::lir_dcfp, 0.5), points, 20)).summary;
  };
  const auto eight = at(8), twelve = at(12);
  EXPECT_NEAR(eight.peak_displacement, twelve.peak_displacement, 0.01 * twelve.peak_displacement);
  EXPECT_NEAR(eight.peak_lateral_force, twelve.peak_lateral_force, 0.01 * twelve.peak_lateral_force);
}

TEST(DoubleConcaveMotion, SpaceAlongXIsThePlane) {
  auto flat = pulse(scene::ModelKind::dcfp, 0.3);
  const auto plane = simulate(flat).summary, space = simulate(spatial(flat, 16, 0)).summary;
  EXPECT_NEAR(space.peak_displacement, plane.peak_displacement, 0.01 * plane.peak_displacement);
}

TEST(DoubleConcaveMotion, ParkWenTendsToCoulomb) {
  auto scene = pulse(scene::ModelKind::lir_dcfp, 0.3);
  const double coulomb = simulate(scene).summary.peak_displacement;
  scene.reduced.friction = scene::Friction::park_wen;
  double last = 1;
  for (const double slip : {1e-3, 1e-4}) {
    scene.reduced.elastic_slip = slip;
    const double difference = std::abs(simulate(scene).summary.peak_displacement - coulomb);
    EXPECT_LT(difference, last);
    last = difference;
  }
  EXPECT_LT(last, 0.01 * coulomb);
}

} // namespace
} // namespace rimpact::reduced::testing
