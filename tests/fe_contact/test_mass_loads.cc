// What acts on the mass of rung R1 beside the rim: derivatives against differences, and a dish that does not ring.
#include "fe_contact/runner/mass_loads.h"
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::fe;
using Eigen::Vector3d;

struct MassOnTheDish : testing::Test {
  scene::Scene scene = scene::load_scene("ricker-0.78g-1.0s", {});
  reduced::PhysicalModel model{scene};
  MassLoads loads{scene, model};
  RimFrame frame{0.3, scene.lateral_capacity(), model.height(scene.lateral_capacity(), 0).z};
};

TEST_F(MassOnTheDish, DerivativesAreThoseOfTheConstraintAndTheForce) {
  const MasterLaw law = loads.law(frame, 1.9, Support::dish);
  const Vector3d u(0.004, 0.02, 0.003), v(0.4, -0.2, 0.1);
  const double multiplier = 7e5, du = 1e-6, dv = 1e-5;
  const MasterLoad at = law(u, v, multiplier);
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = Vector3d::Unit(i);
    const double by_v = (law(u, v + dv * e, multiplier).constraint - law(u, v - dv * e, multiplier).constraint) / (2 * dv),
                 by_u = (law(u + du * e, v, multiplier).constraint - law(u - du * e, v, multiplier).constraint) / (2 * du);
    EXPECT_NEAR(at.gradient[i], by_v, 1e-8);
    EXPECT_NEAR(at.by_displacement[i], by_u, 1e-6);
    const Vector3d force_by_v = (law(u, v + dv * e, multiplier).force - law(u, v - dv * e, multiplier).force) / (2 * dv);
    EXPECT_LT((at.d_velocity.col(i) - force_by_v).norm(), 1e-5 * (1 + at.d_velocity.norm()));
  }
  const Vector3d by_multiplier = (law(u, v, multiplier + 10).force - law(u, v, multiplier - 10).force) / 20;
  EXPECT_LT((at.d_multiplier - by_multiplier).norm(), 1e-6);
}

TEST_F(MassOnTheDish, AShortStepFromMicronsBelowTheDishNeedsNoMoreThanTheWeight) {
  meshes::RimMeshOptions mesh;
  RimSolverOptions options;
  options.degree = 1;
  options.attached_mass = scene.load.mass;
  RimSolver solver(scene.bearing, mesh, options);
  const RimFrame ahead{0, frame.lateral_capacity, frame.touch_height};
  const double x = scene.lateral_capacity() - 0.02; // well before the rim
  const auto surface = model.height(x, 0);
  const Vector3d speed(0.5, 0, 0.5 * surface.gradient.x());
  ArcState state = solver.virgin();
  solver.place(state, ahead.master({x, 0, surface.z - 2e-6}), speed, Vector3d::Zero());
  const MasterLaw law = loads.law(ahead, 0, Support::dish);
  solver.refresh_forces(state, law, 0);
  double multiplier = 0;
  for (int k = 0; k < 4; ++k) {
    const StepReport report = solver.step(state, 1e-5, law, multiplier);
    ASSERT_TRUE(report.converged) << report.reason;
    multiplier = report.multiplier;
    EXPECT_GT(multiplier, 0);
    EXPECT_LT(multiplier, 2 * scene.load.vertical); // weight and what the path's curvature asks for
  }
  EXPECT_NEAR(loads.normal(ahead.displacement(state.master)).dot(ahead.to_global(state.master_velocity)), 0, 1e-8);
}

} // namespace
