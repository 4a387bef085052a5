// The tangent against differences; the friction states against the equations they solve.
#include "reduced_models/rigid_body/double_concave_system.h"
#include "scenes.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using namespace rigid;
using Eigen::Vector3d;

TEST(SlipState, CoulombStaysOnTheCircleAndSlidesWithTheVelocity) {
  const Vector3d v(0.3, -0.4, 0);
  const auto sliding = coulomb_step({1, 0, 0}, v, 1e9);
  EXPECT_NEAR((sliding.z - v / v.norm()).norm(), 0, 1e-8);
  EXPECT_NEAR((coulomb_step({0.1, 0, 0}, v, 0.5).z - Vector3d(0.25, -0.2, 0)).norm(), 0, 1e-15);
}

TEST(SlipState, ParkWenSolvesItsImplicitStage) {
  for (const double h_over_q : {0.1, 10.0, 1e4})
    for (const Vector3d &v : {Vector3d(0.3, -0.4, 0), Vector3d(-0.5, 0.1, 0)}) {
      const Vector3d z0(0.6, 0.5, 0), z = park_wen_step(z0, v, h_over_q).z;
      const Vector3d rate = v - z * std::max(0.0, z.dot(v));
      EXPECT_NEAR((z - z0 - h_over_q * rate).norm(), 0, 1e-11 * (1 + h_over_q));
      EXPECT_LE(z.norm(), 1 + 1e-12);
    }
}

TEST(SlipState, DerivativesAgreeWithDifferences) {
  for (auto *law : {&coulomb_step, &park_wen_step})
    for (const Vector3d &v : {Vector3d(0.3, -0.4, 0.1), Vector3d(-0.5, 0.1, 0)})
      for (const double h_over_q : {0.2, 30.0})
        for (int i = 0; i < 3; ++i) {
          const Vector3d z0(0.6, 0.5, 0), dv = 1e-6 * Vector3d::Unit(i);
          const Vector3d difference = ((*law)(z0, v + dv, h_over_q).z - (*law)(z0, v - dv, h_over_q).z) / 2e-6;
          EXPECT_NEAR(((*law)(z0, v, h_over_q).d_velocity.col(i) - difference).norm(), 0, 1e-7);
        }
}

/// The slider leans on a rim, everything pressed and sliding.
TEST(RigidSystem, TangentAgreesWithDifferences) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp}) {
    scene::Scene scene;
    scene.reduced.model = model;
    scene.isolator.space = scene::Space::spatial, scene.isolator.points = 8;
    const DoubleConcaveSystem bearing(scene);
    const auto &system = bearing.system;
    const MotionState state = bearing.state_at({0.24, 0.185}, {0.2, 0.3});
    const int n = system.n_dofs();
    const double weight = 1e-3;
    std::vector<Vector3d> slip(system.contacts.size(), Vector3d(0.5, 0.5, 0));
    std::vector<ContactForce> forces;
    const auto at = [&](const Vector &dv, Matrix *tangent) {
      Poses poses = state.poses;
      for (std::size_t b = 0; b < system.bodies.size(); ++b) {
        poses[b].position += weight * dv.segment<3>(6 * b);
        const Vector3d turn = weight * dv.segment<3>(6 * b + 3);
        if (turn.norm() > 0)
          poses[b].rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * poses[b].rotation;
      }
      return system.forces(poses, state.velocity + dv, {weight, weight, slip}, forces, tangent);
    };
    Matrix tangent, difference(n, n);
    at(Vector::Zero(n), &tangent);
    int n_walls = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
      n_walls += system.contacts[i].surface == Surface::rim && forces[i].size > 0;
    EXPECT_EQ(n_walls, 2);
    for (int j = 0; j < n; ++j) {
      const Vector dv = 1e-6 * Vector::Unit(n, j);
      difference.col(j) = (at(dv, nullptr) - at(-dv, nullptr)) / 2e-6;
    }
    EXPECT_LT((tangent - difference).norm(), 2e-3 * difference.norm()) << word(model);
  }
}

} // namespace
} // namespace rimpact::reduced::testing
