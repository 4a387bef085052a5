// What acts on the mass of rung rim beside the rim: derivatives against differences, and a dish that does not ring.
#include "fe_contact/drive/order.h"
#include "fe_contact/rungs/mass_loads.h"
#include "fe_contact/rungs/rim.h"
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

/// Of one dish, and of the half of two.
struct Derivatives : MassOnTheDish, testing::WithParamInterface<int> {};

TEST_P(Derivatives, AreThoseOfTheConstraintAndTheForce) {
  frame.dishes = GetParam();
  const RemoteLaw law = loads.law(frame, 1.9, Support::dish);
  const Vector3d u(0.004, 0.02, 0.003), v(0.4, -0.2, 0.1);
  const double multiplier = 7e5, du = 1e-6, dv = 1e-5;
  const RemoteLoad at = law(u, v, multiplier);
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = Vector3d::Unit(i);
    const double by_v =
                     (law(u, v + dv * e, multiplier).constraint - law(u, v - dv * e, multiplier).constraint) / (2 * dv),
                 by_u =
                     (law(u + du * e, v, multiplier).constraint - law(u - du * e, v, multiplier).constraint) / (2 * du);
    EXPECT_NEAR(at.gradient[i], by_v, 1e-8);
    EXPECT_NEAR(at.by_displacement[i], by_u, 1e-6);
    const Vector3d force_by_v =
        (law(u, v + dv * e, multiplier).force - law(u, v - dv * e, multiplier).force) / (2 * dv);
    EXPECT_LT((at.d_velocity.col(i) - force_by_v).norm(), 1e-5 * (1 + at.d_velocity.norm()));
  }
  const Vector3d by_multiplier = (law(u, v, multiplier + 10).force - law(u, v, multiplier - 10).force) / 20;
  EXPECT_LT((at.d_multiplier - by_multiplier).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Dishes, Derivatives, testing::Values(1, 2));

TEST_F(MassOnTheDish, AShortStepFromMicronsBelowTheDishNeedsNoMoreThanTheWeight) {
  const BearingModel parts(rungs::rim, scene.bearing, {}, {.degree = 1});
  BearingSystem system(parts, scene.load.mass);
  const RimFrame ahead{0, frame.lateral_capacity, frame.touch_height};
  const double x = scene.lateral_capacity() - 0.02; // well before the rim
  const auto surface = model.height(x, 0);
  const Vector3d speed(0.5, 0, 0.5 * surface.gradient.x());
  SystemState state = system.at_rest();
  system.set_position(state, ahead.master({x, 0, surface.z - 2e-6}), speed, Vector3d::Zero());
  RemoteTerms remote{system.top(), loads.law(ahead, 0, Support::dish), parts.share()};
  StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
  terms.dt = 1e-5;
  terms.remote = &remote;
  for (int k = 0; k < 4; ++k) {
    const ContactStepReport report = time_step(system, state, terms, step_options(rungs::rim, scene));
    ASSERT_TRUE(report.converged) << report.reason;
    remote.multiplier = report.multiplier;
    EXPECT_GT(remote.multiplier, 0);
    EXPECT_LT(remote.multiplier, 2 * scene.load.vertical); // weight and what the path's curvature asks for
  }
  EXPECT_NEAR(loads.normal(ahead.displacement(system.top().of(state.u))).dot(ahead.to_global(system.top().of(state.v))),
              0, 1e-8);
}

} // namespace
