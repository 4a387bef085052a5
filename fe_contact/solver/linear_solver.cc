#include "fe_contact/solver/linear_solver.h"

#include "fe_contact/solver/stopwatch.h"

namespace rimpact::fe {

bool LinearSolver::factorise() {
  const Stopwatch watch(times_["factor"]);
  if (!factor_) factor_ = mumps_factor(precision_, gmres_.pattern(), gmres_.by_all_ranks());
  factorised_ = factor_->factorise(gmres_.values());
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
  gmres_.take_values();
  return iterate(right_side, relative, max_iterations);
}

Eigen::VectorXd LinearSolver::solve_anew(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  last_iterations_ = 0;
  gmres_.take_values();
  Eigen::VectorXd result;
  if (factorise()) result = iterate(right_side, relative, max_iterations);
  if (result.size() > 0 || precision_ == Precision::double_) return result;
  precision_ = Precision::double_;
  factorised_ = false;
  factor_.reset();
  return factorise() ? iterate(right_side, relative, max_iterations) : Eigen::VectorXd();
}

} // namespace rimpact::fe
