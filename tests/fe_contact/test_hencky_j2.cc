// The J2 law at one point: closed form, consistency of the tangent, objectivity, exact memory (VERIFICATION
// 10).
#include "fe_contact/laws/hencky_j2.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>

namespace rimpact::fe {
namespace {

const scene::Material steel{200e9, 0.30, 7850.0, 360e6, 1450e6};

Matrix3 random_gradient(std::mt19937 &generator, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix3 F = Matrix3::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) F(i, j) += uniform(generator);
  return F;
}

/// First Piola-Kirchhoff stress of both parts.
Matrix3 piola(const HenckyJ2 &law, const HenckyVolumetric &volumetric, const J2State &old, const Matrix3 &F) {
  const Vector6 tau = law.step(old, F).response.stress + volumetric.at(F.determinant()).response.stress;
  return to_matrix(tau) * F.inverse().transpose();
}

/// dP for a perturbation dF by the spatial tangent: dP F^T = L tau + c : d.
Matrix3 predicted_change(const StressAndTangent &s, const Matrix3 &F, const Matrix3 &dF) {
  const Matrix3 L = dF * F.inverse(), d = 0.5 * (L + L.transpose());
  Vector6 rate = to_vector(d);
  rate.tail<3>() *= 2;
  return (L * to_matrix(s.stress) + to_matrix(s.tangent * rate)) * F.inverse().transpose();
}

void expect_consistent_tangent(const HenckyJ2 &law, const J2State &old, const Matrix3 &F) {
  const auto volumetric = HenckyVolumetric::from(steel);
  StressAndTangent total = law.step(old, F).response;
  const auto vol = volumetric.at(F.determinant()).response;
  total.stress += vol.stress;
  total.tangent += vol.tangent;
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Matrix3 dF = Matrix3::Zero();
      dF(i, j) = h;
      const Matrix3 difference = (piola(law, volumetric, old, F + dF) - piola(law, volumetric, old, F - dF)) / 2;
      const Matrix3 exact = predicted_change(total, F, dF);
      EXPECT_LT((difference - exact).norm(), 2e-6 * h * 200e9) << "component " << i << j;
    }
}

TEST(HenckyJ2, UniaxialTensionFollowsTheBilinearCurve) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  const auto volumetric = HenckyVolumetric::from(steel);
  J2State state;
  double lateral = 0.0; // logarithmic, found so that the lateral Kirchhoff stress vanishes
  for (int n = 1; n <= 50; ++n) {
    const double axial = 0.02 * n / 50;
    IsochoricResult result;
    Vector6 tau;
    for (int iteration = 0; iteration < 50; ++iteration) {
      const Eigen::Vector3d stretch(std::exp(axial), std::exp(lateral), std::exp(lateral));
      result = law.step(state, stretch.asDiagonal());
      const auto vol = volumetric.at(stretch.prod()).response;
      tau = result.response.stress + vol.stress;
      const Matrix6 c = result.response.tangent + vol.tangent;
      lateral -= tau(1) / (c(1, 1) + c(1, 2) + 2 * tau(1)); // d tau / d ln stretch = c + 2 tau
      if (std::abs(tau(1)) < 1) break;
    }
    state = result.state;
    // Closed form: elastic to the yield stress, then the tangent modulus.
    const double yield_strain = *steel.yield / steel.E;
    const double expected = axial < yield_strain ? steel.E * axial : *steel.yield + 1450e6 * (axial - yield_strain);
    EXPECT_NEAR(tau(0), expected, 1e-6 * 200e9 * 0.02) << "at strain " << axial;
  }
  EXPECT_GT(state.alpha, 0.015);
}

TEST(HenckyJ2, TangentAgreesWithDifferences) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(7);
  for (int sample = 0; sample < 20; ++sample) {
    const J2State history = law.step(J2State{}, random_gradient(generator, 0.02)).state;
    ASSERT_GT(history.alpha, 0);
    expect_consistent_tangent(law, history, random_gradient(generator, 0.02));
  }
  expect_consistent_tangent(law, J2State{}, random_gradient(generator, 1e-4));
}

TEST(HenckyJ2, TangentAtEqualStretchesIsTheLimit) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  expect_consistent_tangent(law, J2State{}, Matrix3::Identity());
  expect_consistent_tangent(law, J2State{}, Eigen::Vector3d(1.0003, 1.0003, 0.9999).asDiagonal());
  Matrix3 plastic = Eigen::Vector3d(1.02, 0.99, 0.99).asDiagonal();
  expect_consistent_tangent(law, J2State{}, plastic);
}

TEST(HenckyJ2, QuarterTurnOnlyTurnsTheStress) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(3);
  const Matrix3 F = random_gradient(generator, 0.01);
  const Matrix3 Q = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto straight = law.step(J2State{}, F), turned = law.step(J2State{}, Q * F);
  EXPECT_LT((to_matrix(turned.response.stress) - Q * to_matrix(straight.response.stress) * Q.transpose()).norm(), 1.0);
  EXPECT_NEAR(turned.state.alpha, straight.state.alpha, 1e-14);
  EXPECT_LT((turned.state.cp_inverse - straight.state.cp_inverse).norm(), 1e-12);
}

TEST(HenckyJ2, PlasticFlowIsIsochoricAndYieldIsMet) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(11);
  const auto result = law.step(J2State{}, random_gradient(generator, 0.05));
  EXPECT_NEAR(to_matrix(result.state.cp_inverse).determinant(), 1.0, 1e-12);
  const Matrix3 s = to_matrix(result.response.stress);
  EXPECT_NEAR(std::sqrt(1.5) * s.norm(), law.hardening.stress(result.state.alpha), 1e-3);
  EXPECT_NEAR(s.trace(), 0.0, 1.0);
}

TEST(HenckyJ2, RepeatingAnAcceptedGradientChangesNothing) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  std::mt19937 generator(5);
  const Matrix3 F = random_gradient(generator, 0.03);
  const auto once = law.step(J2State{}, F);
  const auto twice = law.step(once.state, F);
  EXPECT_NEAR(twice.state.alpha, once.state.alpha, 1e-12);
  EXPECT_LT((twice.response.stress - once.response.stress).norm(), 1e-6 * 360e6);
}

TEST(HenckyJ2, InvertedPointIsInadmissibleNotNaN) {
  const HenckyJ2 law = HenckyJ2::from(steel);
  EXPECT_FALSE(law.step(J2State{}, Eigen::Vector3d(-1, 1, 1).asDiagonal()).admissible);
  EXPECT_FALSE(HenckyVolumetric::from(steel).at(0.0).admissible);
}

} // namespace
} // namespace rimpact::fe
