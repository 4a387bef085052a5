/// One material point in tests: gradients at random, its tangent by differences, a bar that is pulled. E = 200 GPa,
/// nu = 0.3.
#pragma once
#include "fe_contact/laws/hencky_j2.h"
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace rimpact::test {

using namespace rimpact::fe;

inline HenckyVolumetric volumetric_part() {
  return HenckyVolumetric::from({200e9, 0.30, 7850.0});
}

inline Matrix3 random_gradient(std::mt19937 &generator, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix3 F = Matrix3::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) F(i, j) += uniform(generator);
  return F;
}

/// First Piola-Kirchhoff stress of both parts; a law has HenckyJ2's step.
template <class Law>
Matrix3 piola(const Law &law, const HenckyVolumetric &volumetric, const J2State &old, const Matrix3 &F, double dt) {
  const Vector6 tau = law.step(old, F, dt).response.stress + volumetric.at(F.determinant()).response.stress;
  return to_matrix(tau) * F.inverse().transpose();
}

/// dP for a perturbation dF by the spatial tangent: dP F^T = L tau + c : d.
inline Matrix3 predicted_change(const StressAndTangent &s, const Matrix3 &F, const Matrix3 &dF) {
  const Matrix3 L = dF * F.inverse(), d = 0.5 * (L + L.transpose());
  Vector6 rate = to_vector(d);
  rate.tail<3>() *= 2;
  return (L * to_matrix(s.stress) + to_matrix(s.tangent * rate)) * F.inverse().transpose();
}

template <class Law>
void expect_consistent_tangent(const Law &law, const J2State &old, const Matrix3 &F, double dt = 0) {
  const auto volumetric = volumetric_part();
  StressAndTangent total = law.step(old, F, dt).response;
  const auto vol = volumetric.at(F.determinant()).response;
  total.stress += vol.stress;
  total.tangent += vol.tangent;
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Matrix3 dF = Matrix3::Zero();
      dF(i, j) = h;
      const Matrix3 difference =
          (piola(law, volumetric, old, F + dF, dt) - piola(law, volumetric, old, F - dF, dt)) / 2;
      const Matrix3 exact = predicted_change(total, F, dF);
      EXPECT_LT((difference - exact).norm(), 2e-6 * h * 200e9) << "component " << i << j;
    }
}

/// From ten states that have flowed, steps of 0.1 ms at random.
inline void expect_consistent_tangents(const HenckyJ2 &law, const std::string &name) {
  std::mt19937 generator(7);
  for (int sample = 0; sample < 10; ++sample) {
    SCOPED_TRACE(name);
    const J2State history = law.step(J2State{}, random_gradient(generator, 0.02), 1e-4).state;
    ASSERT_GT(history.alpha, 0);
    expect_consistent_tangent(law, history, random_gradient(generator, 0.02), 1e-4);
  }
}

/// A point of a bar that is pulled: the lateral stretch is the one without lateral stress.
struct PulledBar {
  const HenckyJ2 &law;
  J2State state{};
  double lateral = 0.0; ///< logarithmic strain
  double energy = 0.0;  ///< elastic [J/m^3]
  double mises = 0.0;   ///< IsochoricResult::mises [Pa]

  /// Axial Kirchhoff stress at a logarithmic strain, a step of dt [s] after the last one.
  double pull(double axial, double dt = 0) {
    const auto volumetric = volumetric_part();
    IsochoricResult result;
    Vector6 tau;
    for (int iteration = 0; iteration < 50; ++iteration) {
      const Eigen::Vector3d stretch(std::exp(axial), std::exp(lateral), std::exp(lateral));
      result = law.step(state, stretch.asDiagonal(), dt);
      const auto vol = volumetric.at(stretch.prod());
      tau = result.response.stress + vol.response.stress;
      energy = result.energy + vol.energy;
      const Matrix6 c = result.response.tangent + vol.response.tangent;
      if (std::abs(tau(1)) < 1) break;
      lateral -= tau(1) / (c(1, 1) + c(1, 2) + 2 * tau(1)); // d tau / d ln stretch = c + 2 tau
    }
    state = result.state, mises = result.mises;
    return tau(0);
  }
};

} // namespace rimpact::test
