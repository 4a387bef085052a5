// The symmetric tangent and the bordered Newton iteration: the same solutions as the unsymmetric matrix, or by hand.
#include "blocks.h"
#include "fe_contact/solver/tangent.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <gtest/gtest.h>
#include <tuple>

namespace rimpact::fe {
namespace {

/// A dense 4 x 4 system whose third equation is driven, of a solid and a contact that couples it too; `skew`: of the
/// contact. The error of Newton's change against the dense solution.
double error_of_change(Symmetry symmetry, double skew, double miss) {
  TimeSplit times;
  Tangent tangent(4, {{0, 1, 2, 3}}, {{0, 1, 2, 3}}, symmetry, times);
  Eigen::Matrix4d dense;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) {
      const double solid = i == k ? 10.0 + i : 1.0 + 0.5 * (i + k), contact = 0.3 * (i + k) + skew * (i - k);
      if (k >= i) tangent.symmetric().add(i, k, solid);
      tangent.add(i, k, contact);
      dense(i, k) = solid + contact;
    }
  const Eigen::Vector4d forces(1, -2, 0, 3);
  Eigen::VectorXd residual = forces, moved = Eigen::VectorXd::Zero(4);
  tangent.drive(2, 7.0, miss, moved);
  residual += moved;
  residual[2] = 7.0 * miss;
  const Eigen::VectorXd change = tangent.solver().solve_anew(-residual, 1e-12, 30);
  dense.row(2) = Eigen::RowVector4d::Unit(2);
  Eigen::Vector4d right = -forces;
  right[2] = -miss;
  const Eigen::Vector4d expected = dense.partialPivLu().solve(right);
  return change.size() == 4 ? (change - expected).norm() / expected.norm() : 1;
}

TEST(Tangent, ADrivenEquationGoesAllItsWayAndTheOthersFollow) {
  EXPECT_LT(error_of_change(Symmetry::symmetric, 0, 0.3), 1e-10);
  EXPECT_LT(error_of_change(Symmetry::general, 0, 0.3), 1e-10);
  EXPECT_LT(error_of_change(Symmetry::general, 0.7, 0.3), 1e-10);
}

TEST(Tangent, WhatIsAddedByBothTrianglesIsTakenBySymmetricPart) {
  TimeSplit times;
  Tangent tangent(2, {}, {{0, 1}}, Symmetry::symmetric, times);
  tangent.add(0, 1, 3.0);
  tangent.add(1, 0, 1.0);
  tangent.add(1, 1, 5.0);
  const Eigen::VectorXd image = tangent.multiply(Eigen::Vector2d(1, 0));
  EXPECT_EQ(image[0], 0.0);
  EXPECT_EQ(image[1], 2.0);
  EXPECT_EQ(tangent.diagonal(1), 5.0);
}

/// A block whose first and second equation are the same one, given by both kinds of tangent.
TEST(Tangent, ABlockIsAddedAsItsEntriesAre) {
  const Eigen::MatrixXd block = (Eigen::Matrix3d() << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished();
  for (const Symmetry symmetry : {Symmetry::symmetric, Symmetry::general}) {
    TimeSplit times;
    const Couplings couplings{{1, 3}};
    Tangent by_block(4, {}, couplings, symmetry, times), by_entries(4, {}, couplings, symmetry, times);
    const std::vector<int> equations{1, 1, 3};
    by_block.add_block(equations, block);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) by_entries.add(equations[i], equations[j], block(i, j));
    for (int i = 0; i < 4; ++i)
      EXPECT_LT((by_block.multiply(Eigen::Vector4d::Unit(i)) - by_entries.multiply(Eigen::Vector4d::Unit(i))).norm(),
                1e-14);
    EXPECT_THROW(by_block.add_block({1, 2, 3}, block), std::logic_error);
  }
}

/// x^2 - y = 1 + m, y^2 = 3 + 2 m under x + y = 3: one more unknown m, one more equation.
struct Curves : NewtonTarget {
  TimeSplit times;
  Tangent tangent{2, {}, {{0, 1}}, Symmetry::general, times};
  Eigen::VectorXd r = Eigen::VectorXd::Zero(2);
  BorderingConstraint edge{Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 1), 0, 1e-12, 0.1};
  bool evaluate(const Eigen::VectorXd &u, bool) override {
    r << u[0] * u[0] - u[1] - 1 - edge.multiplier, u[1] * u[1] - 3 - 2 * edge.multiplier;
    edge.constraint = u[0] + u[1] - 3;
    tangent.set_zero();
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
    tangent.set_zero();
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

TEST(GeneralMatrix, MultipliesAndRefusesEntriesOutsideItsPattern) {
  GeneralMatrix matrix(5, {{0, 1, 2}, {-1, 2, 3}}); // the last row is empty
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(5, 5);
  for (const auto &[i, j, value] : std::vector<std::tuple<int, int, double>>{
           {0, 0, 4}, {0, 1, 1}, {1, 0, -2}, {1, 1, 5}, {2, 2, 3}, {2, 3, 1}, {3, 2, 0.5}, {3, 3, 6}, {0, 2, 0.7}}) {
    matrix.add(i, j, value);
    dense(i, j) += value;
  }
  Eigen::VectorXd x(5);
  x << 1, -2, 0.5, 3, 7;
  const auto product = [&] {
    Eigen::VectorXd y = Eigen::VectorXd::Ones(5);
    matrix.add_product(x, y);
    return Eigen::VectorXd(y - Eigen::VectorXd::Ones(5));
  };
  EXPECT_LT((product() - dense * x).norm(), 1e-14);
  EXPECT_THROW(matrix.add(0, 3, 1.0), std::logic_error);
  EXPECT_THROW(matrix.add(4, 4, 1.0), std::logic_error);
  EXPECT_EQ(matrix.diagonal(3), 6);
  EXPECT_EQ(matrix.diagonal(4), 0);
  matrix.clear_row(1);
  dense.row(1).setZero();
  EXPECT_LT((product() - dense * x).norm(), 1e-14);
}

/// Nodes of three equations, of two and of one: rows that are walked along together, and such that are not.
TEST(SymmetricMatrix, MultipliesAsTheDenseMatrixDoesHoweverItsRowsAreBundled) {
  SymmetricMatrix matrix(9, {{0, 1, 2, 3, 4}, {3, 4, 5}, {0, 1, 2, 6, 7, 8}, {8}});
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(9, 9);
  for (int row = 0; row < 9; ++row)
    for (int k = matrix.offsets()[row]; k < matrix.offsets()[row + 1]; ++k) {
      const double value = std::sin(1.0 + k);
      matrix.add(row, matrix.columns()[k], value);
      dense(row, matrix.columns()[k]) = dense(matrix.columns()[k], row) = value;
    }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, -1, 2);
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
  EXPECT_THROW(matrix.add(5, 8, 1.0), std::logic_error);
  Eigen::VectorXd column = Eigen::VectorXd::Zero(9);
  const Eigen::VectorXd of_four = dense.col(4);
  matrix.isolate(4, 2.0, -0.5, column);
  EXPECT_LT((column + 0.5 * of_four).norm(), 1e-14);
  dense.row(4).setZero();
  dense.col(4).setZero();
  dense(4, 4) = 2;
  EXPECT_LT((matrix.multiply(x) - dense * x).norm(), 1e-14);
}

} // namespace
} // namespace rimpact::fe
