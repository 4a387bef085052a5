// The symmetric tangent and the bordered Newton iteration: the same solutions as the unsymmetric matrix, or by hand.
#include "blocks.h"
#include "fe_contact/solver/tangent.h"

#include <fmt/format.h>

#include <gtest/gtest.h>
#include <tuple>

namespace rimpact::fe {
namespace {

/// A dense 4 x 4 system whose third equation is driven; what a Newton change leaves of the residual.
Eigen::VectorXd change_by(Symmetry symmetry, double miss) {
  TimeSplit times;
  Tangent tangent(4, {{0, 1, 2, 3}}, symmetry, times);
  for (int i = 0; i < 4; ++i)
    for (int k = i; k < 4; ++k) tangent.symmetric().add(i, k, i == k ? 10.0 + i : 1.0 + i + 0.5 * k);
  tangent.close_symmetric();
  Eigen::VectorXd residual(4), moved = Eigen::VectorXd::Zero(4);
  residual << 1, -2, 0, 3;
  tangent.drive(2, 7.0, miss, moved);
  residual += moved;
  residual[2] = 7.0 * miss;
  return tangent.solver().solve_anew(-residual, 1e-12, 30);
}

TEST(Tangent, ADrivenEquationGivesTheSameChangeByOneTriangleAsByBoth) {
  const Eigen::VectorXd whole = change_by(Symmetry::general, 0.3), half = change_by(Symmetry::symmetric, 0.3);
  ASSERT_EQ(whole.size(), 4);
  ASSERT_EQ(half.size(), 4);
  EXPECT_NEAR(half[2], -0.3, 1e-12);
  EXPECT_LT((whole - half).norm(), 1e-10 * whole.norm());
}

TEST(Tangent, WhatIsAddedByBothTrianglesIsTakenBySymmetricPart) {
  TimeSplit times;
  Tangent tangent(2, {{0, 1}}, Symmetry::symmetric, times);
  tangent.symmetric().set_zero();
  tangent.add(0, 1, 3.0);
  tangent.add(1, 0, 1.0);
  tangent.add(1, 1, 5.0);
  const Eigen::VectorXd image = tangent.multiply(Eigen::Vector2d(1, 0));
  EXPECT_EQ(image[0], 0.0);
  EXPECT_EQ(image[1], 2.0);
  EXPECT_EQ(tangent.diagonal(1), 5.0);
}

/// x^2 - y = 1 + m, y^2 = 3 + 2 m under x + y = 3: one more unknown m, one more equation.
struct Curves : NewtonTarget {
  TimeSplit times;
  Tangent tangent{2, {{0, 1}}, Symmetry::general, times};
  Eigen::VectorXd r = Eigen::VectorXd::Zero(2);
  BorderingConstraint edge{Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 1), 0, 1e-12, 0.1};
  bool evaluate(const Eigen::VectorXd &u, bool) override {
    r << u[0] * u[0] - u[1] - 1 - edge.multiplier, u[1] * u[1] - 3 - 2 * edge.multiplier;
    edge.constraint = u[0] + u[1] - 3;
    tangent.symmetric().set_zero();
    tangent.close_symmetric();
    tangent.add(0, 0, 2 * u[0]);
    tangent.add(0, 1, -1);
    tangent.add(1, 1, 2 * u[1]);
    return true;
  }
  const Eigen::VectorXd &residual() const override { return r; }
  double force_scale() const override { return 1; }
  LinearSolver &solver() override { return tangent.solver(); }
  BorderingConstraint *border() override { return &edge; }
};

TEST(Newton, FindsTheMultiplierThatHoldsItsConstraint) {
  Curves curves;
  Eigen::VectorXd u = Eigen::Vector2d(1.5, 1.8);
  const NewtonReport report = newton(curves, u, {});
  ASSERT_TRUE(report.converged()) << report.reason();
  const double m = curves.edge.multiplier;
  EXPECT_NEAR(u[0] + u[1], 3, 1e-11);
  EXPECT_NEAR(u[0] * u[0] - u[1] - 1 - m, 0, 1e-7);
  EXPECT_NEAR(u[1] * u[1] - 3 - 2 * m, 0, 1e-7);
}

/// x = 0 with a tangent ten times too stiff: each iteration leaves nine tenths of the residual.
struct Creeping : Curves {
  bool evaluate(const Eigen::VectorXd &u, bool) override {
    r = u;
    tangent.symmetric().set_zero();
    tangent.close_symmetric();
    for (int i : {0, 1}) tangent.add(i, i, 10);
    return true;
  }
  BorderingConstraint *border() override { return nullptr; }
};

TEST(Newton, IsGivenUpWhereItsResidualCreepsOnlyIfThereIsAnotherWay) {
  for (const auto &[patience, iterations] :
       {std::pair{3, 4}, {6, 20}, {0, 20}}) { // 0.9^3 > 0.6 > 0.9^6; the first does not count
    Creeping creeping;
    Eigen::VectorXd u = Eigen::Vector2d(1, 1);
    NewtonOptions options;
    options.patience = patience;
    const NewtonReport report = newton(creeping, u, options);
    EXPECT_EQ(report.outcome, patience == 3 ? NewtonOutcome::stagnant : NewtonOutcome::spent);
    EXPECT_EQ(report.iterations, iterations) << patience;
    EXPECT_NE(report.reason().find(fmt::format(" {} iterations", iterations)), std::string::npos);
  }
}

TEST(SurfaceContact, ABearingPointIsExpectedToGoOnAsItDidAndNeverToPull) {
  SurfaceContactState state;
  state.multiplier = {5.0, 1.0, 0.0};
  state.pressure = {4.0, 2.0, 0.0};
  state.note_change({2.0, 5.0, 0.0});
  state.expect(0.5);
  EXPECT_EQ(state.multiplier, (std::vector<double>{6.0, 0.0, 0.0}));
}

/// The top of a smooth block goes down and along a little; the change is that of the unsymmetric system.
TEST(Tangent, ASmoothContactIsSolvedByOneTriangle) {
  Block smooth(FrictionCoefficient::constant(0)), barely(FrictionCoefficient::constant(1e-12));
  SystemState half = smooth.system->at_rest(), whole = barely.system->at_rest();
  StepOptions options;
  options.newton.tolerance = 1e-10;
  ASSERT_TRUE(static_step(*smooth.system, half, smooth.drive(1e-4, 1e-4, 1e-3), options).converged);
  ASSERT_TRUE(static_step(*barely.system, whole, barely.drive(1e-4, 1e-4, 1e-3), options).converged);
  EXPECT_GT(half.reports[0].force.z(), 0);
  EXPECT_NEAR(half.reports[0].force.z(), whole.reports[0].force.z(), 1e-6 * whole.reports[0].force.z());
}

TEST(Tangent, FrictionThatIsSetOnTheWayMakesItWhole) {
  Block early(FrictionCoefficient::constant(0.3)), late(FrictionCoefficient::constant(0));
  int iterations[2] = {};
  for (Block *block : {&early, &late}) {
    SystemState state = block->system->at_rest();
    block->system->contact(0).law().friction = FrictionCoefficient::constant(0.3);
    const auto step = static_step(*block->system, state, block->drive(1e-3, 1e-4, 1e-3), {});
    ASSERT_TRUE(step.converged) << step.reason;
    iterations[block == &late] = step.iterations;
  }
  EXPECT_EQ(iterations[0], iterations[1]);
}

TEST(GeneralMatrix, MultipliesSolvesAndRefusesEntriesOutsideItsPattern) {
  const SymmetricMatrix pattern(4, {{0, 1, 2}, {2, 3}});
  GeneralMatrix matrix(pattern);
  Eigen::Matrix4d dense = Eigen::Matrix4d::Zero();
  for (const auto &[i, j, value] : std::vector<std::tuple<int, int, double>>{
           {0, 0, 4}, {0, 1, 1}, {1, 0, -2}, {1, 1, 5}, {2, 2, 3}, {2, 3, 1}, {3, 2, 0.5}, {3, 3, 6}, {0, 2, 0.7}}) {
    matrix.add(i, j, value);
    dense(i, j) += value;
  }
  const Eigen::Vector4d x(1, -2, 0.5, 3);
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
  EXPECT_THROW(matrix.add(0, 3, 1.0), std::logic_error);
  matrix.make_unit_row(1, 2.0);
  dense.row(1) << 0, 2, 0, 0;
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
}

} // namespace
} // namespace rimpact::fe
