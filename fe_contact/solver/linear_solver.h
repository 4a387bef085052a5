/// Solves by flexible GMRES in double precision, preconditioned by a factor of the matrix as it was some iterations
/// ago, in single precision (see MumpsFactor): what a factor leaves, its age or its rounding, costs GMRES an iteration
/// or two. Where even a new factor in single precision will not do, it is made in double from then on.
#pragma once
#include "fe_contact/solver/flexible_gmres.h"
#include "fe_contact/solver/general_matrix.h"
#include "fe_contact/solver/mumps_factor.h"
#include "fe_contact/solver/symmetric_matrix.h"
#include <map>
#include <string>

namespace rimpact::fe {

using TimeSplit = std::map<std::string, double>; ///< [s]: search, assembly, factor, solve

class LinearSolver {
public:
  /// The matrix is the sum of both parts, and the sum over all ranks. Without an unsymmetric part (null) it is
  /// symmetric. Keeps references.
  LinearSolver(const SymmetricMatrix &symmetric, const GeneralMatrix *unsymmetric, TimeSplit &times);
  LinearSolver(const LinearSolver &) = delete; // GMRES calls this object
  LinearSolver &operator=(const LinearSolver &) = delete;
  /// Solves with the matrix's present values to a relative residual, on the factor at hand. Empty when that takes more
  /// than `max_iterations` or there is none; it is then due.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  /// The same with a factor of the present values. Empty when the matrix is singular.
  Eigen::VectorXd solve_anew(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  /// GMRES's for the last right side: 0 where no factor was at hand.
  int last_iterations() const { return last_iterations_; }
  /// Of the factor at hand; nil where there is none.
  FactorWork factor_work() const { return factorised_ ? factor_->work() : FactorWork{}; }
  /// Forgets the factor, as a new solver has none; what was found out about the pattern stays.
  void forget();
  /// The factor took GMRES many iterations when last used with a new right side of Newton's: it is to be renewed.
  bool needs_refactorisation = false;

private:
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const;
  bool factorise();
  Eigen::VectorXd iterate(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  const SymmetricMatrix &symmetric_;
  const GeneralMatrix *unsymmetric_;
  Precision precision_ = Precision::single_;
  std::unique_ptr<MumpsFactor> factor_; ///< null: none of this pattern yet
  std::vector<double> values_;          ///< kept for their memory
  bool factorised_ = false;
  int last_iterations_ = 0;
  FlexibleGmres gmres_;
  TimeSplit &times_;
};

} // namespace rimpact::fe
