// Slow loops against the closed form; appendix B's sequence of hits.
#include "quasi_static_loop.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using Column = const std::vector<double> &;

/// Where the model slides (the closed form has no elastic slip): away from turning points of the path.
constexpr double settled = 2e-4;

TEST(DoubleConcaveLoop, LowFrictionSlidingIsAtTheEffectiveFriction) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp}) {
    const auto scene = cyclic(specimen(model), 0.15);
    const auto run = simulate(scene);
    QuasiStaticLoop loop{scene.isolator, 0.066, scene.impact_resilient()};
    Column u = run.response.series("displacement_x"), F = run.response.series("force_x");
    ASSERT_EQ(run.summary.status, RunStatus::done);
    double since_turn = 0;
    for (std::size_t i = 1; i < u.size(); ++i) {
      const double sense = loop.sense, expected = loop.move(u[i]);
      since_turn = sense == loop.sense ? since_turn + std::abs(u[i] - u[i - 1]) : 0;
      if (since_turn > settled) {
        ASSERT_NEAR(-F[i] / scene.load.vertical, expected, 1e-4) << word(model) << " u " << u[i];
      }
    }
    EXPECT_EQ(run.summary.impacts.size(), 0u);
  }
}

TEST(DoubleConcaveLoop, TheEffectiveFrictionIsNotThatOfOneSurface) {
  const auto scene = specimen();
  const double mu_e = effective_friction(scene.isolator, 0.066), approximate = 0.066 * 2 * scene.isolator.radius /
                                                                               scene.isolator.effective_radius() /
                                                                               std::cos(scene.isolator.edge_angle());
  EXPECT_NEAR(mu_e, approximate, 1e-3 * approximate);
  EXPECT_GT(mu_e, 1.05 * 0.066);
}

/// A rigid slider tilts against both plates alike, so both faces slide at once: one slope W / (R_1 + R_2 - H),
/// frictions weighted by the radii. (An articulated one slides on the face of less friction first: Fenz and
/// Constantinou 2008.)
TEST(DoubleConcaveLoop, UnequalPlatesSlideTogetherAtTheFrictionWeightedByTheirRadii) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp})
    for (const auto space : {scene::Space::planar, scene::Space::spatial}) {
      auto scene = cyclic(specimen(model), 0.12);
      scene.isolator.top_radius = 1.1, scene.isolator.top_mu_fast = 0.03;
      scene.isolator.space = space, scene.isolator.points = space == scene::Space::planar ? 2 : 8;
      const auto run = simulate(scene);
      ASSERT_EQ(run.summary.status, RunStatus::done);
      QuasiStaticLoop loop{scene.isolator, 0.066, scene.impact_resilient()};
      EXPECT_NEAR(effective_friction(scene.isolator, 0.066, 0.03), (0.066 * 0.75 + 0.03 * 1.1) / (0.75 + 1.1 - 0.085),
                  5e-4);
      Column u = run.response.series("displacement_x"), F = run.response.series("force_x");
      const double off = space == scene::Space::planar ? 1e-4 : 4e-4; // eight points on a circle: their cosines differ
      double since_turn = 0;
      constexpr double both_slide =
          10 * settled; // after a turn the slider rocks on its contact springs until the second face slides too
      for (std::size_t i = 1; i < u.size(); ++i) {
        const double sense = loop.sense, expected = loop.move(u[i]);
        since_turn = sense == loop.sense ? since_turn + std::abs(u[i] - u[i - 1]) : 0;
        if (since_turn > both_slide) {
          ASSERT_NEAR(-F[i] / scene.load.vertical, expected, off) << word(model) << word(space) << " u " << u[i];
        }
      }
    }
}

/// The rim of the smaller capacity is touched first; from there the slider keeps its tilt and rides with its edge on
/// the other dish, F = W tan(alpha + atan mu), the stage of slope W / R of the other surface
/// (docs/theory/double-concave.md).
TEST(DoubleConcaveLoop, PastTheFirstRimTheSliderSlidesOnTheOtherDish) {
  auto scene = cyclic(specimen(scene::ModelKind::dcfp), 0.12);
  const auto &b = scene.isolator;
  scene.isolator.top_radius = 1.1, scene.isolator.top_mu_fast = 0.03, scene.isolator.top_capacity = 0.10;
  const auto run = simulate(scene);
  Column u = run.response.series("displacement_x"), F = run.response.series("force_x"),
         impact = run.response.series("impact_x"), gap = run.response.series("gap");
  std::size_t first = 0;
  while (first < u.size() && impact[first] == 0) ++first;
  ASSERT_LT(first, u.size());
  EXPECT_NEAR(u[first], 0.10, 3e-4);
  EXPECT_NEAR(gap[first], 0, 3e-4);
  int n_checked = 0;
  const double at_touch = std::sin(std::asin(0.10 / b.effective_radius()) + b.edge_angle());
  for (std::size_t i = first; u[i + 1] > u[i]; ++i) {
    if (u[i] < 0.103) continue; // the rim's spring and the slider update_mode
    const double alpha = std::asin(at_touch + (u[i] - 0.10) / b.radius);
    ASSERT_NEAR(-F[i] / scene.load.vertical, std::tan(alpha + std::atan(0.066)), 1.5e-3) << u[i];
    ++n_checked;
  }
  EXPECT_GT(n_checked, 50);
}

TEST(DoubleConcaveLoop, TheInterfaceSlidesAtItsOwnAngle) {
  const auto scene = cyclic(specimen(), 0.185);
  const auto run = simulate(scene);
  Column F = run.response.series("force_x"), tilt = run.response.series("tilt"),
         slip = run.response.series("interface_slip_x"), u = run.response.series("displacement_x");
  int n_sliding = 0, n_before = 0; // the mass settles vertically over the first samples of a slide
  for (std::size_t i = 1; i < u.size(); ++i) {
    n_before = std::abs(slip[i] - slip[i - 1]) < 1e-5 ? 0 : n_before + 1;
    if (n_before < 6) continue;
    const double sense = slip[i] > slip[i - 1] ? 1 : -1, theta = u[i] > 0 ? tilt[i] : -tilt[i];
    ASSERT_NEAR(-F[i] / scene.load.vertical, std::tan(theta + sense * std::atan(0.126)), 1e-6) << "u " << u[i];
    ++n_sliding;
  }
  EXPECT_GT(n_sliding, 20);
}

/// Every cycle after the first repeats it, however many there are: the drive sets out at its own speed.
TEST(DoubleConcaveLoop, ManyCyclesAreOneRepeated) {
  const auto two = simulate(cyclic(specimen(), 0.185, 2)).summary,
             many = simulate(cyclic(specimen(), 0.185, 60)).summary;
  ASSERT_EQ(many.status, RunStatus::done) << many.reason;
  EXPECT_NEAR(many.peak_lateral_force, two.peak_lateral_force, 1e-3 * two.peak_lateral_force);
  EXPECT_EQ(many.impacts.size(), 30 * two.impacts.size());
}

TEST(DoubleConcaveLoop, WhatASolverReachedIsKept) {
  auto scene = cyclic(specimen(), 0.17);
  scene.isolator.contact_stiffness = 1e30;
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("too small"), std::string::npos) << run.summary.reason;
  EXPECT_GE(run.response.size(), 1u);
}

TEST(DoubleConcaveLoop, AppendixBHitsAt175Then165Millimetres) {
  const auto run = simulate(cyclic(specimen(), 0.185, 2));
  Column u = run.response.series("displacement_x"), impact = run.response.series("impact_x");
  std::vector<double> hits;
  for (std::size_t i = 1; i < u.size(); ++i)
    if (impact[i] != 0 && impact[i - 1] == 0) hits.push_back(u[i]);
  ASSERT_EQ(hits.size(), 4u);
  EXPECT_NEAR(hits[0], 0.175, 5e-4);
  EXPECT_NEAR(hits[1], -0.165, 5e-4);
  EXPECT_NEAR(hits[2], 0.165, 5e-4);
  EXPECT_NEAR(hits[3], -0.165, 5e-4);
}

} // namespace
} // namespace rimpact::reduced::testing
