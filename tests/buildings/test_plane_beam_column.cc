// The corotational beam-column: rigid motion, tangents, elastica, Euler's load, P-Delta, hinges.
#include "buildings/plane_beam_column.h"
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>
#include <numbers>

using namespace rimpact::buildings;
using Eigen::MatrixXd, Eigen::VectorXd, Eigen::Vector2d;

namespace {

PlaneBeamColumn member(const Vector2d &from, const Vector2d &to, double EI, double EA, double post_yield = 1) {
  PlaneBeamColumn m;
  m.from = from, m.to = to;
  m.bending = {1.0 * EI, 1.0, post_yield}, m.axial = {1.0 * EA, 1.0, post_yield};
  m.hinge_length = m.length() / 12;
  return m;
}
/// A concrete column that yields: 350 kN m.
PlaneBeamColumn yielding() {
  PlaneBeamColumn m;
  m.from = {0, 0}, m.to = {0, 3.5}, m.hinge_length = 0.25;
  m.bending = {350e3, 350e3 / 122e6, 0.02, 2, 0.5, 0.02, 0.05}, m.axial = {5e6, 5e6 / 5.85e9, 0.02};
  return m;
}

/// A line of `n` elastic members from the origin along x, its foot clamped: forces and tangent of the free dofs.
struct Cantilever {
  std::vector<PlaneBeamColumn> members;
  Cantilever(int n, double length, double EI, double EA) {
    for (int i = 0; i < n; ++i) members.push_back(member({length * i / n, 0}, {length * (i + 1) / n, 0}, EI, EA));
  }
  int n_dofs() const { return 3 * static_cast<int>(members.size()); }
  void assemble(const VectorXd &u, VectorXd &f, MatrixXd &K) const {
    f = VectorXd::Zero(n_dofs() + 3), K = MatrixXd::Zero(n_dofs() + 3, n_dofs() + 3);
    VectorXd all(n_dofs() + 3);
    all << 0, 0, 0, u;
    for (std::size_t e = 0; e < members.size(); ++e) {
      const auto a = members[e].at(all.segment<6>(3 * e), {}, {});
      f.segment<6>(3 * e) += a.force, K.block<6, 6>(3 * e, 3 * e) += a.tangent;
    }
    f = f.tail(n_dofs()).eval(), K = K.bottomRightCorner(n_dofs(), n_dofs()).eval();
  }
  VectorXd solve(const VectorXd &load, int n_steps) const {
    VectorXd u = VectorXd::Zero(n_dofs()), f;
    MatrixXd K;
    for (int step = 1; step <= n_steps; ++step)
      for (int i = 0; i < 60; ++i) {
        assemble(u, f, K);
        const VectorXd d = K.partialPivLu().solve(load * step / n_steps - f);
        u += d;
        if (d.norm() < 1e-12) break;
      }
    return u;
  }
};

} // namespace

TEST(PlaneBeamColumn, RigidMotionGivesNoForce) {
  const auto m = yielding();
  for (const double angle : {0.1, -1.5, 3.0, 7.0}) {
    const Eigen::Rotation2Dd turn(angle);
    const Vector2d i = turn * m.from + Vector2d(2, 3) - m.from, j = turn * m.to + Vector2d(2, 3) - m.to;
    PlaneVector u;
    u << i, angle, j, angle;
    EXPECT_LT(m.at(u, {}, {}).force.lpNorm<Eigen::Infinity>(), 1e-4) << angle; // of 1e6 N
  }
}

TEST(PlaneBeamColumn, TangentIsThatOfItsForceAndSymmetric) {
  const auto m = yielding();
  SectionPoints base;
  base[0] = {0.003, 0.4, 2}, base[1] = {-0.01, -0.7, 5}, base[2] = {-1e-4, -0.1, 0};
  PlaneVector u;
  u << 0.01, 0.002, -0.02, 0.06, -0.004, 0.015;
  const auto a = m.at(u, base, base);
  ASSERT_TRUE(a.force.allFinite());
  EXPECT_LT((a.tangent - a.tangent.transpose()).norm(), 1e-9 * a.tangent.norm());
  for (int c = 0; c < 6; ++c) {
    PlaneVector plus = u, minus = u;
    const double h = 1e-7;
    plus[c] += h, minus[c] -= h;
    const PlaneVector slope =
        (m.at(plus, base, a.inner.points).force - m.at(minus, base, a.inner.points).force) / (2 * h);
    EXPECT_LT((slope - a.tangent.col(c)).norm(), 1e-6 * a.tangent.norm()) << c;
  }
}

TEST(PlaneBeamColumn, BeforeYieldIsTheElasticMember) {
  const auto m = yielding();
  PlaneVector u = PlaneVector::Zero();
  u[3] = 1e-7; // the head moves sideways
  const auto a = m.at(u, {}, {});
  EXPECT_NEAR(a.force[3] / (12 * 122e6 / std::pow(3.5, 3) * 1e-7), 1, 1e-6);
}

TEST(PlaneBeamColumn, AMomentBendsACantileverToACircle) {
  const double L = 2, EI = 3;
  double before = 0;
  for (const int n : {4, 8, 16}) {
    const Cantilever c(n, L, EI, 1e9);
    VectorXd load = VectorXd::Zero(c.n_dofs());
    load[c.n_dofs() - 1] = 1.5 * std::numbers::pi * EI / L; // three quarters of a circle
    const VectorXd u = c.solve(load, 30);
    const double R = L / (1.5 * std::numbers::pi);
    const double error = std::hypot(L + u[c.n_dofs() - 3] + R, u[c.n_dofs() - 2] - R);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 2, 0.2);
    }
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

/// Bisshopp and Drucker, Quart. Appl. Math. 3 (1945); digits by Mattiasson, Int. J. Num. Meth. Eng. 17 (1981).
TEST(PlaneBeamColumn, ATransverseForceBendsACantileverAsElasticaDoes) {
  const struct {
    double load, down, in;
  } known[] = {{1, 0.30172, 0.05643}, {5, 0.71379, 0.38763}, {10, 0.81061, 0.55500}};
  for (const auto &k : known) {
    const Cantilever c(24, 1, 1, 1e8);
    VectorXd load = VectorXd::Zero(c.n_dofs());
    load[c.n_dofs() - 2] = k.load;
    const VectorXd u = c.solve(load, 20);
    EXPECT_NEAR(u[c.n_dofs() - 2], k.down, 1e-3);
    EXPECT_NEAR(-u[c.n_dofs() - 3], k.in, 1e-3);
  }
}

TEST(PlaneBeamColumn, BucklesAtEulersLoad) {
  const double L = 3, EI = 5;
  double before = 0;
  for (const int n : {2, 4, 8}) {
    const Cantilever c(n, L, EI, 1e9);
    const auto least = [&](double P) {
      VectorXd load = VectorXd::Zero(c.n_dofs()), f;
      load[c.n_dofs() - 3] = -P;
      MatrixXd K;
      c.assemble(c.solve(load, 1), f, K);
      return Eigen::SelfAdjointEigenSolver<MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues()[0];
    };
    double low = 0.1, high = 5;
    for (int i = 0; i < 50; ++i) (least((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    const double error = std::abs(low / (std::numbers::pi * std::numbers::pi * EI / (4 * L * L)) - 1);
    if (before > 0) {
      EXPECT_GT(std::log2(before / error), 1.9);
    }
    before = error;
  }
  EXPECT_LT(before, 5e-3);
}

TEST(PlaneBeamColumn, WeightOnAColumnTakesPOverLOfItsStiffness) {
  const auto m = member({0, 0}, {0, 3.5}, 122e6, 1e15);
  const double P = 1e6;
  PlaneVector u = PlaneVector::Zero();
  u[4] = -P * 3.5 / 1e15;
  const auto a = m.at(u, {}, {});
  EXPECT_NEAR(a.force[4], -P, 1);
  EXPECT_NEAR(a.tangent(3, 3), 12 * 122e6 / std::pow(3.5, 3) - P / 3.5, 1e-6 * a.tangent(3, 3));
}

TEST(PlaneBeamColumn, ALoadAlongItGivesTheClampedMoments) {
  auto m = member({0, 0}, {8, 0}, 268e6, 7.6e9);
  m.load = 40e3;
  const auto a = m.at(PlaneVector::Zero(), {}, {});
  EXPECT_NEAR(a.force[2], 40e3 * 64 / 12, 1);
  EXPECT_NEAR(a.force[5], -40e3 * 64 / 12, 1);
}

TEST(PlaneBeamColumn, AHingeYieldsAtItsMomentAndTurns) {
  auto m = yielding();
  m.bending.strength_loss = m.bending.stiffness_loss = 0, m.bending.post_yield = 0, m.axial.post_yield = 1;
  SectionPoints p{};
  PlaneVector u = PlaneVector::Zero();
  double work = 0;
  PlaneBeamColumn::Answer a = m.at(u, p, p);
  for (int i = 1; i <= 4000; ++i) {
    const double force = a.force[3];
    u[3] = 0.2 * i / 4000;
    a = m.at(u, p, p), p = a.inner.points;
    work += 0.5 * (force + a.force[3]) * 0.2 / 4000;
  }
  EXPECT_NEAR(std::abs(a.inner.force[1]), 350e3, 1e3);
  EXPECT_NEAR(std::abs(m.plastic_rotation(0, p)), 0.2 / 3.5 - 350e3 * 3.5 / (6 * 122e6), 5e-4);
  EXPECT_NEAR(work, m.stored(p) + 2 * 350e3 * std::abs(m.plastic_rotation(0, p)), 0.03 * work);
}
