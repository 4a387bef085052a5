#include "fe_contact/solver/linear_solver.h"

#include "fe_contact/solver/ranks.h"
#include "fe_contact/solver/stopwatch.h"

namespace rimpact::fe {

LinearSolver::LinearSolver(const SymmetricMatrix &symmetric, const GeneralMatrix *unsymmetric, TimeSplit &times)
    : symmetric_(symmetric), unsymmetric_(unsymmetric),
      gmres_(
          symmetric.n(), [this](const Eigen::VectorXd &x) { return multiply(x); },
          [this](const Eigen::VectorXd &x) { return factor_->solve(x); }),
      times_(times) {}

Eigen::VectorXd LinearSolver::multiply(const Eigen::VectorXd &x) const {
  Eigen::VectorXd result = symmetric_.multiply(x);
  if (unsymmetric_) unsymmetric_->add_product(x, result);
  ranks().all_reduce_sum(result);
  return result;
}

namespace {

/// Calls entry(row, column, value) for all that a rank hands in to a factor: the triangle, with its image where the
/// whole is not symmetric, and the unsymmetric part. What comes twice is summed up there.
template <class Entry>
void for_each_entry(const SymmetricMatrix &symmetric, const GeneralMatrix *unsymmetric, const Entry &entry) {
  const auto walk = [](const auto &matrix, const auto &each) {
    for (int row = 0; row < matrix.n(); ++row)
      for (int k = matrix.offsets()[row]; k < matrix.offsets()[row + 1]; ++k)
        each(row, matrix.columns()[k], matrix.values()[k]);
  };
  if (!unsymmetric) return walk(symmetric, entry);
  walk(symmetric, [&](int row, int column, double value) {
    entry(row, column, value);
    if (row != column) entry(column, row, value);
  });
  walk(*unsymmetric, entry);
}

} // namespace

bool LinearSolver::factorise() {
  const Stopwatch watch(times_["factor"]);
  if (!factor_) {
    MatrixPattern pattern{symmetric_.n(), !unsymmetric_, {}, {}};
    for_each_entry(symmetric_, unsymmetric_, [&](int row, int column, double) {
      pattern.rows.push_back(row);
      pattern.columns.push_back(column);
    });
    factor_ = mumps_factor(precision_, pattern);
  }
  values_.clear();
  for_each_entry(symmetric_, unsymmetric_, [&](int, int, double value) { values_.push_back(value); });
  factorised_ = factor_->factorise(values_.data());
  if (!factorised_) factor_.reset();
  return factorised_;
}

void LinearSolver::forget() {
  factorised_ = needs_refactorisation = false;
  if (precision_ == Precision::single_) return;
  precision_ = Precision::single_;
  factor_.reset();
}

Eigen::VectorXd LinearSolver::iterate(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  const Stopwatch watch(times_["solve"]);
  Eigen::VectorXd result = gmres_.solve(right_side, relative, max_iterations);
  last_iterations_ += gmres_.last_iterations();
  return result;
}

Eigen::VectorXd LinearSolver::solve(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  last_iterations_ = 0;
  if (!factorised_) return {};
  return iterate(right_side, relative, max_iterations);
}

Eigen::VectorXd LinearSolver::solve_anew(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  last_iterations_ = 0;
  Eigen::VectorXd result;
  if (factorise()) result = iterate(right_side, relative, max_iterations);
  if (result.size() > 0 || precision_ == Precision::double_) return result;
  precision_ = Precision::double_;
  factorised_ = false;
  factor_.reset();
  return factorise() ? iterate(right_side, relative, max_iterations) : Eigen::VectorXd();
}

} // namespace rimpact::fe
