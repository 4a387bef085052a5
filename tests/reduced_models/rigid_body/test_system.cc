// The tangent against differences; the friction states against the equations they solve.
#include "reduced_models/rigid_body/chain.h"
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "scenes.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using namespace rigid;
using Eigen::Vector3d;

TEST(ContactDamping, IsOfTheSupportedMassOrAsPrintedOfTheBearingsOwn) {
  scene::Isolator b;
  b.contact_stiffness = 4e7, b.slider_mass = 100, b.plate_mass = 300;
  const double xi = -std::log(0.65) / std::hypot(M_PI, std::log(0.65));
  EXPECT_NEAR(contact_damping(b, 2e5, 3), 2 * xi * std::sqrt(4e7 * 2e5 * 3 / 2), 1e-6);
  b.damped_mass = scene::DampedMass::bearing; // (3-46)
  EXPECT_NEAR(contact_damping(b, 2e5, 3), 2 * xi * std::sqrt(4e7 * 100 * 300 / 400), 1e-9);
}

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

/// The slider leans on a rim, everything pressed and sliding. In the plane only what moves there has a tangent.
void expect_tangent_of_differences(scene::ModelKind model, scene::Space space) {
  scene::Scene scene;
  scene.reduced.model = model;
  const bool planar = space == scene::Space::planar;
  scene.isolator.space = space, scene.isolator.points = planar ? 3 : 8;
  const RigidBearing bearing(scene);
  const auto &system = bearing.system;
  const MotionState state =
      planar ? bearing.state_at({0.303, 0}, {0.36, 0}) : bearing.state_at({0.24, 0.185}, {0.2, 0.3});
  const int n = system.n_dofs();
  const double weight = 1e-3;
  std::vector<Vector3d> slip(system.contacts.size(), Vector3d(0.5, planar ? 0 : 0.5, 0));
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
  Matrix tangent, difference = Matrix::Zero(n, n);
  at(Vector::Zero(n), &tangent);
  int n_walls = 0;
  for (std::size_t i = 0; i < forces.size(); ++i)
    n_walls += system.contacts[i].surface == Surface::rim && forces[i].size > 0;
  EXPECT_EQ(n_walls, 2);
  for (int j = 0; j < n; j += planar ? 2 : 1) {
    const Vector dv = 1e-6 * Vector::Unit(n, j);
    difference.col(j) = (at(dv, nullptr) - at(-dv, nullptr)) / 2e-6;
  }
  EXPECT_LT((tangent - difference).norm(), 2e-3 * difference.norm()) << word(model) << " " << word(space);
}

TEST(RigidSystem, TangentAgreesWithDifferences) {
  for (const auto model : {scene::ModelKind::dcfp, scene::ModelKind::lir_dcfp})
    for (const auto space : {scene::Space::spatial, scene::Space::planar}) expect_tangent_of_differences(model, space);
}

TEST(Chain, SolvesAsTheWholeMatrix) {
  constexpr int n = 3, bodies = 4;
  const Eigen::MatrixXd random = Eigen::MatrixXd::Random(n * bodies, n * bodies);
  Eigen::MatrixXd A = 5 * Eigen::MatrixXd::Identity(n * bodies, n * bodies);
  Chain<n> chain;
  std::array<Chain<n>::Part, max_bodies> x;
  for (int b = 0; b < bodies; ++b)
    for (int c = std::max(0, b - 1); c < std::min(bodies, b + 2); ++c) {
      A.block<n, n>(n * b, n * c) += random.block<n, n>(n * b, n * c);
      (c < b ? chain.below(b) : c > b ? chain.above(b) : chain.diagonal(b)) = A.block<n, n>(n * b, n * c);
    }
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n * bodies, 1, 2);
  for (int b = 0; b < bodies; ++b) x[b] = right.segment<n>(n * b);
  chain.eliminate(bodies);
  chain.solve(bodies, x);
  for (int b = 0; b < bodies; ++b) EXPECT_LT((x[b] - A.partialPivLu().solve(right).segment<n>(n * b)).norm(), 1e-13);
}

} // namespace
} // namespace rimpact::reduced::testing
