/// Solves by flexible GMRES in double precision, preconditioned by a factor of the matrix as it was some iterations ago, in single precision
/// (see MumpsFactor): what a factor leaves, its age or its rounding, costs GMRES an iteration or two. Where even a new factor
/// in single precision will not do, it is made in double from then on. An unsymmetric matrix is summed up and solved for by
/// all ranks together, right sides and solutions being whole on each.
#pragma once
#include "fe_contact/solver/general_matrix.h"
#include "fe_contact/solver/mumps_factor.h"
#include <map>
#include <memory>
#include <string>

namespace rimpact::fe {

using TimeSplit = std::map<std::string, double>; ///< [s]: search, assembly, factor, solve

class DirectSolver {
public:
  /// Keeps references: the matrix's pattern must not change during the solver's life.
  DirectSolver(SymmetricMatrix &matrix, TimeSplit &times);
  DirectSolver(GeneralMatrix &matrix, TimeSplit &times);
  ~DirectSolver();
  /// Solves with the matrix's present values to a relative residual, on the factor at hand. Empty when that takes more than
  /// `max_iterations` or there is none; it is then due.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  /// The same with a factor of the present values. Empty when the matrix is singular.
  Eigen::VectorXd solve_anew(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  int last_iterations() const { return last_iterations_; }

private:
  void set_up(MatrixPattern pattern);
  void take_values(); ///< of the matrix as it stands
  bool factorise();
  Eigen::VectorXd iterate(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  struct Petsc;
  struct Rows;
  std::unique_ptr<Petsc> petsc_;
  std::unique_ptr<Rows> rows_; ///< with several ranks only
  const std::vector<double> &values_; ///< of this rank's entries
  TimeSplit &times_;
  int last_iterations_ = 0;
};

} // namespace rimpact::fe
