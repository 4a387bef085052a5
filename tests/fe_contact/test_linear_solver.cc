// GMRES in double precision on a factor in single precision, new or stale.
#include "fe_contact/solver/linear_solver.h"

#include <gtest/gtest.h>
#include <random>

namespace rimpact::fe {
namespace {

constexpr int size = 300;
std::mt19937 generator(7);

/// Eighty couplings of twelve equations.
Couplings random_couplings() {
  std::uniform_int_distribution<int> any(0, size - 1);
  Couplings result(80, std::vector<int>(12));
  for (auto &coupling : result)
    for (int &equation : coupling) equation = any(generator);
  return result;
}

/// Entries between -1 and 1 on an indefinite diagonal; every seventh of it is a thousand million, as of driven rows.
void fill(SymmetricMatrix &matrix) {
  std::uniform_real_distribution<double> number(-1, 1);
  for (double &value : matrix.values()) value = number(generator);
  for (int i = 0; i < size; ++i) matrix.add(i, i, i % 7 == 0 ? 1e9 : i % 2 == 0 ? 30 : -30);
}

double residual(const SymmetricMatrix &matrix, const Eigen::VectorXd &x, const Eigen::VectorXd &b) {
  return x.size() ? (matrix.multiply(x) - b).norm() / b.norm() : 1.0;
}

TEST(LinearSolver, SolvesInDoublePrecisionOnANewAndOnAStaleFactor) {
  SymmetricMatrix matrix(size, random_couplings());
  TimeSplit times;
  LinearSolver solver(matrix, nullptr, times);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(size);
  EXPECT_EQ(solver.solve(b, 1e-6, 20).size(), 0); // no factor yet
  fill(matrix);
  EXPECT_LT(residual(matrix, solver.solve_anew(b, 1e-13, 20), b), 1e-12); // a float has seven digits
  EXPECT_LE(solver.last_iterations(), 4);
  for (double &value : matrix.values()) value *= 1 + 0.05 * std::sin(value);
  EXPECT_LT(residual(matrix, solver.solve(b, 1e-10, 30), b), 1e-9);
  EXPECT_GT(times["factor"], 0);
  EXPECT_GT(times["solve"], 0);
}

TEST(LinearSolver, SolvesTheSumOfASymmetricAndAnUnsymmetricMatrix) {
  SymmetricMatrix symmetric(size, random_couplings());
  const Couplings couplings = random_couplings();
  GeneralMatrix unsymmetric(size, couplings);
  std::uniform_real_distribution<double> number(-1, 1);
  for (double &value : symmetric.values()) value = number(generator);
  for (int i = 0; i < size; ++i) symmetric.add(i, i, i % 2 == 0 ? 40 : -40);
  for (const auto &coupling : couplings)
    for (const int row : coupling)
      for (const int column : coupling) unsymmetric.add(row, column, number(generator));
  TimeSplit times;
  LinearSolver solver(symmetric, &unsymmetric, times);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(size), x = solver.solve_anew(b, 1e-13, 20);
  ASSERT_EQ(x.size(), size);
  Eigen::VectorXd image = symmetric.multiply(x);
  unsymmetric.add_product(x, image);
  EXPECT_LT((image - b).norm(), 1e-12 * b.norm());
}

Couplings neighbours() {
  Couplings couplings;
  for (int i = 0; i + 1 < size; ++i) couplings.push_back({i, i + 1});
  return couplings;
}

/// A chain of springs of 1 N/m, held at its end by one of `support`.
struct Chain : SymmetricMatrix {
  explicit Chain(double support) : SymmetricMatrix(size, neighbours()) {
    for (int i = 0; i + 1 < size; ++i) {
      add(i, i, 1);
      add(i + 1, i + 1, 1);
      add(i, i + 1, -1);
    }
    add(0, 0, support);
  }
};

TEST(LinearSolver, TakesDoublePrecisionWhereSingleWillNotDo) {
  Chain matrix(1e-9); // of condition 1e14
  TimeSplit times;
  LinearSolver solver(matrix, nullptr, times);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(size);
  pull[size - 1] = 1;
  const Eigen::VectorXd x = solver.solve_anew(pull, 1e-10, 20);
  ASSERT_EQ(x.size(), size);
  EXPECT_NEAR(x[0], 1e9, 1e3);
  EXPECT_NEAR(x[size - 1] - x[0], size - 1, 0.01);
}

TEST(LinearSolver, FindsPivotsOffTheDiagonal) {
  SymmetricMatrix matrix(size, neighbours()); // [[0, 1], [1, 0]] over and over
  for (int i = 0; i < size; i += 2) matrix.add(i, i + 1, 1);
  TimeSplit times;
  LinearSolver solver(matrix, nullptr, times);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(size), x = solver.solve_anew(b, 1e-13, 20);
  ASSERT_EQ(x.size(), size);
  EXPECT_LT(residual(matrix, x, b), 1e-12);
}

TEST(LinearSolver, SaysThatASingularMatrixHasNoSolution) {
  Chain matrix(0);
  TimeSplit times;
  LinearSolver solver(matrix, nullptr, times);
  EXPECT_EQ(solver.solve_anew(Eigen::VectorXd::Constant(size, 1.0), 1e-10, 20).size(), 0);
}

} // namespace
} // namespace rimpact::fe
