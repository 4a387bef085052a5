// The twelve-dof form: its derivative, equilibrium of the nodes, and the P-Delta moments.
#include "reduced_models/bearings/node_kinematics.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using Eigen::Vector3d;

namespace {

const NodeHeights heights{0.35, 0.22};

/// Displacements of some decimetres, rotations of some hundredths.
NodalVector some_state() {
  NodalVector u;
  u << 0.31, -0.17, 0.04, 0.01, -0.02, 0.03, 0.02, 0.05, -0.01, -0.015, 0.025, 0.008;
  return u;
}

NodalVector without_rotation_below() {
  NodalVector u = some_state();
  u.tail<3>().setZero();
  return u;
}

} // namespace

TEST(NodeKinematics, VelocityMatrixIsTheDerivative) {
  const NodalVector u = some_state();
  const KinematicMatrix S = velocity_matrix(heights, u);
  constexpr double h = 1e-3; // delta is quadratic: central differences are exact
  for (int i = 0; i < 12; ++i) {
    NodalVector e = NodalVector::Zero();
    e[i] = h;
    const Vector3d slope =
        (displacement_matrix(heights, u + e) * (u + e) - displacement_matrix(heights, u - e) * (u - e)) / (2 * h);
    EXPECT_LT((S.col(i) - slope).norm(), 1e-12) << i;
  }
}

TEST(NodeKinematics, WithoutRotationsItIsTheRelativeDisplacement) {
  NodalVector u = some_state();
  u.segment<3>(3).setZero(), u.segment<3>(9).setZero();
  EXPECT_LT((displacement_matrix(heights, u) * u - (u.head<3>() - u.segment<3>(6))).norm(), 1e-15);
}

/// Turning both nodes together about I deforms nothing, to first order.
TEST(NodeKinematics, RigidTurnsAreFree) {
  const NodalVector u = without_rotation_below();
  const Vector3d arm = u.head<3>() - u.segment<3>(6) + Vector3d(0, 0, heights.below + heights.above);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d turn = Vector3d::Unit(axis);
    NodalVector rate = NodalVector::Zero();
    rate.head<3>() = turn.cross(arm);
    rate.segment<3>(3) = rate.tail<3>() = turn;
    EXPECT_LT((velocity_matrix(heights, u) * rate).norm(), 1e-15);
  }
}

/// A finite turn of both nodes: delta departs from what it was with the square of the angle only.
TEST(NodeKinematics, FiniteTurnsAreMissedBySecondOrder) {
  const auto error = [](double angle) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Vector3d(1, 2, 2) / 3).toRotationMatrix();
    const Vector3d d(0.3, -0.1, 0.02), arm = d + Vector3d(0, 0, heights.below + heights.above);
    NodalVector u = NodalVector::Zero();
    u.head<3>() = R * arm - Vector3d(0, 0, heights.below + heights.above);
    u.segment<3>(3) = u.tail<3>() = angle * Vector3d(1, 2, 2) / 3;
    return (displacement_matrix(heights, u) * u - d).norm();
  };
  EXPECT_NEAR(error(0.02) / error(0.01), 4, 0.1);
}

TEST(NodeKinematics, NodesAreInEquilibrium) {
  const Vector3d force(1.1e5, -0.4e5, 8.5e5);
  const NodalVector u = without_rotation_below(), F = nodal_forces(heights, u, force);
  const Vector3d arm = u.head<3>() - u.segment<3>(6) + Vector3d(0, 0, heights.below + heights.above);
  EXPECT_LT((F.head<3>() - force).norm(), 1e-9);
  EXPECT_LT((F.head<3>() + F.segment<3>(6)).norm(), 1e-9);
  EXPECT_LT((F.segment<3>(3) + F.tail<3>() + arm.cross(force)).norm(), 1e-9);
}

/// At 0.3 m under W alone: the dish's push acts at the slider, so the plate's node carries W u + H (l_i + h),
/// the slider's only H l_j.
TEST(NodeKinematics, PDeltaMomentsOfABearingOnItsDish) {
  scene::Scene s = reduced::testing::free_motion({0.3, 0}, {0, 0});
  reduced::testing::set_friction(s, 0);
  const PhysicalModel model(s);
  const BearingForces f = model.forces(model.initial_state());
  const Vector3d force = f.pendular;
  const reduced::testing::Ellipse e;
  NodalVector u = NodalVector::Zero();
  u[0] = 0.3, u[2] = e.height(0.3);
  const NodalVector F = nodal_forces(heights, u, force);
  EXPECT_NEAR(F[4], -heights.above * force.x(), 1e-9);
  EXPECT_NEAR(F[10], 0.3 * force.z() - (e.height(0.3) + heights.below) * force.x(), 1e-9);
  EXPECT_NEAR(force.x(), -force.z() * e.slope(0.3), 1e-6 * force.z());
}

/// A slow cycle: equilibrium of the whole bearing about the lower node at every stored instant.
TEST(NodeKinematics, MomentsOfAResponse) {
  scene::Scene s;
  s.excitation.kind = scene::ExcitationKind::figure_eight;
  s.excitation.amplitude = 0.3;
  auto response = simulate(s).response;
  add_nodal_moments(response, heights);
  response.check();
  double largest = 0;
  const auto at = [&](const std::string &name, std::size_t i) {
    return Vector3d(response.series(name + "_x")[i], response.series(name + "_y")[i], response.series(name + "_z")[i]);
  };
  for (std::size_t i = 0; i < response.size(); ++i) {
    const Vector3d arm = at("displacement", i) + Vector3d(0, 0, heights.below + heights.above);
    const Vector3d sum = at("moment_below", i) + at("moment_above", i) + arm.cross(at("force", i));
    EXPECT_LT(sum.norm(), 1e-6);
    largest = std::max(largest, at("moment_below", i).norm());
  }
  EXPECT_GT(largest, 0.25 * 853e3); // W u is most of it
}
