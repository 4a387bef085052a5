/// Solves by MUMPS through PETSc: L D L^T of a symmetric indefinite matrix, L U of an unsymmetric one. Owns its KSP: a factor that has
/// become stale goes on as the preconditioner of GMRES and is renewed when the iterations become many. An unsymmetric
/// matrix is summed up and solved for by all ranks together, right sides and solutions being whole on each.
#pragma once
#include "fe_contact/solver/general_matrix.h"
#include <memory>

namespace rimpact::fe {

class DirectSolver {
public:
  /// Keeps a reference: the matrix's pattern must not change during the solver's life.
  explicit DirectSolver(SymmetricMatrix &matrix);
  explicit DirectSolver(GeneralMatrix &matrix);
  ~DirectSolver();
  /// Factorises the matrix's present values. False when MUMPS finds it singular or runs out of memory.
  bool factorise();
  /// Solves with the last factorisation, as if the matrix had not changed since.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side);
  /// Solves with the matrix's present values to a relative residual, by GMRES on the stale factor. Empty when
  /// that takes more than `max_iterations`; the factor is then due.
  Eigen::VectorXd solve_iteratively(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  int last_iterations() const { return last_iterations_; }
  bool has_factor() const { return has_factor_; }

private:
  void set_up(bool symmetric, int own_rows);
  void take_values(); ///< of the matrix as it stands
  Eigen::VectorXd solve_by_ksp(const Eigen::VectorXd &right_side);
  struct Petsc;
  struct Rows;
  std::unique_ptr<Petsc> petsc_;
  std::unique_ptr<Rows> rows_; ///< with several ranks only
  int last_iterations_ = 0;
  bool has_factor_ = false;
};

} // namespace rimpact::fe
