// Buildings on double concave bearings: the coupled tangent, energy, and the physical model's own building.
#include "quasi_static_loop.h"
#include "reduced_models/rigid_body/storey_link.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using namespace rigid;
using Eigen::Vector2d;

scene::Scene carried(scene::ModelKind model, double amplitude_g, double post_yield = 0.05) {
  scene::Scene s;
  s.reduced.model = model;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.load.mass = 2e5, s.load.vertical = s.load.mass * s.load.gravity;
  s.excitation.amplitude_g = amplitude_g, s.excitation.period = 1.5, s.excitation.centre = 3;
  s.superstructure.kind = scene::StructureKind::bouc_wen, s.superstructure.mass_ratio = 0.7,
  s.superstructure.post_yield = post_yield;
  return s;
}

TEST(RigidBodyBuilding, TangentAgreesWithDifferences) {
  System system;
  for (int i = 0; i < 3; ++i) system.bodies.push_back({1e3, {1, 1, 1}, 0});
  system.links.push_back({{1e3, 2e5, 3e3, 4e6, 5e3, BoucWen{0.02, 1.7, 0.6, -0.05}}, 0, 1});
  system.links.push_back({{1e3, 3e5, 1e3, 5e6, 2e3, std::nullopt}, 1, 2});
  Poses poses;
  poses[1].position = {0.03, -0.01, 2e-3}, poses[2].position = {0.05, 0.02, 1e-3};
  Vector velocity = Vector::Zero(18);
  velocity.segment<3>(6) << 0.5, -0.3, 0.02;
  velocity.segment<3>(12) << -0.2, 0.6, 0.01;
  const std::vector<Vector2d> z0{{0.5, -0.4}, {0, 0}};
  const double weight = 2e-3;
  std::vector<LinkForce> link;
  const auto at = [&](const Vector &dv, Matrix *tangent) {
    Poses moved = poses;
    for (int b = 0; b < 3; ++b) moved[b].position += weight * dv.segment<3>(6 * b);
    Vector f = Vector::Zero(18);
    add_links(system, moved, velocity + dv, {weight, weight, z0}, link, f, tangent);
    return f;
  };
  Matrix tangent = Matrix::Zero(18, 18), difference(18, 18);
  at(Vector::Zero(18), &tangent);
  for (int j = 0; j < 18; ++j) {
    const Vector dv = 1e-6 * Vector::Unit(18, j);
    difference.col(j) = (at(dv, nullptr) - at(-dv, nullptr)) / 2e-6;
  }
  EXPECT_LT((tangent - difference).norm(), 1e-6 * difference.norm());
  EXPECT_GT(difference.norm(), 1e3);
}

// One interface, two isolators: on the sphere of radius R_eff with the effective friction the physical model
// carries the same frame the same way.
TEST(RigidBodyBuilding, TheSameFrameOnTheSphereOfItsEffectiveRadius) {
  auto scene = carried(scene::ModelKind::dcfp, 0.2);
  scene.superstructure.yield = 0.01;
  scene.isolator.slider_mass = 0.1, scene.isolator.contact_stiffness = 1e11;
  auto sphere = scene;
  const auto &b = scene.isolator;
  sphere.reduced.model = scene::ModelKind::physical;
  sphere.bearing.surface = {.kind = scene::SurfaceKind::sphere, .R0 = b.effective_radius()};
  sphere.bearing.surface.planar_radius = b.capacity + sphere.bearing.slider.diameter / 2;
  sphere.reduced.mu_fast = sphere.reduced.mu_slow = effective_friction(b, 0.05);
  const auto own = simulate(scene), other = simulate(sphere);
  ASSERT_TRUE(own.summary.impacts.empty());
  EXPECT_NEAR(own.summary.peak_displacement / other.summary.peak_displacement, 1, 3e-3);
  const auto drift = [](const ReducedRun &run) { return run.summary.extra["peak_drift_m"].get<double>(); };
  EXPECT_GT(drift(own), scene.superstructure.yield);
  EXPECT_NEAR(drift(own) / drift(other), 1, 1e-2);
}

TEST(RigidBodyBuilding, EnergyCloses) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp}) {
    auto scene = carried(model, 0.5);
    scene.isolator.step_tolerance = 1e-5;
    const auto run = simulate(scene);
    EXPECT_GE(run.summary.impacts.size(), 1u);
    EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4) << word(model);
    EXPECT_GT(run.summary.energy->plastic, 0);
  }
  auto building = carried(scene::ModelKind::lir_dcfp, 0.4);
  building.superstructure.kind = scene::StructureKind::shear_building;
  building.isolator.space = scene::Space::spatial, building.isolator.points = 8;
  building.excitation.direction_deg = 30, building.excitation.duration = 5;
  const auto run = simulate(building);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-4);
  EXPECT_EQ(run.summary.n_dofs, 15 + 9);
}

TEST(RigidBodyBuilding, CollapseStopsTheRun) {
  auto scene = carried(scene::ModelKind::dcfp, 0.6, -0.1);
  scene.superstructure.yield = 0.005;
  const auto run = simulate(scene);
  EXPECT_EQ(run.summary.status, RunStatus::stopped);
  EXPECT_NE(run.summary.reason.find("collapsed"), std::string::npos) << run.summary.reason;
  EXPECT_NEAR(run.summary.extra["peak_drift_m"].get<double>(), 11 * 0.005, 2e-3);
}

} // namespace
} // namespace rimpact::reduced::testing
